#include "Camera.h"

#include <Eigen/Geometry>

#include <cmath>

namespace moserhex::app
{

Camera
cameraFrom(double azimuth, double elevation)
{
  const double toRadians = pi / 180.0;
  const double a = azimuth * toRadians;
  const double e = elevation * toRadians;
  Camera       camera;
  camera.right = Vector3(std::cos(a), std::sin(a), 0.0);
  camera.towards = Vector3(std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
  camera.up = camera.towards.cross(camera.right);
  return camera;
}

Camera
cameraOfSlice(int axis)
{
  switch (axis)
  {
    case 0:
      return { { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } };
    case 1:
      return { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.0, -1.0, 0.0 } };
    default:
      return { { 1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 }, { 0.0, 0.0, -1.0 } };
  }
}

} // namespace moserhex::app
