#include "moserhex/LevelSet/CoarseSolid.h"

#include "TopologyProtection.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/HomotopicGrowth.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

/** Coarse nodes around the solid: what splines and local grids around shells reach. */
constexpr double marginInNodes = 3.0;
/** A grid that is not coarser than this is not worth it [spacings of phi]. */
constexpr double smallestGain = 1.15;
/** Around the zero level all levels are spheres [spacings]. */
constexpr double sphericalBand = 0.5;

void
requireUsable(const LevelSet & phi, double volume, const CoarseSolidOptions & options)
{
  requireValid(phi, "coarse solid");
  std::ostringstream message;
  const auto         isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!isPositive(volume))
  {
    message << "coarse solid: volume = " << volume << " mm^3, need > 0 and finite";
  }
  else if (!isPositive(options.nodesPerSide) || !isPositive(options.nodesAcrossThickness) ||
           !(options.refinement > 0.0 && options.refinement < 1.0) || !isPositive(options.acceptedVolumeChange))
  {
    message << "coarse solid: nodesPerSide = " << options.nodesPerSide
            << " (need > 0 and finite), nodesAcrossThickness = " << options.nodesAcrossThickness
            << " (need > 0 and finite), refinement = " << options.refinement
            << " (need (0,1)), acceptedVolumeChange = " << options.acceptedVolumeChange << " (need > 0 and finite)";
  }
  if (!message.str().empty())
  {
    throw InvalidInput(message.str());
  }
}

/** Where the solid is, and how much surface it has. */
struct Extent
{
  RegularGrid::Index lower;
  RegularGrid::Index upper;
  double             faceArea{ 0.0 }; ///< of the faces between nodes inside and outside [mm^2]

  /** Nodes along the longest side. */
  [[nodiscard]] int
  longest() const
  {
    return std::max({ upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2] }) + 1;
  }
};

Extent
extentOf(const LevelSet & phi)
{
  const RegularGrid & grid = phi.grid;
  Extent              extent{ grid.size, { { -1, -1, -1 } }, 0.0 };
  std::size_t         faces = 0;
  std::size_t         node = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i, ++node)
      {
        if (!(phi.values[node] < 0.0))
        {
          continue;
        }
        const RegularGrid::Index index{ { i, j, k } };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          extent.lower[axis] = std::min(extent.lower[axis], index[axis]);
          extent.upper[axis] = std::max(extent.upper[axis], index[axis]);
          const auto stride = static_cast<std::size_t>(grid.stride(axis == 0, axis == 1, axis == 2));
          faces += index[axis] == 0 || !(phi.values[node - stride] < 0.0) ? 1 : 0;
          faces += index[axis] == grid.size[axis] - 1 || !(phi.values[node + stride] < 0.0) ? 1 : 0;
        }
      }
    }
  }
  if (faces == 0)
  {
    throw InvalidInput("coarse solid: 0 nodes inside, need at least 1");
  }
  extent.faceArea = static_cast<double>(faces) * grid.spacing * grid.spacing;
  return extent;
}

LevelSet
resampled(const LevelSet & phi, const Extent & extent, double spacing)
{
  const RegularGrid &     grid = phi.grid;
  const CubicInterpolator interpolator(phi);
  LevelSet                coarse{ grid, {} };
  coarse.grid.spacing = spacing;
  Vector3 first; // coarse node (0,0,0) and the other end of the grid of phi [nodes of phi]
  Vector3 end;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int    a = static_cast<int>(axis);
    const double nodes = (extent.upper[axis] - extent.lower[axis]) * grid.spacing / spacing + 2.0 * marginInNodes;
    coarse.grid.size[axis] = static_cast<int>(std::ceil(nodes)) + 1;
    first[a] =
      0.5 * (extent.lower[axis] + extent.upper[axis]) - 0.5 * (coarse.grid.size[axis] - 1) * spacing / grid.spacing;
    end[a] = grid.size[axis] - 1;
  }
  coarse.grid.origin = grid.origin + grid.direction * (grid.spacing * first);
  coarse.values.resize(coarse.grid.nodeCount());
  for (std::size_t node = 0; node < coarse.values.size(); ++node)
  {
    const RegularGrid::Index i = coarse.grid.indexOf(node);
    const Vector3            index = first + Vector3(i[0], i[1], i[2]) * (spacing / grid.spacing);
    const Vector3            nearest = index.cwiseMax(Vector3::Zero()).cwiseMin(end);
    coarse.values[node] = interpolator.value(grid.origin + grid.direction * (grid.spacing * nearest)) +
                          grid.spacing * (index - nearest).norm();
  }
  return coarse;
}

/** {phi < 0} can be grown from its deepest node by simple nodes. */
bool
isBall(const LevelSet & phi)
{
  const auto count = std::count_if(phi.values.begin(), phi.values.end(), [](double value) { return value < 0.0; });
  if (count == 0)
  {
    return false;
  }
  HomotopicGrowthOptions options;
  options.stopAbove = -std::numeric_limits<double>::min();
  return homotopicGrowth(phi, detail::deepestNode(phi), options).added == static_cast<std::size_t>(count);
}

} // namespace

CoarseSolid
coarseSolid(const LevelSet & phi, double volume, const CoarseSolidOptions & options)
{
  requireUsable(phi, volume, options);
  const Extent extent = extentOf(phi);
  double       spacing = std::min({ std::cbrt(volume) / options.nodesPerSide,
                                    2.0 * volume / extent.faceArea / options.nodesAcrossThickness,
                                    extent.longest() * phi.grid.spacing }); // whatever the volume
  CoarseSolid  solid;
  for (; spacing > smallestGain * phi.grid.spacing; spacing *= options.refinement, ++solid.refinements)
  {
    solid.levelSet = resampled(phi, extent, spacing);
    if (!isBall(solid.levelSet))
    {
      continue;
    }
    detail::makeLevelsSphericalInPlace(solid.levelSet, sphericalBand * spacing);
    const double change = VolumeBelowLevel(solid.levelSet).volume(0.0) / volume - 1.0;
    if (std::abs(change) <= options.acceptedVolumeChange)
    {
      return solid;
    }
  }
  solid.levelSet = phi;
  return solid;
}

std::string
describe(const CoarseSolid & solid)
{
  const RegularGrid::Index & size = solid.levelSet.grid.size;
  std::ostringstream         text;
  text << size[0] << " x " << size[1] << " x " << size[2] << " nodes";
  if (solid.refinements > 0)
  {
    text << ", refined " << solid.refinements << " times to keep the solid";
  }
  return text.str();
}

} // namespace moserhex
