#include "moserhex/Quality/LabelAgreement.h"

#include "CellSamples.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace moserhex
{
namespace
{

constexpr int samplesPerSide = 5;

bool
isInside(const LabelVolume & label, const Vector3 & voxel)
{
  const std::optional<std::size_t> nearest = detail::nearestVoxel(label, voxel);
  return nearest && label.inside[*nearest] != 0;
}

/** Volume of a cell and of its part in the label, by the samples [mm^3]. */
struct CellVolumes
{
  double whole{ 0.0 };
  double inLabel{ 0.0 };
};

CellVolumes
sampleCell(const HexCorners &                      corners,
           const std::vector<detail::CellSample> & samples,
           const LabelVolume &                     label,
           const detail::VoxelCoordinates &        coordinates)
{
  std::array<Vector3, 8> voxels;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    voxels[corner] = coordinates.of(corners[corner]);
  }
  CellVolumes volumes;
  for (const detail::CellSample & sample : samples)
  {
    Matrix3 jacobian = Matrix3::Zero();
    Vector3 voxel = Vector3::Zero();
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      jacobian += corners[corner] * sample.gradient[corner].transpose();
      voxel += sample.weight[corner] * voxels[corner];
    }
    const double volume =
      std::abs(jacobian.col(0).dot(jacobian.col(1).cross(jacobian.col(2)))) / static_cast<double>(samples.size());
    volumes.whole += volume;
    volumes.inLabel += isInside(label, voxel) ? volume : 0.0;
  }
  return volumes;
}

CellVolumes
sampleMesh(const UnstructuredHexMesh & mesh, const LabelVolume & label, unsigned int threads)
{
  const std::vector<detail::CellSample> samples = detail::cellSamples(samplesPerSide);
  const detail::VoxelCoordinates        coordinates(label);
  std::vector<CellVolumes>              cells(mesh.cellCount());
  parallelForBlocks(cells.size(), 64, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      cells[cell] = sampleCell(cellCorners(mesh, cell), samples, label, coordinates);
    }
  });
  CellVolumes sum;
  for (const CellVolumes & cell : cells)
  {
    sum.whole += cell.whole;
    sum.inLabel += cell.inLabel;
  }
  return sum;
}

/** Distance to the voxel surface, linear between voxel centres; points beyond the voxels take the value at the nearest
 * place of their box and add the way to it. */
class VoxelSurfaceDistance
{
public:
  explicit VoxelSurfaceDistance(const LabelVolume & label)
    : m_Label(cropAndPad(label, { { 4, 4, 4 } }))
    , m_Coordinates(m_Label)
    , m_Values(voxelSignedDistance(m_Label, { { true, true, true } }))
  {}

  [[nodiscard]] double
  at(const Vector3 & point) const
  {
    const Vector3         voxel = m_Coordinates.of(point);
    std::array<int, 3>    below{};
    std::array<double, 3> part{};
    Vector3               way = Vector3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto   component = static_cast<Eigen::Index>(axis);
      const double last = m_Label.size[axis] - 1;
      const double position = std::clamp(voxel[component], 0.0, last);
      way[component] = (voxel[component] - position) * m_Label.spacing[component];
      below[axis] = std::min(static_cast<int>(position), m_Label.size[axis] - 2);
      part[axis] = position - below[axis];
    }
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::array<int, 3> step{ { corner & 1, corner >> 1 & 1, corner >> 2 & 1 } };
      double                   weight = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        weight *= step[axis] == 1 ? part[axis] : 1.0 - part[axis];
      }
      value += weight * m_Values[m_Label.voxelNumber(below[0] + step[0], below[1] + step[1], below[2] + step[2])];
    }
    return std::abs(value) + way.norm();
  }

private:
  LabelVolume              m_Label;
  detail::VoxelCoordinates m_Coordinates;
  std::vector<double>      m_Values;
};

} // namespace

LabelAgreement
compareWithLabel(const UnstructuredHexMesh & mesh, const LabelVolume & label, unsigned int threads)
{
  requireValid(mesh);
  requireValid(label, "comparison with a label");
  const auto faces = boundaryFaces(mesh);
  if (faces.empty())
  {
    throw InvalidInput("hexahedral mesh without a boundary");
  }

  LabelAgreement agreement;
  agreement.labelVolume = static_cast<double>(voxelCount(label)) * label.voxelVolume();
  double meshVolume = 0.0;
  for (const double volume : cellVolumes(mesh))
  {
    meshVolume += volume;
  }
  agreement.volumeError = meshVolume / agreement.labelVolume - 1.0;
  const CellVolumes sampled = sampleMesh(mesh, label, threads);
  agreement.dice = 2.0 * sampled.inLabel / (sampled.whole + agreement.labelVolume);

  const VoxelSurfaceDistance distance(label);
  std::vector<double>        atNodes;
  std::vector<double>        atCentres;
  std::vector<bool>          seen(mesh.nodes.size(), false);
  for (const Quadrilateral & face : faces)
  {
    Vector3 centre = Vector3::Zero();
    for (const std::size_t node : face)
    {
      centre += 0.25 * mesh.nodes[node];
      if (!seen[node])
      {
        seen[node] = true;
        atNodes.push_back(distance.at(mesh.nodes[node]));
      }
    }
    atCentres.push_back(distance.at(centre));
  }
  agreement.boundaryNodes = distributionOf(std::move(atNodes));
  agreement.faceCentres = distributionOf(std::move(atCentres));
  return agreement;
}

} // namespace moserhex
