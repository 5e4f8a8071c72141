#pragma once

#include "moserhex/LevelSet/Density.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <vector>

namespace moserhex
{

/** A scalar image. */
struct ScalarVolume : VoxelGrid
{
  std::vector<double> values; ///< in the order of the voxel numbers
};

/** \throws InvalidInput  invalid grid, or a number of values that is not the number of voxels */
void
requireValid(const ScalarVolume & image, const std::string & what);

/** A density given by the voxels v of an image: a quadratic B-spline. With the point at the continuous index (r,s,t),
 *
 *   mu(x) = sum_ijk c_ijk B(r-i) B(s-j) B(t-k),      B(r) = 3/4 - r^2             for |r| <= 1/2
 *                                                         (3/2 - |r|)^2 / 2       for |r| <= 3/2, else 0
 *   c = max(v - (second differences of v along the three axes) / 8, v / 2)
 *
 * The second differences undo the smoothing by B, so quadratic densities are reproduced and the error is O(h^3). As
 * v/2 <= c <= 7 v/4, the density is positive whatever the contrast: the lower bound counts where v is below 3/5 of
 * the mean of its six neighbours. C1 with a bounded second derivative. Over the whole image its mass is the sum of v
 * times the voxel volume, where that bound does not count.
 *
 * Outside the image the value of the nearest point on its border: constant along the outward normal, and still C1.
 * O(27) a point. Thread-safe. `README.md`, section "Density", has the alternatives that were measured. */
class DensityImage : public Density
{
public:
  /** \throws InvalidInput  invalid grid, wrong number of values, or a value that is not positive and finite (names the
   *                        first such voxel and its value) */
  explicit DensityImage(const ScalarVolume & image);

  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const override;

  [[nodiscard]] double
  value(const Vector3 & p) const override;

private:
  /** The 3 x 3 x 3 voxels a point depends on. */
  struct Stencil
  {
    const double * first;    ///< coefficient of the voxel of the smallest number
    Vector3        fraction; ///< of the point from the middle voxel, in [-1/2, 1/2] [voxels]
  };

  [[nodiscard]] Stencil
  stencilAt(const Vector3 & p) const;

  Matrix3             m_ToIndex;      ///< LPS to index directions [1/mm]
  Vector3             m_Origin;       ///< centre of voxel (0,0,0) [mm]
  std::array<int, 3>  m_Size;         ///< voxels of the image
  std::size_t         m_RowStride;    ///< of the coefficients
  std::size_t         m_SliceStride;  ///< of the coefficients
  std::vector<double> m_Coefficients; ///< c of the image with its border repeated once on every side
};

} // namespace moserhex
