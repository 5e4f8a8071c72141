#pragma once

#include "NrrdHeader.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

using SpaceVector = std::optional<std::vector<double>>;

/** "(a,b,c) none (d,e,f)". \throws BadInput (Header) */
[[nodiscard]] std::vector<SpaceVector>
spaceVectorsOf(const std::string & file, const std::string & field, const std::string & text);

/** How the axes of the file are used. */
struct NrrdAxes
{
  std::vector<std::uint64_t> sizes;
  std::vector<std::string>   kinds;      ///< lower case; "" unknown
  std::vector<SpaceVector>   directions; ///< empty without the field
  std::vector<std::size_t>   spatial;    ///< the three axes
  std::uint64_t              layers{ 1 };
  ValueLayout                layout;
  bool                       symmetricTensors{ false };
};

/** Sorts the axes into three of space and those of layers or values.
 * \throws BadInput (Header)  other than one size, kind and direction for each axis, another size than a kind has;
 * (Dimension, PixelType, Geometry)  not three axes of space, or more values per voxel than `content` allows */
[[nodiscard]] NrrdAxes
nrrdAxes(const NrrdHeader & header, const ImageDescription & image, VoxelContent content);

} // namespace moserhex
