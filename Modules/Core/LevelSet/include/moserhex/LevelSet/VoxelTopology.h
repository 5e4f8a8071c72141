#pragma once

#include "moserhex/LevelSet/LabelVolume.h"

#include <cstddef>

namespace moserhex
{

/** Topology of a set of voxels with the convention of this library: inside voxels are joined by faces only
 * (6-connected), outside voxels also by edges and corners (26-connected).
 *
 * The inside is then the cubical complex with a vertex per voxel, an edge per pair of voxels that share a face, a
 * square per 2 x 2 x 1 and a cube per 2 x 2 x 2 block of voxels, which is homotopy equivalent to the interior of the
 * union of the voxels. Two voxels that meet in an edge or a corner only do not touch, so non-manifold edges of a mask
 * are no handles. (Joined by edges and corners, voxelised genus-0 surfaces get false handles wherever two folds come
 * close.) */
struct VoxelTopology
{
  std::size_t components{ 0 };          ///< 6-connected
  std::size_t cavities{ 0 };            ///< 26-connected parts of the outside that are closed in
  long        eulerCharacteristic{ 0 }; ///< vertices - edges + squares - cubes = components - handles + cavities

  /** Of all components and cavities together: components + cavities - Euler characteristic. */
  [[nodiscard]] long
  handles() const
  {
    return static_cast<long>(components) + static_cast<long>(cavities) - eulerCharacteristic;
  }

  /** V - E + F of the boundary surfaces: 2 for one ball, 0 for a solid torus. */
  [[nodiscard]] long
  surfaceEulerCharacteristic() const
  {
    return 2 * eulerCharacteristic;
  }

  /** One component without cavities and handles. */
  [[nodiscard]] bool
  isBall() const
  {
    return components == 1 && cavities == 0 && eulerCharacteristic == 1;
  }
};

/** O(voxels). Everything beyond the image counts as outside. \throws InvalidInput for an invalid or empty label. */
[[nodiscard]] VoxelTopology
voxelTopology(const LabelVolume & label);

/** What an operation on a label changed. */
struct VoxelChange
{
  std::size_t parts{ 0 };  ///< components or cavities changed
  std::size_t voxels{ 0 }; ///< voxels changed
};

/** Empties all 6-connected components but the largest (the first of them in voxel order when equal). */
VoxelChange
keepLargestComponentInPlace(LabelVolume & label);

/** Fills the parts of the outside that are not 26-connected to the outside of the image. */
VoxelChange
fillCavitiesInPlace(LabelVolume & label);

} // namespace moserhex
