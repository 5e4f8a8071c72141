#include "moserhex/CubeTransfer/FieldFunction.h"

#include "ImageStencil.h"

namespace moserhex
{

FieldFunction::FieldFunction(const FieldVolume & image, ImageInterpolation interpolation)
  : m_Image(image), m_Interpolation(interpolation)
{
  requireValid(image, "image");
}

bool
FieldFunction::evaluate(const Vector3 & p, double * values) const
{
  constexpr double roundOff = 1e-9;
  const auto       stencil = stencilAt(m_Image, p, m_Interpolation, roundOff);
  if (!stencil)
  {
    return false;
  }
  for (int component = 0; component < m_Image.components; ++component)
  {
    values[component] =
      blended(*stencil, [&](int i, int j, int k) { return m_Image.at(m_Image.voxelNumber(i, j, k))[component]; });
  }
  return true;
}

} // namespace moserhex
