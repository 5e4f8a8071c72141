#include "moserhex/CubeTransfer/CubeMap.h"

#include "CellBoxTree.h"
#include "TrilinearCell.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr double      relativeTolerance = 1e-12; ///< of a cell's diagonal
constexpr std::size_t pointsPerBlock = 256;

/** A few units in the last place of the largest coordinate. */
double
roundingOf(const HexMesh & mesh)
{
  double largest = 0.0;
  for (const Vector3 & node : mesh.nodes)
  {
    largest = std::max(largest, node.cwiseAbs().maxCoeff());
  }
  return 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

struct CornerBox
{
  Vector3 lower;
  Vector3 upper;

  explicit CornerBox(const HexCorners & corners) : lower(corners[0]), upper(corners[0])
  {
    for (const Vector3 & corner : corners)
    {
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
  }
  [[nodiscard]] bool
  holds(const Vector3 & p, double slack) const
  {
    return (p.array() >= lower.array() - slack).all() && (p.array() <= upper.array() + slack).all();
  }
};

double
toleranceOf(const CornerBox & box, double rounding)
{
  return relativeTolerance * (box.upper - box.lower).norm() + rounding;
}

/** The largest tolerance of a cell. */
double
slackOf(const HexMesh & mesh, double rounding)
{
  double largest = 0.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    largest = std::max(largest, toleranceOf(CornerBox(cellCorners(mesh, cell)), rounding));
  }
  return largest;
}

const HexMesh &
valid(const HexMesh & mesh)
{
  requireLattice(mesh);
  return mesh;
}

} // namespace

CubeMap::CubeMap(const HexMesh & mesh)
  : m_Mesh(valid(mesh))
  , m_Rounding(roundingOf(mesh))
  , m_Tree(std::make_unique<CellBoxTree>(mesh, slackOf(mesh, m_Rounding)))
{}

CubeMap::~CubeMap() = default;

std::optional<CubePlace>
CubeMap::find(const Vector3 & p) const
{
  std::vector<std::size_t> candidates;
  return find(p, candidates);
}

std::optional<CubePlace>
CubeMap::find(const Vector3 & p, std::vector<std::size_t> & candidates) const
{
  if (!p.allFinite())
  {
    return std::nullopt;
  }
  m_Tree->cellsNear(p, candidates);
  for (const std::size_t cell : candidates)
  {
    const HexCorners corners = cellCorners(m_Mesh, cell);
    const CornerBox  box(corners);
    const double     tolerance = toleranceOf(box, m_Rounding);
    if (!box.holds(p, tolerance))
    {
      continue;
    }
    if (const auto local = trilinearInverse(corners, p, tolerance))
    {
      return CubePlace{ cell, *local };
    }
  }
  return std::nullopt;
}

std::vector<std::optional<CubePlace>>
CubeMap::find(const Positions & points, unsigned int threads) const
{
  std::vector<std::optional<CubePlace>> places(points.size());
  parallelForBlocks(points.size(), pointsPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> candidates;
    for (std::size_t point = begin; point < end; ++point)
    {
      places[point] = find(points[point], candidates);
    }
  });
  return places;
}

Vector3
CubeMap::cubeCoordinates(const CubePlace & place) const
{
  const auto        m = static_cast<std::size_t>(m_Mesh.nodesPerSide - 1);
  const std::size_t index[3] = { place.cell % m, place.cell / m % m, place.cell / (m * m) };
  Vector3           coordinates;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    coordinates[axis] = (static_cast<double>(index[axis]) + place.local[axis]) / static_cast<double>(m);
  }
  return coordinates;
}

CubePlace
CubeMap::place(const Vector3 & cubeCoordinates) const
{
  if (!(cubeCoordinates.minCoeff() >= 0.0 && cubeCoordinates.maxCoeff() <= 1.0 && cubeCoordinates.allFinite()))
  {
    std::ostringstream text;
    text << "cube coordinates (" << cubeCoordinates.transpose() << ") are outside [0,1]^3";
    throw InvalidInput(text.str());
  }
  const auto  m = static_cast<std::size_t>(m_Mesh.nodesPerSide - 1);
  std::size_t index[3];
  CubePlace   result;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double along = cubeCoordinates[axis] * static_cast<double>(m);
    const double first = std::max(std::ceil(along) - 1.0, 0.0);
    index[axis] = static_cast<std::size_t>(first);
    result.local[axis] = along - first;
  }
  result.cell = index[0] + m * (index[1] + m * index[2]);
  return result;
}

Vector3
CubeMap::position(const CubePlace & place) const
{
  return trilinear(cellCorners(m_Mesh, place.cell), place.local);
}

} // namespace moserhex
