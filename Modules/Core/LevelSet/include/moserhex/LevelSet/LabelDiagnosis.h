#pragma once

#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace moserhex
{

/** The six borders of an image that a label touches, by image axis: first i, last i, first j, last j, first k, last k.
 */
struct ImageBorders
{
  std::array<bool, 6> touched{}; ///< by border, in this order

  /** Borders touched, 0 to 6. */
  [[nodiscard]] int
  count() const;

  /** Whether one of them is touched. */
  [[nodiscard]] bool
  any() const;

  /** "first i, last k"; empty when none is touched. */
  [[nodiscard]] std::string
  names() const;
};

/** \throws InvalidInput for an invalid or empty label. */
[[nodiscard]] ImageBorders
imageBordersTouched(const LabelVolume & label);

/** What a label is, as the voxels are: nothing is changed. Connectivity as in VoxelTopology.h. */
struct LabelDiagnosis
{
  std::size_t              voxels{ 0 };           ///< of the label
  double                   volume{ 0.0 };         ///< [mm^3]
  VoxelTopology            topology;              ///< of the whole label
  std::vector<std::size_t> componentVoxels;       ///< largest first
  std::size_t              cavityVoxels{ 0 };     ///< that filling the cavities would add
  VoxelTopology            largestComponent;      ///< with its cavities filled
  std::size_t              nonManifoldEdges{ 0 }; ///< two voxels meet in it, and no voxel that shares a face with both
  std::size_t  nonManifoldVertices{ 0 }; ///< off these edges: two opposite voxels of eight are alone on their side
  ImageBorders borders;                  ///< that the label touches
  std::array<int, 3> firstIndex{};       ///< of the bounding box
  std::array<int, 3> lastIndex{};        ///< of the bounding box
  double depth{ 0.0 }; ///< largest distance of a voxel centre from the nearest voxel face outside, about [mm]

  /** The label is one solid of genus 0 as it is. */
  [[nodiscard]] bool
  isBall() const
  {
    return topology.isBall();
  }
};

/** O(voxels of the bounding box). \throws InvalidInput for an invalid or empty label. */
[[nodiscard]] LabelDiagnosis
diagnoseLabel(const LabelVolume & label, unsigned int threads = 0);

} // namespace moserhex
