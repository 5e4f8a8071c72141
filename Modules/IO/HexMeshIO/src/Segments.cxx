#include "Segments.h"

#include "FileText.h"
#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <limits>

namespace moserhex
{
namespace
{

constexpr std::size_t mostSegments = 4096;

std::string
listOf(const std::vector<SegmentEntry> & segments)
{
  std::string list;
  for (std::size_t n = 0; n < segments.size(); ++n)
  {
    list += (n == 0 ? "" : ", ") + std::to_string(n + 1) + " '" + segments[n].name + "'";
  }
  return list;
}

/** The value of a key as a whole number from `least` to `most`. \throws BadInput (Header) */
int
keyNumber(const ImageDescription & image, const std::string & key, int otherwise, int least, int most)
{
  const auto entry = image.keyValues.find(key);
  if (entry == image.keyValues.end())
  {
    return otherwise;
  }
  int value = 0;
  if (!parseNumber(trimmed(entry->second), value) || value < least || value > most)
  {
    throwHeader(image.fileName, key + " is " + quoted(entry->second));
  }
  return value;
}

std::optional<std::size_t>
onlyOne(const ImageDescription & image, const std::vector<SegmentEntry> & segments, const std::string & choice)
{
  for (std::string SegmentEntry::*field : { &SegmentEntry::name, &SegmentEntry::id })
  {
    const auto fits = [&](const SegmentEntry & segment) { return segment.*field == choice; };
    const auto first = std::find_if(segments.begin(), segments.end(), fits);
    if (first == segments.end())
    {
      continue;
    }
    if (std::count_if(segments.begin(), segments.end(), fits) > 1)
    {
      throw BadInput(ErrorCode::Labels,
                     image.fileName,
                     "several segments are called " + quoted(choice) + ": " + listOf(segments),
                     "choose one by its number");
    }
    return static_cast<std::size_t>(first - segments.begin());
  }
  std::size_t number = 0;
  if (parseNumber(choice, number) && number >= 1 && number <= segments.size())
  {
    return number - 1;
  }
  return std::nullopt;
}

} // namespace

std::vector<SegmentEntry>
segmentsOf(const ImageDescription & image)
{
  std::vector<SegmentEntry> segments;
  const auto                has = [&image](std::size_t n, const char * key) {
    return image.keyValues.count("Segment" + std::to_string(n) + key) > 0;
  };
  std::size_t count = 0;
  while (count < mostSegments && (has(count, "_ID") || has(count, "_Name") || has(count, "_LabelValue")))
  {
    ++count;
  }
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::string prefix = "Segment" + std::to_string(n);
    const auto        textOf = [&](const char * key) {
      const auto entry = image.keyValues.find(prefix + key);
      return entry == image.keyValues.end() ? std::string() : entry->second;
    };
    const int    own = static_cast<int>(n);
    const bool   layered = image.layers > 1;
    SegmentEntry segment;
    segment.name = textOf("_Name");
    segment.id = textOf("_ID");
    segment.layer =
      keyNumber(image, prefix + "_Layer", layered ? std::min(own, image.layers - 1) : 0, 0, image.layers - 1);
    segment.value =
      keyNumber(image, prefix + "_LabelValue", layered ? 1 : own + 1, 1, std::numeric_limits<LabelValue>::max());
    segments.push_back(segment);
  }
  return segments;
}

std::optional<std::size_t>
chosenSegment(const ImageDescription &           image,
              const std::vector<SegmentEntry> &  segments,
              const std::optional<std::string> & choice)
{
  if (choice)
  {
    const auto chosen = onlyOne(image, segments, *choice);
    if (!chosen)
    {
      throw BadInput(ErrorCode::Labels,
                     image.fileName,
                     segments.empty() ? "the file names no segments, so there is no " + quoted(*choice)
                                      : "no segment " + quoted(*choice) + ", it has " + listOf(segments),
                     segments.empty() ? "leave --segment out" : "choose one of these with --segment");
    }
    return chosen;
  }
  if (image.layers == 1)
  {
    return std::nullopt;
  }
  if (segments.size() == 1)
  {
    return 0;
  }
  throw BadInput(ErrorCode::Dimension,
                 image.fileName,
                 "segments that overlap, in " + std::to_string(image.layers) +
                   " layers, no 3-D labelmap: " + listOf(segments),
                 "choose one with --segment NAME or NUMBER");
}

} // namespace moserhex
