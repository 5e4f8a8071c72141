#pragma once

#include "moserhex/CubeTransfer/ImageFunction.h"

#include <optional>

namespace moserhex
{

/** The two voxels along each axis that a value is taken between. */
struct ImageStencil
{
  int    first[3];
  int    second[3];
  double between[3]; ///< of first and second
};

/** \param beyond  how far outside the outermost voxels a point still counts [voxels] \return nothing outside */
[[nodiscard]] std::optional<ImageStencil>
stencilAt(const VoxelGrid & grid, const Vector3 & p, ImageInterpolation interpolation, double beyond);

/** \param value  of voxel (i,j,k); one without weight is not asked for: it has no part, also where it holds no number
 */
template <typename TValue>
[[nodiscard]] double
blended(const ImageStencil & stencil, const TValue & value)
{
  const auto blend = [](double t, const auto & a, const auto & b) { return t > 0.0 ? (1.0 - t) * a() + t * b() : a(); };
  const auto row = [&](int j, int k) {
    return blend(
      stencil.between[0],
      [&] { return value(stencil.first[0], j, k); },
      [&] { return value(stencil.second[0], j, k); });
  };
  const auto plane = [&](int k) {
    return blend(
      stencil.between[1], [&] { return row(stencil.first[1], k); }, [&] { return row(stencil.second[1], k); });
  };
  return blend(
    stencil.between[2], [&] { return plane(stencil.first[2]); }, [&] { return plane(stencil.second[2]); });
}

} // namespace moserhex
