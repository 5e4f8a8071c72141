#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include "FileNames.h"
#include "NiftiWriter.h"
#include "NrrdWriter.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace moserhex
{
namespace
{

constexpr int tensorComponents = 6;

std::vector<std::int32_t>
labelsOf(const FieldVolume & image)
{
  std::vector<std::int32_t> labels;
  labels.reserve(image.values.size());
  for (const double value : image.values)
  {
    if (!(value >= 0.0 && value <= std::numeric_limits<std::int32_t>::max() && value == std::floor(value)))
    {
      throw InvalidInput("labels: " + std::to_string(value) + " is not a whole number from 0 to 2^31 - 1");
    }
    labels.push_back(static_cast<std::int32_t>(value));
  }
  return labels;
}

void
requireFitting(const std::string & fileName, const FieldVolume & image, FieldValues values)
{
  if (!isFieldImageName(fileName))
  {
    throw BadInput(
      ErrorCode::Usage, fileName, "images are written as NRRD or NIfTI-1", "give a .nrrd, .nii or .nii.gz name");
  }
  requireValid(image, "image");
  const int needed = values == FieldValues::Labels ? 1 : tensorComponents;
  if (values != FieldValues::Numbers && image.components != needed)
  {
    throw InvalidInput("image: " + std::to_string(image.components) + " components, need " + std::to_string(needed));
  }
}

itk::IOPixelEnum
pixelOf(const FieldVolume & image, FieldValues values)
{
  if (values == FieldValues::SymmetricTensors)
  {
    return itk::IOPixelEnum::SYMMETRICSECONDRANKTENSOR;
  }
  return image.components == 1 ? itk::IOPixelEnum::SCALAR : itk::IOPixelEnum::VECTOR;
}

} // namespace

bool
isFieldImageName(const std::string & fileName)
{
  return isNiftiName(fileName) || endsWith(fileName, ".nrrd");
}

void
writeFieldImage(const std::string & fileName, const FieldVolume & image, FieldValues values, ValueAxes axes)
{
  requireFitting(fileName, image, values);
  const bool                      isLabels = values == FieldValues::Labels;
  const std::vector<std::int32_t> labels = isLabels ? labelsOf(image) : std::vector<std::int32_t>();
  if (isNiftiName(fileName))
  {
    writeNiftiFile(fileName, image, values, axes, labels);
    return;
  }
  const auto isSame = [&image](const std::string & partName) {
    const FieldImage read = readFieldImage(partName, { false }); // of our own
    return isSamePlace(read.volume, image) && read.volume.values.size() == image.values.size() &&
           std::memcmp(read.volume.values.data(), image.values.data(), image.values.size() * sizeof(double)) == 0;
  };
  NrrdVoxels voxels;
  voxels.values = isLabels ? static_cast<const void *>(labels.data()) : image.values.data();
  voxels.component = isLabels ? itk::IOComponentEnum::INT : itk::IOComponentEnum::DOUBLE;
  voxels.pixel = pixelOf(image, values);
  voxels.components = static_cast<unsigned int>(image.components);
  voxels.axes = image.components == 1 || axes == ValueAxes::Lps ? "" : axes == ValueAxes::Cube ? "cube" : "unknown";
  writeNrrdFile(fileName, isLabels ? "labelmap" : "image", image, voxels, isSame);
}

} // namespace moserhex
