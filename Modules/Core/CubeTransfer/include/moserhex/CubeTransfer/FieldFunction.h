#pragma once

#include "moserhex/CubeTransfer/ImageFunction.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <vector>

namespace moserhex
{

struct ImageStencil;

/** An image of several components as a function of space; see ImageFunction. Thread-safe. Keeps a reference: the image
 * and the mask must outlive the object.
 *
 * Voxels without data are like the space beyond the image: a point whose nearest voxel has none has no value; for
 * others these voxels have no part in the interpolation, the weights w of the rest are scaled to the sum 1,
 *
 *   f(p) = sum_v w_v f_v / sum_v w_v,      v with data,
 *
 * which half a voxel beyond a straight edge of the mask gives the edge's value, as at the edge of the image. */
class FieldFunction
{
public:
  /** \throws InvalidInput  as requireValid(image) */
  FieldFunction(const FieldVolume & image, ImageInterpolation interpolation);
  FieldFunction(FieldVolume &&, ImageInterpolation) = delete;

  /** \param hasValue  0 for each voxel without data, else 1; empty: all have data
   * \throws InvalidInput  as requireValid(image), or another number of voxels */
  FieldFunction(const FieldVolume &                image,
                const std::vector<unsigned char> & hasValue,
                ImageInterpolation                 interpolation);

  /** Sets the components' values.
   * \param p  LPS [mm], any point
   * \return false, the values unchanged, farther than half a voxel (and 1e-9 of one, for round-off) outside of the
   * outermost centres, or where the nearest voxel has no data */
  bool
  evaluate(const Vector3 & p, double * values) const;

private:
  [[nodiscard]] bool
  evaluateWhereData(const ImageStencil & stencil, double * values) const;

  const FieldVolume &                m_Image;
  const std::vector<unsigned char> * m_HasValue{ nullptr }; ///< none: all have data
  ImageInterpolation                 m_Interpolation;
};

} // namespace moserhex
