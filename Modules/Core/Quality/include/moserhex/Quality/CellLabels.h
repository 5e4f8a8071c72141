#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <cstdint>
#include <vector>

namespace moserhex
{

/** Labels of a whole image, one per voxel; 0 is no label. */
struct LabelValues : VoxelGrid
{
  std::vector<std::int32_t> values; ///< in the order of the voxel numbers
};

/** The label that most of each cell lies in.
 *
 * Every cell is sampled at 3 x 3 x 3 points, the middles of equal parts of the reference cube; each counts for the
 * label of the nearest voxel. The commonest label other than 0 wins, of equally common ones the smallest; 0 when no
 * point lies in a label.
 *
 * \param threads  as in parallelFor; the result does not depend on it
 * \return         (n-1)^3 labels in the order of the cells
 * \throws InvalidInput  as requireValid(mesh) and requireValid(grid), or not one value per voxel */
[[nodiscard]] std::vector<std::int32_t>
labelsOfCells(const HexMesh & mesh, const LabelValues & labels, unsigned int threads = 1);

} // namespace moserhex
