#include "moserhex/HexMeshIO/LabelImageReader.h"

#include "ImageFile.h"
#include "ImageFileCheck.h"
#include "ImageGrid.h"
#include "LabelVoxels.h"
#include "NiftiLink.h"
#include "Parcel.h"
#include "ReaderSandbox.h"
#include "Segments.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace moserhex
{
namespace
{

void
requireUsable(const std::string & fileName, const LabelReadOptions & options)
{
  if (options.threshold && options.segment)
  {
    throw InvalidInput(ErrorCode::Usage,
                       fileMessage(fileName, "both a threshold and a segment are wanted", "give one of the two"));
  }
  if (options.threshold && !std::isfinite(*options.threshold))
  {
    throw InvalidInput(ErrorCode::Usage, fileMessage(fileName, "the threshold is not finite", "give a number"));
  }
}

/** Everything about a labelmap but its file name: voxels first, so that they need not be moved. */
std::string
pack(const ImageDescription &          image,
     LabelVoxels                       labels,
     const std::vector<LabelEntry> &   entries,
     const std::vector<SegmentEntry> & segments)
{
  const std::uint64_t begin = labels.bytes.size();
  ParcelWriter        parcel(std::move(labels.bytes));
  parcel.put(image.grid);
  parcel.put(labels.width);
  parcel.put(image.warnings);
  parcel.put(std::uint64_t{ entries.size() });
  for (const LabelEntry & entry : entries)
  {
    parcel.put(entry.value);
    parcel.put(std::uint64_t{ entry.voxels });
    parcel.put(entry.name);
  }
  parcel.put(std::uint64_t{ segments.size() });
  for (const SegmentEntry & segment : segments)
  {
    parcel.put(segment.name);
    parcel.put(segment.id);
    parcel.put(segment.layer);
    parcel.put(segment.value);
    parcel.put(std::uint64_t{ segment.voxels });
  }
  parcel.put(begin);
  return parcel.take();
}

template <typename TLabel>
void
widen(const std::string & bytes, LabelImageType & image)
{
  LabelValue * const labels = image.GetBufferPointer();
  const std::size_t  count = image.GetLargestPossibleRegion().GetNumberOfPixels();
  for (std::size_t n = 0; n < count; ++n)
  {
    TLabel narrow;
    std::memcpy(&narrow, bytes.data() + n * sizeof narrow, sizeof narrow);
    labels[n] = static_cast<LabelValue>(narrow);
  }
}

LabelImage
unpack(const std::string & fileName, const std::string & bytes)
{
  const auto      begin = ParcelReader(bytes, bytes.size() - sizeof(std::uint64_t)).number<std::uint64_t>();
  ParcelReader    parcel(bytes, static_cast<std::size_t>(begin));
  const VoxelGrid grid = parcel.grid();
  const auto      width = parcel.number<std::uint8_t>();
  if (begin != grid.gridVoxels() * width)
  {
    throw std::out_of_range("the reader's answer does not fit its sizes");
  }
  LabelImage result{ fileName, imageOnGrid<LabelImageType>(grid), {}, parcel.texts(), {} };
  for (auto count = parcel.number<std::uint64_t>(); count > 0; --count)
  {
    LabelEntry entry;
    entry.value = parcel.number<LabelValue>();
    entry.voxels = static_cast<std::size_t>(parcel.number<std::uint64_t>());
    entry.name = parcel.text();
    result.labels.push_back(entry);
  }
  for (auto count = parcel.number<std::uint64_t>(); count > 0; --count)
  {
    SegmentEntry segment;
    segment.name = parcel.text();
    segment.id = parcel.text();
    segment.layer = parcel.number<int>();
    segment.value = parcel.number<LabelValue>();
    segment.voxels = static_cast<std::size_t>(parcel.number<std::uint64_t>());
    result.segments.push_back(segment);
  }
  width == 1 ? widen<std::uint8_t>(bytes, *result.image)
             : (width == 2 ? widen<std::uint16_t>(bytes, *result.image) : widen<std::uint32_t>(bytes, *result.image));
  return result;
}

/** Reads, checks and packs. */
std::string
packedLabels(const std::string & fileName, const std::string & itkName, const LabelReadOptions & options)
{
  std::string parcel;
  const auto  packVoxels = [&](const ImageDescription & description, const auto & values) {
    ImageDescription          image = description;
    std::vector<SegmentEntry> segments = segmentsOf(image);
    const auto                chosen = chosenSegment(image, segments, options.segment);
    LabelRules                rules;
    rules.threshold = options.threshold;
    rules.allowEmpty = options.allowEmpty;
    rules.remedyForFractions = options.remedyForFractions;
    if (chosen)
    {
      rules.layer = segments[*chosen].layer;
      rules.only = segments[*chosen].value;
    }
    LabelVoxels labels = labelsFrom(image, values, rules);
    for (SegmentEntry & segment : segments)
    {
      const auto & counts = labels.counts[static_cast<std::size_t>(segment.layer)];
      const auto   count = counts.find(segment.value);
      segment.voxels = count == counts.end() || rules.threshold ? 0 : count->second;
    }
    const auto entries = labelEntries(image, labels.counts[static_cast<std::size_t>(rules.layer)], rules, segments);
    parcel = pack(image, std::move(labels), entries, segments);
  };
  withCheckedVoxels(fileName, itkName, options.sandbox, VoxelContent::OneValue, packVoxels);
  return parcel;
}

} // namespace

bool
isLabelImageName(const std::string & fileName)
{
  return isImageFileName(fileName);
}

LabelImage
readLabelImage(const std::string & fileName, const LabelReadOptions & options)
{
  requireUsable(fileName, options);
  return withImageErrors(fileName, [&] {
    const NiftiLink link(fileName);
    const auto      work = [&] { return packedLabels(fileName, link.name(), options); };
    return unpack(fileName, options.sandbox ? runInSandbox(fileName, {}, work) : work());
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

namespace
{

template <typename TInside>
LabelVolume
volumeWhere(const LabelImageType & image, const TInside & isInside)
{
  LabelVolume        volume{ voxelGridOf(image), {} };
  const LabelValue * voxels = image.GetBufferPointer();
  volume.inside.resize(volume.gridVoxels());
  std::transform(voxels, voxels + volume.inside.size(), volume.inside.begin(), [&isInside](LabelValue value) {
    return static_cast<std::uint8_t>(isInside(value) ? 1 : 0);
  });
  return volume;
}

} // namespace

LabelVolume
labelVolumeOf(const LabelImageType & image, LabelValue label)
{
  return volumeWhere(image, [label](LabelValue value) { return value == label; });
}

LabelVolume
labelVolumeOfAll(const LabelImageType & image)
{
  return volumeWhere(image, [](LabelValue value) { return value != 0; });
}

LabelValues
labelValuesOf(const LabelImageType & image)
{
  LabelValues values{ voxelGridOf(image), {} };
  values.values.assign(image.GetBufferPointer(), image.GetBufferPointer() + values.gridVoxels());
  return values;
}

LabelImageType::Pointer
labelImageOf(const LabelVolume & volume)
{
  const auto image = imageOnGrid<LabelImageType>(volume);
  std::copy(volume.inside.begin(), volume.inside.end(), image->GetBufferPointer());
  return image;
}

} // namespace moserhex
