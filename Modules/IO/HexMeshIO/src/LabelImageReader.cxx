#include "moserhex/HexMeshIO/LabelImageReader.h"

#include "FileNames.h"
#include "ImageFileCheck.h"

#include <itkImageRegionConstIterator.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr std::size_t mostLabels = 4096;
constexpr std::size_t mostVoxels = 500'000'000;

ImageFormat
formatOf(const std::string & fileName)
{
  if (endsWith(fileName, ".nrrd"))
  {
    return ImageFormat::Nrrd;
  }
  if (endsWithAny(fileName, { ".nii", ".nii.gz" }))
  {
    return ImageFormat::Nifti;
  }
  if (endsWithAny(fileName, { ".mha", ".mhd" }))
  {
    return ImageFormat::Meta;
  }
  throw BadInput(fileName, "not a labelmap's name", "give a .nrrd, .nii, .nii.gz, .mha or .mhd file");
}

/** The one reader for a format: no factory, so no other parser ever sees the file. */
itk::ImageIOBase::Pointer
makeReader(ImageFormat format)
{
  switch (format)
  {
    case ImageFormat::Nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ImageFormat::Nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ImageFormat::Meta:
      return itk::MetaImageIO::New().GetPointer();
  }
  return nullptr;
}

void
requireScalarVolume(const std::string & fileName, const itk::ImageIOBase & reader)
{
  for (unsigned int axis = 3; axis < reader.GetNumberOfDimensions(); ++axis)
  {
    if (reader.GetDimensions(axis) != 1)
    {
      throw BadInput(fileName,
                     "a " + std::to_string(reader.GetNumberOfDimensions()) + "-D image, need a 3-D labelmap",
                     "export one 3-D volume");
    }
  }
  if (reader.GetNumberOfDimensions() < 3)
  {
    throw BadInput(fileName, "a 2-D image, need a 3-D labelmap", "export one 3-D volume");
  }
  if (reader.GetNumberOfComponents() != 1)
  {
    throw BadInput(fileName,
                   std::to_string(reader.GetNumberOfComponents()) + " values per voxel, need a scalar labelmap",
                   "export integer labels, one per voxel");
  }
  if (static_cast<std::size_t>(reader.GetImageSizeInPixels()) > mostVoxels)
  {
    throw BadInput(fileName,
                   std::to_string(reader.GetImageSizeInPixels()) + " voxels, at most " + std::to_string(mostVoxels),
                   "crop the image around the label");
  }
}

/** The nearest orthonormal matrix; headers carry seven digits at best. */
Matrix3
orthonormalDirection(const std::string & fileName, const Matrix3 & direction)
{
  if (!direction.allFinite())
  {
    throw BadInput(fileName, "the direction matrix is not finite", "correct the header");
  }
  const Eigen::JacobiSVD<Matrix3> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double                    deviation = (svd.singularValues().array() - 1.0).abs().maxCoeff();
  if (!(deviation <= 1e-3))
  {
    throw BadInput(fileName,
                   "the image axes are not at right angles (direction matrix off by " + std::to_string(deviation) + ")",
                   "resample the image to a rectangular grid");
  }
  return svd.matrixU() * svd.matrixV().transpose();
}

/** Twelve significant digits: the length of a direction vector comes back as 0.49999999999999994 for 0.5. */
double
withoutRoundOff(double spacing)
{
  const double scale = std::pow(10.0, 12.0 - std::ceil(std::log10(spacing)));
  return std::round(spacing * scale) / scale;
}

/** An image of the file's size and place, its voxels not yet set. */
LabelImageType::Pointer
makeImage(const std::string & fileName, const itk::ImageIOBase & reader)
{
  LabelImageType::SizeType      size;
  LabelImageType::SpacingType   spacing;
  LabelImageType::PointType     origin;
  LabelImageType::DirectionType direction;
  Matrix3                       axes;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = reader.GetDimensions(axis);
    spacing[axis] = reader.GetSpacing(axis);
    origin[axis] = reader.GetOrigin(axis);
    if (!(spacing[axis] >= 1e-3 && spacing[axis] <= 1e3))
    {
      throw BadInput(fileName,
                     "voxel size " + std::to_string(spacing[axis]) + " mm along axis " + std::to_string(axis + 1) +
                       ", need 0.001 to 1000",
                     "correct the header's spacing");
    }
    spacing[axis] = withoutRoundOff(spacing[axis]);
    if (!(std::abs(origin[axis]) <= 1e6))
    {
      throw BadInput(fileName, "the origin is not finite or above 1e6 mm", "correct the header's origin");
    }
    const std::vector<double> column = reader.GetDirection(axis);
    axes.col(axis) = Vector3(column[0], column[1], column[2]);
  }
  axes = orthonormalDirection(fileName, axes);
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      direction(row, column) = axes(row, column);
    }
  }
  auto image = LabelImageType::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  return image;
}

/** The value as a label, or nothing when it is not a whole number or out of range. */
template <typename TVoxel>
std::optional<LabelValue>
asLabel(TVoxel value)
{
  using Limits = std::numeric_limits<LabelValue>;
  if constexpr (std::is_floating_point_v<TVoxel>)
  {
    const auto real = static_cast<double>(value);
    if (!(real >= Limits::min() && real <= Limits::max()) || real != std::floor(real))
    {
      return std::nullopt;
    }
  }
  else if constexpr (std::is_signed_v<TVoxel>)
  {
    if (static_cast<long long>(value) < Limits::min() || static_cast<long long>(value) > Limits::max())
    {
      return std::nullopt;
    }
  }
  else if (static_cast<unsigned long long>(value) > static_cast<unsigned long long>(Limits::max()))
  {
    return std::nullopt;
  }
  return static_cast<LabelValue>(value);
}

template <typename TVoxel>
std::string
textOf(TVoxel value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<TVoxel>::max_digits10) << +value;
  return text.str();
}

template <typename TVoxel>
void
readVoxelsAs(const std::string & fileName, itk::ImageIOBase & reader, LabelImageType & image)
{
  const std::size_t   count = image.GetLargestPossibleRegion().GetNumberOfPixels();
  std::vector<TVoxel> voxels(count);
  reader.Read(voxels.data());
  LabelValue * labels = image.GetBufferPointer();
  for (std::size_t voxel = 0; voxel < count; ++voxel)
  {
    const std::optional<LabelValue> label = asLabel(voxels[voxel]);
    if (!label)
    {
      throw BadInput(fileName,
                     "voxel " + std::to_string(voxel) + " holds " + textOf(voxels[voxel]) +
                       ", which is not a label (a whole number of 32 bits)",
                     "save integer labels, not probabilities or intensities");
    }
    labels[voxel] = *label;
  }
}

void
readVoxels(const std::string & fileName, itk::ImageIOBase & reader, LabelImageType & image)
{
  using Component = itk::ImageIOBase;
  switch (reader.GetComponentType())
  {
    case Component::IOComponentEnum::UCHAR:
      return readVoxelsAs<unsigned char>(fileName, reader, image);
    case Component::IOComponentEnum::CHAR:
      return readVoxelsAs<signed char>(fileName, reader, image);
    case Component::IOComponentEnum::USHORT:
      return readVoxelsAs<unsigned short>(fileName, reader, image);
    case Component::IOComponentEnum::SHORT:
      return readVoxelsAs<short>(fileName, reader, image);
    case Component::IOComponentEnum::UINT:
      return readVoxelsAs<unsigned int>(fileName, reader, image);
    case Component::IOComponentEnum::INT:
      return readVoxelsAs<int>(fileName, reader, image);
    case Component::IOComponentEnum::ULONG:
      return readVoxelsAs<unsigned long>(fileName, reader, image);
    case Component::IOComponentEnum::LONG:
      return readVoxelsAs<long>(fileName, reader, image);
    case Component::IOComponentEnum::ULONGLONG:
      return readVoxelsAs<unsigned long long>(fileName, reader, image);
    case Component::IOComponentEnum::LONGLONG:
      return readVoxelsAs<long long>(fileName, reader, image);
    case Component::IOComponentEnum::FLOAT:
      return readVoxelsAs<float>(fileName, reader, image);
    case Component::IOComponentEnum::DOUBLE:
      return readVoxelsAs<double>(fileName, reader, image);
    default:
      throw BadInput(fileName, "an unknown voxel type", "export integer labels, one per voxel");
  }
}

std::vector<LabelEntry>
countLabels(const std::string & fileName, const LabelImageType & image)
{
  std::map<LabelValue, std::size_t> counts;
  const LabelValue *                voxel = image.GetBufferPointer();
  const LabelValue * const          end = voxel + image.GetLargestPossibleRegion().GetNumberOfPixels();
  while (voxel != end)
  {
    const LabelValue * const run = voxel;
    while (voxel != end && *voxel == *run)
    {
      ++voxel;
    }
    counts[*run] += static_cast<std::size_t>(voxel - run);
    if (counts.size() > mostLabels)
    {
      throw BadInput(fileName,
                     "more than " + std::to_string(mostLabels) + " different values: an image, not a labelmap",
                     "give the segmentation");
    }
  }
  std::vector<LabelEntry> labels;
  for (const auto & [value, voxels] : counts)
  {
    if (value != 0)
    {
      labels.push_back({ value, voxels, "" });
    }
  }
  if (labels.empty())
  {
    throw BadInput(fileName, "no voxel differs from 0", "give a labelmap with at least one label");
  }
  return labels;
}

/** Slicer's SegmentN_LabelValue and SegmentN_Name. */
void
addSegmentNames(const itk::MetaDataDictionary & dictionary, std::vector<LabelEntry> & labels)
{
  for (std::size_t segment = 0; segment < mostLabels; ++segment)
  {
    const std::string prefix = "Segment" + std::to_string(segment) + "_";
    std::string       value;
    std::string       name;
    if (!itk::ExposeMetaData(dictionary, prefix + "LabelValue", value))
    {
      return;
    }
    itk::ExposeMetaData(dictionary, prefix + "Name", name);
    for (LabelEntry & label : labels)
    {
      if (std::to_string(label.value) == value && label.name.empty())
      {
        label.name = name;
      }
    }
  }
}

std::string
firstLine(std::string text)
{
  // ITK puts its file, line and class before the message.
  const auto colon = text.rfind("): ");
  if (colon != std::string::npos)
  {
    text = text.substr(colon + 3);
  }
  return text.substr(0, text.find('\n'));
}

LabelImage
readChecked(const std::string & fileName)
{
  const ImageFormat format = formatOf(fileName);
  LabelImage        result;
  result.fileName = fileName;
  result.warnings = checkImageFile(fileName, format);

  const itk::ImageIOBase::Pointer reader = makeReader(format);
  reader->SetFileName(fileName);
  reader->ReadImageInformation();
  requireScalarVolume(fileName, *reader);
  result.image = makeImage(fileName, *reader);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < reader->GetNumberOfDimensions(); ++axis)
  {
    region.SetSize(axis, reader->GetDimensions(axis));
  }
  reader->SetIORegion(region);
  readVoxels(fileName, *reader, *result.image);
  result.labels = countLabels(fileName, *result.image);
  addSegmentNames(reader->GetMetaDataDictionary(), result.labels);
  return result;
}

} // namespace

bool
isLabelImageName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".nrrd", ".nii", ".nii.gz", ".mha", ".mhd" });
}

LabelImage
readLabelImage(const std::string & fileName)
{
  try
  {
    return readChecked(fileName);
  }
  catch (const Error &)
  {
    throw;
  }
  catch (const std::bad_alloc &)
  {
    throw BadInput(fileName, "not enough memory for the image", "crop the image around the label");
  }
  catch (const std::exception & error)
  {
    throw BadInput(fileName, firstLine(error.what()), "export the labelmap again, for example as .nrrd");
  }
}

const LabelEntry &
chooseLabel(const LabelImage & image, const std::optional<LabelValue> & wanted)
{
  if (!wanted && image.labels.size() == 1)
  {
    return image.labels.front();
  }
  const auto entry = std::find_if(image.labels.begin(), image.labels.end(), [&wanted](const LabelEntry & label) {
    return wanted && label.value == *wanted;
  });
  if (entry != image.labels.end())
  {
    return *entry;
  }
  std::string list;
  for (const LabelEntry & label : image.labels)
  {
    list += (list.empty() ? "" : ", ") + std::to_string(label.value);
    list += label.name.empty() ? "" : " (" + label.name + ")";
  }
  throw BadInput(
    image.fileName,
    (wanted ? "no label " + std::to_string(*wanted) + ", it has " : std::to_string(image.labels.size()) + " labels: ") +
      list,
    "choose one with --label");
}

LabelVolume
labelVolumeOf(const LabelImageType & image, LabelValue label)
{
  LabelVolume volume;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    volume.size[axis] = static_cast<int>(image.GetLargestPossibleRegion().GetSize(axis));
    volume.spacing[axis] = image.GetSpacing()[axis];
    volume.origin[axis] = image.GetOrigin()[axis];
    for (unsigned int row = 0; row < 3; ++row)
    {
      volume.direction(row, axis) = image.GetDirection()(row, axis);
    }
  }
  const std::size_t  count = image.GetLargestPossibleRegion().GetNumberOfPixels();
  const LabelValue * voxels = image.GetBufferPointer();
  volume.inside.resize(count);
  std::transform(voxels, voxels + count, volume.inside.begin(), [label](LabelValue value) {
    return static_cast<std::uint8_t>(value == label ? 1 : 0);
  });
  return volume;
}

LabelImageType::Pointer
labelImageOf(const LabelVolume & volume)
{
  LabelImageType::SizeType      size;
  LabelImageType::SpacingType   spacing;
  LabelImageType::PointType     origin;
  LabelImageType::DirectionType direction;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(volume.size[axis]);
    spacing[axis] = volume.spacing[axis];
    origin[axis] = volume.origin[axis];
    for (unsigned int row = 0; row < 3; ++row)
    {
      direction(row, axis) = volume.direction(row, axis);
    }
  }
  auto image = LabelImageType::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  std::copy(volume.inside.begin(), volume.inside.end(), image->GetBufferPointer());
  return image;
}

} // namespace moserhex
