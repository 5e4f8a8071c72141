#pragma once

#include "moserhex/CubeTransfer/ImageFunction.h"
#include "moserhex/LevelSet/FieldVolume.h"

namespace moserhex
{

/** An image of several components as a function of space; see ImageFunction. Thread-safe. Keeps a reference: the image
 * must outlive the object. */
class FieldFunction
{
public:
  /** \throws InvalidInput  as requireValid(image) */
  FieldFunction(const FieldVolume & image, ImageInterpolation interpolation);
  FieldFunction(FieldVolume &&, ImageInterpolation) = delete;

  /** Sets the components' values.
   * \param p  LPS [mm], any point
   * \return false, the values unchanged, farther than half a voxel (and 1e-9 of one, for round-off) outside of the
   * outermost centres */
  bool
  evaluate(const Vector3 & p, double * values) const;

private:
  const FieldVolume & m_Image;
  ImageInterpolation  m_Interpolation;
};

} // namespace moserhex
