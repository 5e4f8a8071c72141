#pragma once

#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/Quality/HexQuality.h"

namespace moserhex
{

/** How well a mesh fills the label it was made from, measured on the voxels as they are: nothing that made the mesh
 * takes part. */
struct LabelAgreement
{
  double       labelVolume{ 0.0 }; ///< voxels x volume of a voxel [mm^3]
  double       volumeError{ 0.0 }; ///< mesh volume / label volume - 1 [1]
  double       dice{ 0.0 };        ///< 2 |mesh and label| / (|mesh| + |label|) [1]
  Distribution boundaryNodes;      ///< |distance| of boundary nodes to the label's voxel surface [mm]
  Distribution faceCentres;        ///< |distance| of the centres of boundary faces, the mean of their corners [mm]
};

/** Compares a mesh with a label.
 *
 * Dice: every cell is sampled at 5 x 5 x 5 points (the middles of equal parts of the reference cube), weighted with
 * |det J|; a point is in the label when the voxel nearest to it is. The error of the sampling is about one part of
 * the cells the surface cuts: 1e-3 for a lattice of 20 nodes a side.
 *
 * Distance: voxelSignedDistance along all three axes (exact between voxel centres, half of the smallest voxel side
 * off), linear between voxel centres; beyond 4 voxels around the label's box the way to these is added, which is never
 * less than the distance. Terraces between thick slices count as surface, so a smooth mesh of a label of 3 mm slices is
 * about 1 mm off here and there.
 *
 * \param threads  as in parallelFor; the result does not depend on it
 * \throws InvalidInput  as requireValid(mesh) and requireValid(label), or the mesh has no boundary */
[[nodiscard]] LabelAgreement
compareWithLabel(const UnstructuredHexMesh & mesh, const LabelVolume & label, unsigned int threads = 1);

} // namespace moserhex
