#include "moserhex/CubeTransfer/FieldFunction.h"

#include "ImageStencil.h"
#include "moserhex/Common/Errors.h"

namespace moserhex
{

FieldFunction::FieldFunction(const FieldVolume & image, ImageInterpolation interpolation)
  : m_Image(image), m_Interpolation(interpolation)
{
  requireValid(image, "image");
}

FieldFunction::FieldFunction(const FieldVolume &                image,
                             const std::vector<unsigned char> & hasValue,
                             ImageInterpolation                 interpolation)
  : FieldFunction(image, interpolation)
{
  if (!hasValue.empty() && hasValue.size() != image.gridVoxels())
  {
    throw InvalidInput("image: a mask of " + std::to_string(hasValue.size()) + " voxels for " +
                       std::to_string(image.gridVoxels()));
  }
  m_HasValue = hasValue.empty() ? nullptr : &hasValue;
}

bool
FieldFunction::evaluateWhereData(const ImageStencil & stencil, double * values) const
{
  int nearest[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    nearest[axis] = stencil.between[axis] < 0.5 ? stencil.first[axis] : stencil.second[axis];
  }
  if ((*m_HasValue)[m_Image.voxelNumber(nearest[0], nearest[1], nearest[2])] == 0)
  {
    return false;
  }
  const double weight =
    blended(stencil, [&](int i, int j, int k) -> double { return (*m_HasValue)[m_Image.voxelNumber(i, j, k)]; });
  for (int component = 0; component < m_Image.components; ++component)
  {
    const double sum = blended(stencil, [&](int i, int j, int k) {
      const std::size_t voxel = m_Image.voxelNumber(i, j, k);
      return (*m_HasValue)[voxel] == 0 ? 0.0 : m_Image.at(voxel)[component];
    });
    values[component] = sum / weight;
  }
  return true;
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
  if (m_HasValue != nullptr)
  {
    return evaluateWhereData(*stencil, values);
  }
  for (int component = 0; component < m_Image.components; ++component)
  {
    values[component] =
      blended(*stencil, [&](int i, int j, int k) { return m_Image.at(m_Image.voxelNumber(i, j, k))[component]; });
  }
  return true;
}

} // namespace moserhex
