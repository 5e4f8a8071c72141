#include "moserhex/LevelSet/VoxelTopology.h"

#include "VoxelParts.h"

#include <algorithm>

namespace moserhex
{
using detail::Adjacency;
using detail::connectedParts;
using detail::Parts;
using detail::Run;
namespace
{

/** vertices - edges + squares - cubes of the complex of voxels joined by faces; the label has an empty margin of one
 * voxel. Each cell is counted at its voxel of smallest index. */
long
faceConnectedEulerCharacteristic(const LabelVolume & padded)
{
  const auto        along = [&](int di, int dj, int dk) { return padded.voxelNumber(di, dj, dk); };
  const std::size_t x = along(1, 0, 0);
  const std::size_t y = along(0, 1, 0);
  const std::size_t z = along(0, 0, 1);
  const auto &      in = padded.inside;
  long              euler = 0;
  for (std::size_t v = 0; v + x + y + z < in.size(); ++v)
  {
    if (in[v] == 0)
    {
      continue;
    }
    const bool hasX = in[v + x] != 0;
    const bool hasY = in[v + y] != 0;
    const bool hasZ = in[v + z] != 0;
    const bool squareXY = hasX && hasY && in[v + x + y] != 0;
    const bool squareYZ = hasY && hasZ && in[v + y + z] != 0;
    const bool squareXZ = hasX && hasZ && in[v + x + z] != 0;
    const bool cube = squareXY && squareYZ && squareXZ && in[v + x + y + z] != 0;
    euler += 1 - (hasX + hasY + hasZ) + (squareXY + squareYZ + squareXZ) - (cube ? 1 : 0);
  }
  return euler;
}

} // namespace

VoxelTopology
voxelTopology(const LabelVolume & label)
{
  requireValid(label, "voxel topology");
  const LabelVolume padded = cropAndPad(label, { { 1, 1, 1 } });
  VoxelTopology     topology;
  topology.components = connectedParts(padded, true, Adjacency::Faces).voxels.size();
  topology.cavities = connectedParts(padded, false, Adjacency::FacesEdgesAndCorners).voxels.size() - 1;
  topology.eulerCharacteristic = faceConnectedEulerCharacteristic(padded);
  return topology;
}

VoxelChange
keepLargestComponentInPlace(LabelVolume & label)
{
  requireValid(label, "largest component");
  const Parts parts = connectedParts(label, true, Adjacency::Faces);
  const auto  largest =
    static_cast<std::int32_t>(std::max_element(parts.voxels.begin(), parts.voxels.end()) - parts.voxels.begin());
  VoxelChange change{ parts.voxels.size() - 1, 0 };
  for (const Run & run : parts.runs)
  {
    if (run.part != largest)
    {
      change.voxels += run.end - run.begin;
      std::fill(label.inside.begin() + static_cast<std::ptrdiff_t>(run.begin),
                label.inside.begin() + static_cast<std::ptrdiff_t>(run.end),
                std::uint8_t{ 0 });
    }
  }
  return change;
}

VoxelChange
fillCavitiesInPlace(LabelVolume & label)
{
  requireValid(label, "cavities");
  const Parts                     parts = connectedParts(label, false, Adjacency::FacesEdgesAndCorners);
  const std::vector<std::uint8_t> open = detail::partsAtBorder(label, parts);
  VoxelChange                     change;
  change.parts = static_cast<std::size_t>(std::count(open.begin(), open.end(), std::uint8_t{ 0 }));
  for (const Run & run : parts.runs)
  {
    if (open[static_cast<std::size_t>(run.part)] == 0)
    {
      change.voxels += run.end - run.begin;
      std::fill(label.inside.begin() + static_cast<std::ptrdiff_t>(run.begin),
                label.inside.begin() + static_cast<std::ptrdiff_t>(run.end),
                std::uint8_t{ 1 });
    }
  }
  return change;
}

} // namespace moserhex
