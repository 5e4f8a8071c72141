#include "ImageStencil.h"

#include <algorithm>

namespace moserhex
{

std::optional<ImageStencil>
stencilAt(const VoxelGrid & grid, const Vector3 & p, ImageInterpolation interpolation, double beyond)
{
  const Vector3 index = grid.continuousIndex(p);
  ImageStencil  stencil;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = grid.size[static_cast<std::size_t>(axis)] - 1;
    if (!(index[axis] >= -0.5 - beyond && index[axis] <= last + 0.5 + beyond))
    {
      return std::nullopt;
    }
    const double along = std::clamp(index[axis], 0.0, static_cast<double>(last));
    const bool   isNearest = interpolation == ImageInterpolation::Nearest;
    stencil.first[axis] = isNearest ? std::min(static_cast<int>(along + 0.5), last) : static_cast<int>(along);
    stencil.second[axis] = isNearest ? stencil.first[axis] : std::min(stencil.first[axis] + 1, last);
    stencil.between[axis] = isNearest ? 0.0 : along - stencil.first[axis];
  }
  return stencil;
}

} // namespace moserhex
