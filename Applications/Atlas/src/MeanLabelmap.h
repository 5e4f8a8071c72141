#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/LevelSet/LabelVolume.h"

namespace moserhex::app
{

/** The voxels whose centres lie in a mesh (CubeMap::find), on axes of LPS, with two empty voxels around its box.
 * \param spacing  voxel side, > 0 [mm]
 * \throws InvalidInput  as CubeMap, or more than 1024 voxels along an axis */
[[nodiscard]] LabelVolume
voxelised(const HexMesh & mesh, double spacing, unsigned int threads);

} // namespace moserhex::app
