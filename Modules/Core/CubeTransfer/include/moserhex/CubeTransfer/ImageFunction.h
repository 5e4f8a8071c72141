#pragma once

#include "moserhex/LevelSet/DensityImage.h"

namespace moserhex
{

/** How values are taken between the voxel centres of an image. */
enum class ImageInterpolation
{
  Nearest, ///< of the nearest voxel centre, in voxels; halfway the one with the larger index
  Linear   ///< trilinear between the eight centres around; constant in the half voxel beyond the outermost
};

/** Options of ImageFunction. */
struct ImageFunctionOptions
{
  ImageInterpolation interpolation{ ImageInterpolation::Linear }; ///< between voxel centres
  double             outside{ 0.0 }; ///< value beyond half a voxel from the outermost centres
};

/** An image as a function of space, for cellMeans and nodeSamples. Linear interpolation reproduces linear functions
 * and has the error O(h^2) between the centres. Values are not judged: NaN comes out where it has a part in the sum.
 * Thread-safe. Keeps a reference: the image must outlive the object. */
class ImageFunction
{
public:
  /** \throws InvalidInput  as requireValid(image) */
  explicit ImageFunction(const ScalarVolume & image, const ImageFunctionOptions & options = {});
  explicit ImageFunction(ScalarVolume &&, const ImageFunctionOptions & = {}) = delete;

  /** \param p  LPS [mm], any point; NaN is outside */
  [[nodiscard]] double
  operator()(const Vector3 & p) const;

private:
  const ScalarVolume & m_Image;
  ImageFunctionOptions m_Options;
};

} // namespace moserhex
