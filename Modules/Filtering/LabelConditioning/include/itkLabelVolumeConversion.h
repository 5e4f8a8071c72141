#ifndef itkLabelVolumeConversion_h
#define itkLabelVolumeConversion_h

#include "itkVoxelGridConversion.h"

#include "moserhex/LevelSet/LabelVolume.h"

#include <itkNumericTraits.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace itk
{

/** The labels of the buffered region other than 0, as text: "1, 2, 7"; the first 20 and an ellipsis. */
template <typename TImage>
std::string
DescribeLabels(const TImage * image)
{
  using PixelType = typename TImage::PixelType;
  constexpr std::size_t     shown = 20;
  const auto *              first = image->GetBufferPointer();
  const std::set<PixelType> labels(first, first + image->GetBufferedRegion().GetNumberOfPixels());
  std::ostringstream        text;
  std::size_t               count = 0;
  for (const PixelType label : labels)
  {
    if (label == PixelType{})
    {
      continue;
    }
    if (count == shown)
    {
      text << ", ...";
      break;
    }
    text << (count++ == 0 ? "" : ", ") << static_cast<typename NumericTraits<PixelType>::PrintType>(label);
  }
  return count == 0 ? "none" : text.str();
}

/** One label of the buffered region as a mask, placed by VoxelGridFromImage().
 * \throws moserhex::InvalidInput  no voxel has the label (lists those present), or the image axes are sheared */
template <typename TImage>
moserhex::LabelVolume
LabelVolumeFromImage(const TImage * image, const typename TImage::PixelType & label)
{
  moserhex::LabelVolume volume{ VoxelGridFromImage(image), {} };
  const auto *          first = image->GetBufferPointer();
  volume.inside.resize(volume.gridVoxels());
  std::transform(first, first + volume.inside.size(), volume.inside.data(), [value = label](const auto voxel) {
    return static_cast<std::uint8_t>(voxel == value ? 1 : 0);
  });
  if (moserhex::voxelCount(volume) == 0)
  {
    std::ostringstream message;
    message << "label " << static_cast<typename NumericTraits<typename TImage::PixelType>::PrintType>(label)
            << " is not in the image; labels present: " << DescribeLabels(image);
    throw moserhex::InvalidInput(message.str());
  }
  return volume;
}

} // namespace itk

#endif
