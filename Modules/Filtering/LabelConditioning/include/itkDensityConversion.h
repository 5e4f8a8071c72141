#ifndef itkDensityConversion_h
#define itkDensityConversion_h

#include "itkVoxelGridConversion.h"

#include "moserhex/LevelSet/DensityImage.h"

namespace itk
{

/** The buffered region of an image of real or integer numbers; its first index becomes voxel (0,0,0). Values are not
 * judged here: moserhex::densityOnLabel() and moserhex::DensityImage do.
 * \throws moserhex::InvalidInput  the image axes are sheared */
template <typename TImage>
moserhex::ScalarVolume
ScalarVolumeFromImage(const TImage * image)
{
  moserhex::ScalarVolume volume{ VoxelGridFromImage(image), {} };
  const auto *           first = image->GetBufferPointer();
  volume.values.assign(first, first + volume.gridVoxels());
  return volume;
}

} // namespace itk

#endif
