#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/LevelSet/LabelVolume.h"

namespace moserhex
{

/** Options of voxelise. */
struct SurfaceVoxelisationOptions
{
  double      spacing{ 0.0 };     ///< edge of a voxel [mm]; 0: so that the surface's box holds about `voxelsInBox`
  double      voxelsInBox{ 1e6 }; ///< used when spacing is 0 [1]
  int         margin{ 3 };        ///< empty voxels around the surface's box [1]
  std::size_t maximumVoxels{ 50'000'000 }; ///< larger grids are refused [1]
};

/** The voxels whose centres lie inside a closed surface, on an isotropic grid aligned with the LPS axes.
 *
 * Inside means non-zero winding number, counted along one ray per grid line in the direction +x. Rays through vertices
 * and edges need no special case: a triangle is hit when lowest <= z < highest and, on that plane, when the line lies
 * in the half-open interval between the triangle's two cut edges. Whether an edge is cut is decided by comparison
 * alone and where, by the same arithmetic for both its triangles, so the signed hits of every line sum to zero on any
 * closed surface, whatever the rounding.
 *
 * \param surface  closed, oriented outwards; self-intersection is allowed (non-zero winding)
 * \throws InvalidInput  the surface is empty or the grid would exceed maximumVoxels, or spacing < 0
 * \note O(triangles x lines crossed). Deterministic. */
[[nodiscard]] LabelVolume
voxelise(const TriangleMesh & surface, const SurfaceVoxelisationOptions & options = {});

} // namespace moserhex
