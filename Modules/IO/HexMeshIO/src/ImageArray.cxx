#include "moserhex/HexMeshIO/ImageArray.h"

#include "ImageGrid.h"
#include "ImageHeader.h"
#include "LabelVoxels.h"

#include <algorithm>

namespace moserhex
{
namespace
{

ImageDescription
describe(const ArrayHeader & header, ComponentType type, std::uint64_t layers = 1)
{
  ImageDescription image;
  image.fileName = header.name;
  if (std::find(header.size.begin(), header.size.end(), 0u) != header.size.end())
  {
    throw BadInput(ErrorCode::Empty, header.name, "an array without voxels", "give one with at least one label");
  }
  setVoxels(image, { header.size.begin(), header.size.end() }, type, layers);
  setGeometry(image, header.columns, header.origin);
  return image;
}

void
requireFitting(const ImageDescription & image, std::size_t values)
{
  if (values != image.grid.gridVoxels() * static_cast<std::size_t>(image.layers))
  {
    throw InvalidInput(image.fileName + ": " + std::to_string(values) + " values for " +
                       std::to_string(image.grid.gridVoxels()) + " voxels of " + std::to_string(image.layers));
  }
}

template <typename TVoxel>
constexpr ComponentType
componentOf()
{
  if constexpr (std::is_floating_point_v<TVoxel>)
  {
    return sizeof(TVoxel) == 4 ? ComponentType::Float32 : ComponentType::Float64;
  }
  else
  {
    constexpr ComponentType types[2][4] = {
      { ComponentType::UInt8, ComponentType::UInt16, ComponentType::UInt32, ComponentType::UInt64 },
      { ComponentType::Int8, ComponentType::Int16, ComponentType::Int32, ComponentType::Int64 }
    };
    return types[std::is_signed_v<TVoxel> ? 1 : 0][sizeof(TVoxel) == 8 ? 3 : sizeof(TVoxel) / 2];
  }
}

} // namespace

void
requireValid(const ArrayHeader & header)
{
  (void)describe(header, ComponentType::UInt8);
}

VoxelGrid
voxelGridFrom(const ArrayHeader & header)
{
  return describe(header, ComponentType::UInt8).grid;
}

template <typename TVoxel>
LabelImage
labelImageFrom(const ArrayHeader & header, const std::vector<TVoxel> & voxels)
{
  ImageDescription image = describe(header, componentOf<TVoxel>());
  requireFitting(image, voxels.size());
  const LabelRules              rules;
  const auto                    counts = countLabels(image, voxels, rules);
  const std::vector<LabelEntry> entries = labelEntries(image, counts.front(), rules, {});
  const LabelMaker<TVoxel>      labelOf(rules.threshold);
  LabelImage result{ header.name, imageOnGrid<LabelImageType>(image.grid), entries, image.warnings, {} };
  std::transform(voxels.begin(), voxels.end(), result.image->GetBufferPointer(), labelOf);
  return result;
}

template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::int8_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::uint8_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::int16_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::uint16_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::int32_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::uint32_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::int64_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<std::uint64_t> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<float> &);
template LabelImage
labelImageFrom(const ArrayHeader &, const std::vector<double> &);

ScalarImage
scalarImageFrom(const ArrayHeader & header, const std::vector<double> & values)
{
  const ImageDescription image = describe(header, ComponentType::Float64);
  requireFitting(image, values.size());
  ScalarImage result{ header.name, imageOnGrid<ScalarImageType>(image.grid), image.warnings };
  std::copy(values.begin(), values.end(), result.image->GetBufferPointer());
  return result;
}

FieldImage
fieldImageFrom(const ArrayHeader & header, int components, std::vector<double> values)
{
  if (components < 1 || static_cast<std::uint64_t>(components) > mostValuesPerVoxel)
  {
    throw BadInput(ErrorCode::PixelType,
                   header.name,
                   std::to_string(components) + " values per voxel, need 1 to " + std::to_string(mostValuesPerVoxel),
                   "give fewer");
  }
  const ImageDescription image = describe(header, ComponentType::Float64, static_cast<std::uint64_t>(components));
  requireFitting(image, values.size());
  FieldImage result;
  result.fileName = header.name;
  result.volume = FieldVolume{ image.grid, components, std::move(values) };
  result.warnings = image.warnings;
  result.gridWarnings = image.warnings;
  return result;
}

} // namespace moserhex
