#pragma once

#include "MeshCut.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A box along the patient's axes [mm]. */
struct Box
{
  Vector3 low{ Vector3::Zero() };
  Vector3 high{ Vector3::Zero() };
};

/** Where the voxels of some labels are, their corners included. \return empty where there is none */
[[nodiscard]] std::optional<Box>
boxOfLabels(const LabelImageType & image, const std::vector<LabelValue> & labels);

/** A labelmap in a plane: squares of one side, each the label of the nearest voxel. */
struct LabelSlice
{
  double                  step{ 1.0 };            ///< side of a square [mm]
  PlanePoint              corner{ { 0.0, 0.0 } }; ///< of the first square [mm]
  std::array<int, 2>      size{ { 0, 0 } };
  std::vector<LabelValue> values; ///< first coordinate fastest; 0 is none of the labels

  [[nodiscard]] LabelValue
  at(int a, int b) const
  {
    return values[static_cast<std::size_t>(a) + static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(b)];
  }
};

/** Samples the plane over a box at half of the smallest voxel side, but at most 320 squares along a side. */
[[nodiscard]] LabelSlice
sliceLabels(const LabelImageType &          image,
            const std::vector<LabelValue> & labels,
            const Box &                     box,
            const CutPlane &                plane);

} // namespace moserhex::app
