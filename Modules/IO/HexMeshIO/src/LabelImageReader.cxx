#include "moserhex/HexMeshIO/LabelImageReader.h"

#include "ImageFile.h"
#include "ImageGrid.h"

#include <itkMetaDataObject.h>

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

/** Sets the labels of an image from the voxels of a file. */
template <typename TVoxel>
void
copyLabels(const std::string & fileName, const std::vector<TVoxel> & voxels, LabelImageType & image)
{
  LabelValue * labels = image.GetBufferPointer();
  if constexpr (std::is_integral_v<TVoxel> && sizeof(TVoxel) < sizeof(LabelValue))
  {
    std::copy(voxels.begin(), voxels.end(), labels); // all values are labels
    return;
  }
  for (std::size_t voxel = 0; voxel < voxels.size(); ++voxel)
  {
    const std::optional<LabelValue> label = asLabel(voxels[voxel]);
    if (!label)
    {
      throw BadInput(ErrorCode::Labels,
                     fileName,
                     "voxel " + std::to_string(voxel) + " holds " + textOf(voxels[voxel]) +
                       ", which is not a label (a whole number of 32 bits)",
                     "save integer labels, not probabilities or intensities");
    }
    labels[voxel] = *label;
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
      throw BadInput(ErrorCode::Labels,
                     fileName,
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
    throw BadInput(
      ErrorCode::EmptyLabel, fileName, "no voxel differs from 0", "give a labelmap with at least one label");
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

} // namespace

bool
isLabelImageName(const std::string & fileName)
{
  return isImageFileName(fileName);
}

LabelImage
readLabelImage(const std::string & fileName)
{
  return withImageErrors(fileName, [&fileName] {
    const ImageFile file = openImageFile(fileName);
    LabelImage      result{ fileName, imageOnGrid<LabelImageType>(file.grid), {}, file.warnings };
    withVoxels(file, [&](const auto & voxels) { copyLabels(fileName, voxels, *result.image); });
    result.labels = countLabels(fileName, *result.image);
    addSegmentNames(file.reader->GetMetaDataDictionary(), result.labels);
    return result;
  });
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
    ErrorCode::Labels,
    image.fileName,
    (wanted ? "no label " + std::to_string(*wanted) + ", it has " : std::to_string(image.labels.size()) + " labels: ") +
      list,
    "choose one with --label");
}

LabelVolume
labelVolumeOf(const LabelImageType & image, LabelValue label)
{
  LabelVolume        volume{ voxelGridOf(image), {} };
  const LabelValue * voxels = image.GetBufferPointer();
  volume.inside.resize(volume.gridVoxels());
  std::transform(voxels, voxels + volume.inside.size(), volume.inside.begin(), [label](LabelValue value) {
    return static_cast<std::uint8_t>(value == label ? 1 : 0);
  });
  return volume;
}

LabelImageType::Pointer
labelImageOf(const LabelVolume & volume)
{
  const auto image = imageOnGrid<LabelImageType>(volume);
  std::copy(volume.inside.begin(), volume.inside.end(), image->GetBufferPointer());
  return image;
}

} // namespace moserhex
