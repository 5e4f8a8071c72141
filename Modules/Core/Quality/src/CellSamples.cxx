#include "CellSamples.h"

#include <cmath>

namespace moserhex::detail
{

std::vector<CellSample>
cellSamples(int samplesPerSide)
{
  constexpr int           reference[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                              { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  std::vector<CellSample> samples;
  for (int number = 0; number < samplesPerSide * samplesPerSide * samplesPerSide; ++number)
  {
    const std::array<int, 3> step{
      { number % samplesPerSide, number / samplesPerSide % samplesPerSide, number / samplesPerSide / samplesPerSide }
    };
    CellSample sample;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      std::array<double, 3> factor{};
      std::array<double, 3> sign{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double t = (step[axis] + 0.5) / samplesPerSide;
        factor[axis] = reference[corner][axis] == 1 ? t : 1.0 - t;
        sign[axis] = reference[corner][axis] == 1 ? 1.0 : -1.0;
      }
      sample.weight[corner] = factor[0] * factor[1] * factor[2];
      sample.gradient[corner] =
        Vector3(sign[0] * factor[1] * factor[2], factor[0] * sign[1] * factor[2], factor[0] * factor[1] * sign[2]);
    }
    samples.push_back(sample);
  }
  return samples;
}

std::optional<std::size_t>
nearestVoxel(const VoxelGrid & grid, const Vector3 & voxel)
{
  std::array<int, 3> index{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double nearest = std::nearbyint(voxel[static_cast<Eigen::Index>(axis)]);
    if (!(nearest >= 0.0 && nearest < grid.size[axis]))
    {
      return std::nullopt;
    }
    index[axis] = static_cast<int>(nearest);
  }
  return grid.voxelNumber(index[0], index[1], index[2]);
}

} // namespace moserhex::detail
