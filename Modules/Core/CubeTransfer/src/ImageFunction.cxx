#include "moserhex/CubeTransfer/ImageFunction.h"

#include <algorithm>
#include <cmath>

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
  const Vector3 index = m_Image.continuousIndex(p);
  int           first[3];
  int           second[3];
  double        between[3]; // of first and second
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = m_Image.size[static_cast<std::size_t>(axis)] - 1;
    if (!(index[axis] >= -0.5 && index[axis] <= last + 0.5))
    {
      return m_Options.outside;
    }
    const double along = std::clamp(index[axis], 0.0, static_cast<double>(last));
    if (m_Options.interpolation == ImageInterpolation::Nearest)
    {
      first[axis] = std::min(static_cast<int>(along + 0.5), last);
      second[axis] = first[axis];
      between[axis] = 0.0;
      continue;
    }
    first[axis] = static_cast<int>(along);
    second[axis] = std::min(first[axis] + 1, last);
    between[axis] = along - first[axis];
  }
  const auto value = [&](int i, int j, int k) { return m_Image.values[m_Image.voxelNumber(i, j, k)]; };
  // A voxel without weight has no part, also where it holds no number.
  const auto blend = [](double t, const auto & a, const auto & b) { return t > 0.0 ? (1.0 - t) * a() + t * b() : a(); };
  const auto row = [&](int j, int k) {
    return blend(
      between[0], [&] { return value(first[0], j, k); }, [&] { return value(second[0], j, k); });
  };
  const auto plane = [&](int k) {
    return blend(
      between[1], [&] { return row(first[1], k); }, [&] { return row(second[1], k); });
  };
  return blend(
    between[2], [&] { return plane(first[2]); }, [&] { return plane(second[2]); });
}

} // namespace moserhex
