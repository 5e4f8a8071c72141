#include "LabelVoxels.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <locale>
#include <sstream>

namespace moserhex
{

void
throwNoLabel(const ImageDescription & image, std::size_t voxel, double value, const LabelRules & rules)
{
  const auto         nx = static_cast<std::size_t>(image.grid.size[0]);
  const auto         ny = static_cast<std::size_t>(image.grid.size[1]);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9);
  text << "voxel (" << voxel % nx << ", " << voxel / nx % ny << ", " << voxel / (nx * ny) << ") holds " << value
       << ", which is not a label (a whole number from 0 to 2^31-1)";
  const bool fraction = std::isfinite(value) && value > 0.0 && value < 1e6;
  throw BadInput(ErrorCode::Labels,
                 image.fileName,
                 text.str(),
                 fraction ? rules.remedyForFractions : "give the segmentation, not intensities");
}

void
throwTooManyLabels(const ImageDescription & image)
{
  throw BadInput(ErrorCode::Labels,
                 image.fileName,
                 "more than " + std::to_string(mostLabels) + " different values: an image, not a labelmap",
                 "give the segmentation");
}

void
warnOfRounding(ImageDescription & image, std::size_t rounded)
{
  if (rounded > 0)
  {
    image.warnings.push_back(image.fileName + ": " + std::to_string(rounded) +
                             " values within 1e-4 of whole numbers were rounded to labels");
  }
}

void
warnOfNaN(ImageDescription & image, std::size_t notNumbers)
{
  if (notNumbers > 0)
  {
    image.warnings.push_back(image.fileName + ": " + std::to_string(notNumbers) +
                             " voxels are not numbers (NaN) and were taken as outside");
  }
}

std::vector<LabelEntry>
labelEntries(ImageDescription &                image,
             const LabelVoxels::Counts &       counts,
             const LabelRules &                rules,
             const std::vector<SegmentEntry> & segments)
{
  std::vector<LabelEntry> entries;
  for (const auto & [value, voxels] : counts)
  {
    if (value == 0 || (rules.only && value != *rules.only))
    {
      continue;
    }
    const auto segment = std::find_if(segments.begin(), segments.end(), [&, own = value](const SegmentEntry & one) {
      return one.layer == rules.layer && one.value == own && !rules.threshold;
    });
    entries.push_back({ value, voxels, segment == segments.end() ? "" : segment->name });
  }
  if (entries.empty())
  {
    const std::string cause = rules.threshold ? "no voxel reaches the threshold"
                                              : (rules.only ? "the segment has no voxels" : "no voxel differs from 0");
    if (!rules.allowEmpty)
    {
      throw BadInput(ErrorCode::EmptyLabel,
                     image.fileName,
                     cause,
                     rules.threshold ? "give a smaller threshold" : "give a labelmap with at least one label");
    }
    image.warnings.push_back(image.fileName + ": " + cause);
  }
  return entries;
}

} // namespace moserhex
