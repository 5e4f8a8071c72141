#pragma once

#include "moserhex/CubeTransfer/CubePoint.h"
#include "moserhex/LevelSet/FieldVolume.h"

namespace moserhex
{

/** Options of gridSamples. */
struct GridSamplesOptions
{
  double       background{ 0.0 }; ///< of voxels whose centre is not in the mesh
  unsigned int threads{ 0 };      ///< 0: all of the machine's
};

/** What gridSamples made. */
struct GridSamples
{
  FieldVolume image;       ///< the values, on the grid asked for
  std::size_t inside{ 0 }; ///< voxels whose centre is in the mesh
};

/** A function of the cube on a grid of voxels: at every voxel centre in the mesh its value there (CubeMap::find), in
 * exactly one cell. The same for any number of threads.
 * \param map  of `mesh` \param f  called by several threads at once
 * \throws InvalidInput  an invalid grid, or what f throws */
[[nodiscard]] GridSamples
gridSamples(const CubeMap &            map,
            const HexMesh &            mesh,
            const CubeFunction &       f,
            int                        components,
            const VoxelGrid &          grid,
            const GridSamplesOptions & options = {});

} // namespace moserhex
