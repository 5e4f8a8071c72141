#pragma once

#include "LabelShares.h"
#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubePoint.h"

namespace moserhex::app
{

/** Brings what is in the cube onto a grid of voxels in the space of a subject, and tells what was lost. Keeps
 * references: the arguments must outlive the object. */
class GridTarget
{
public:
  GridTarget(const HexMesh & mesh, const VoxelGrid & grid, const TransferOptions & options, const TransferLog & log);

  /** A function of the cube on the voxels. \param background  of voxels beyond the mesh
   * \throws BadInput (Geometry)  no voxel lies in the mesh */
  [[nodiscard]] FieldVolume
  samples(const CubeFunction & f, int components, double background) const;

  /** Labels on the voxels. \param labelAt  sets the label of a place \param labels  that are reported
   * \param before  volumes in the organ that they come from; none: nothing is reported
   * \throws as samples */
  [[nodiscard]] FieldVolume
  labels(const CubeFunction & labelAt, const std::vector<LabelEntry> & labels, const LabelAmounts & before) const;

  /** Masses of the cube's boxes over the volumes of the voxels that they reach; tells what of each component lies
   * beyond. \throws BadInput (Geometry)  none reaches a voxel */
  [[nodiscard]] FieldVolume
  densities(const FieldVolume & masses) const;

private:
  const HexMesh &         m_Mesh;
  const VoxelGrid &       m_Grid;
  const TransferOptions & m_Options;
  const TransferLog &     m_Log;
};

} // namespace moserhex::app
