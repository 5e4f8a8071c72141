#pragma once

#include "moserhex/Common/Types.h"

#include <vector>

namespace moserhex::app
{

using Point2 = Eigen::Vector2d;

/** Parallel projection from far away, so that millimetres are the same everywhere in the picture. Columns of a rotation
 * in LPS: what is to the right, what is up, and what is towards the viewer. */
struct Camera
{
  Vector3 right{ 1.0, 0.0, 0.0 };
  Vector3 up{ 0.0, 0.0, 1.0 };
  Vector3 towards{ 0.0, -1.0, 0.0 };

  /** Where a point is seen, y upwards [mm]. */
  [[nodiscard]] Point2
  place(const Vector3 & point) const
  {
    return { right.dot(point), up.dot(point) };
  }

  /** How near the viewer a point is, larger is nearer [mm]. */
  [[nodiscard]] double
  nearness(const Vector3 & point) const
  {
    return towards.dot(point);
  }
};

/** The viewer stands around the patient: azimuth 0 looks at the anterior side, 90 at the patient's left, elevation 90
 * from above the head. Superior is up; from straight above or below, posterior is down [degrees]. */
[[nodiscard]] Camera
cameraFrom(double azimuth, double elevation);

/** As radiologists hold a slice with normal axis 0 (sagittal: anterior at the left), 1 (coronal) or 2 (axial, from the
 * feet): the patient's left is at the right of the picture in the last two. */
[[nodiscard]] Camera
cameraOfSlice(int axis);

/** One polygon as it is seen. */
struct SeenFacet
{
  std::vector<Point2> outline;  ///< three corners or more; counter-clockwise for a face that looks at the viewer [mm]
  std::vector<double> nearness; ///< of each corner [mm]
  std::size_t         cell{ 0 };
  double              light{ 1.0 }; ///< in [0,1]
};

} // namespace moserhex::app
