#include "moserhex/CubeTransfer/ImageFunction.h"

#include "ImageStencil.h"

namespace moserhex
{

ImageFunction::ImageFunction(const ScalarVolume & image, const ImageFunctionOptions & options)
  : m_Image(image), m_Options(options)
{
  requireValid(image, "image");
}

double
ImageFunction::operator()(const Vector3 & p) const
{
  const auto stencil = stencilAt(m_Image, p, m_Options.interpolation, 0.0);
  return stencil ? blended(*stencil, [&](int i, int j, int k) { return m_Image.values[m_Image.voxelNumber(i, j, k)]; })
                 : m_Options.outside;
}

} // namespace moserhex
