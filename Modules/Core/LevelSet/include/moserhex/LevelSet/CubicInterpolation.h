#pragma once

#include "moserhex/LevelSet/LevelSet.h"

#include <array>

namespace moserhex
{

/** A function and its first derivatives at a point. */
struct ValueAndGradient
{
  double  value{ 0.0 };                ///< unit of the function
  Vector3 gradient{ Vector3::Zero() }; ///< in LPS directions [unit / mm]
};

/** The four Catmull-Rom weights at the fraction s in [0,1] between the middle two of four equidistant samples. */
[[nodiscard]] inline std::array<double, 4>
catmullRomWeights(double s)
{
  const double s2 = s * s;
  const double s3 = s2 * s;
  return { { 0.5 * (-s3 + 2 * s2 - s), 0.5 * (3 * s3 - 5 * s2 + 2), 0.5 * (-3 * s3 + 4 * s2 + s), 0.5 * (s3 - s2) } };
}

/** Their derivatives with respect to s. */
[[nodiscard]] inline std::array<double, 4>
catmullRomDerivatives(double s)
{
  const double s2 = s * s;
  return {
    { 0.5 * (-3 * s2 + 4 * s - 1), 0.5 * (9 * s2 - 10 * s), 0.5 * (-9 * s2 + 8 * s + 1), 0.5 * (3 * s2 - 2 * s) }
  };
}

/** Tensor product of Catmull-Rom splines: C1, interpolates the nodes, exact for quadratics, error O(h^3) in general.
 *
 * Points outside the nodes [1, size-2] are moved to the nearest point of that box first; the gradient is the one found
 * there. Thread-safe. Keeps a reference: the level set must outlive the object. Values must be finite.
 * \throws InvalidInput  invalid grid or wrong number of values */
class CubicInterpolator
{
public:
  /** \param levelSet  at least 4 nodes along each axis, finite values */
  explicit CubicInterpolator(const LevelSet & levelSet);
  explicit CubicInterpolator(LevelSet &&) = delete;

  /** \param p  LPS [mm] */
  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const;

  /** at(p).value, cheaper. \param p  LPS [mm] */
  [[nodiscard]] double
  value(const Vector3 & p) const;

  /** Of the level set. */
  [[nodiscard]] const RegularGrid &
  grid() const
  {
    return m_LevelSet.grid;
  }

private:
  const LevelSet & m_LevelSet;
  Matrix3          m_ToIndex;
};

/** Newton steps along the gradient towards {f = level}: p += (level - f) grad f / |grad f|^2, each at most
 * `maximumStep` [mm] long. Stops early when |level - f| / |grad f| < 1e-10 mm; stays where the gradient vanishes.
 * Returns the last point: at a regular point of f two or three iterations reach the level to round-off. */
[[nodiscard]] Vector3
projectToLevel(const CubicInterpolator & f, Vector3 p, double level, double maximumStep, int iterations);

} // namespace moserhex
