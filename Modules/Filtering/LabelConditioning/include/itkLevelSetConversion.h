#ifndef itkLevelSetConversion_h
#define itkLevelSetConversion_h

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <itkImage.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace itk
{

/** A level set as an image: same order of values, same positions in space. */
template <typename TImage>
typename TImage::Pointer
ImageFromLevelSet(const moserhex::LevelSet & levelSet)
{
  static_assert(TImage::ImageDimension == 3, "level sets are three-dimensional");
  typename TImage::SizeType      size;
  typename TImage::SpacingType   spacing;
  typename TImage::PointType     origin;
  typename TImage::DirectionType direction;
  for (unsigned int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<SizeValueType>(levelSet.grid.size[a]);
    spacing[a] = levelSet.grid.spacing;
    origin[a] = levelSet.grid.origin[static_cast<int>(a)];
    for (unsigned int b = 0; b < 3; ++b)
    {
      direction[a][b] = levelSet.grid.direction(static_cast<int>(a), static_cast<int>(b));
    }
  }
  const auto image = TImage::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  std::transform(levelSet.values.begin(), levelSet.values.end(), image->GetBufferPointer(), [](double value) {
    return static_cast<typename TImage::PixelType>(value);
  });
  return image;
}

/** The buffered region of an image with equal spacings as a level set; its first index becomes node (0,0,0).
 * \throws moserhex::InvalidInput  when the spacings differ by more than 1e-6 of the first */
template <typename TImage>
moserhex::LevelSet
LevelSetFromImage(const TImage * image)
{
  static_assert(TImage::ImageDimension == 3, "level sets are three-dimensional");
  const auto         region = image->GetBufferedRegion();
  const auto         spacing = image->GetSpacing();
  const auto         direction = image->GetDirection();
  moserhex::LevelSet levelSet;
  levelSet.grid.spacing = spacing[0];
  typename TImage::PointType origin;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  for (unsigned int a = 0; a < 3; ++a)
  {
    if (!(std::abs(spacing[a] - spacing[0]) <= 1e-6 * spacing[0]))
    {
      throw moserhex::InvalidInput("level-set image: spacing " + std::to_string(spacing[a]) + " mm along axis " +
                                   std::to_string(a) + ", need the same as along axis 0, " +
                                   std::to_string(spacing[0]));
    }
    levelSet.grid.size[a] = static_cast<int>(region.GetSize(a));
    levelSet.grid.origin[static_cast<int>(a)] = origin[a];
    for (unsigned int b = 0; b < 3; ++b)
    {
      levelSet.grid.direction(static_cast<int>(a), static_cast<int>(b)) = direction[a][b];
    }
  }
  const auto * first = image->GetBufferPointer();
  levelSet.values.assign(first, first + region.GetNumberOfPixels());
  return levelSet;
}

} // namespace itk

#endif
