#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <Eigen/SVD>

#include <cmath>
#include <locale>
#include <sstream>

namespace moserhex
{
namespace
{

/** Twelve significant digits: the length of a direction vector comes back as 0.49999999999999994 for 0.5. */
double
withoutRoundOff(double spacing)
{
  const double scale = std::pow(10.0, 12.0 - std::ceil(std::log10(spacing)));
  return std::round(spacing * scale) / scale;
}

/** The nearest orthonormal matrix; headers carry seven digits at best. */
Matrix3
orthonormalDirection(ImageDescription & image, const Matrix3 & direction)
{
  constexpr double                largest = 1e-3;
  constexpr double                rounding = 1e-5;
  const Eigen::JacobiSVD<Matrix3> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double                    deviation = (svd.singularValues().array() - 1.0).abs().maxCoeff();
  if (!(deviation <= largest))
  {
    throw BadInput(ErrorCode::Geometry,
                   image.fileName,
                   "the image axes are not at right angles (direction matrix off by " + std::to_string(deviation) + ")",
                   "resample the image to a rectangular grid");
  }
  if (deviation > rounding)
  {
    image.warnings.push_back(image.fileName + ": the image axes were turned to right angles (direction matrix off by " +
                             std::to_string(deviation) + ")");
  }
  return svd.matrixU() * svd.matrixV().transpose();
}

} // namespace

void
setGeometry(ImageDescription & image, const Matrix3 & columns, const Vector3 & origin)
{
  const auto refuse = [&image](const std::string & cause) {
    throw BadInput(ErrorCode::Geometry, image.fileName, cause, "correct the image's geometry");
  };
  if (!columns.allFinite())
  {
    refuse("the voxel sizes or axes are not finite");
  }
  Matrix3 direction = columns;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double spacing = columns.col(axis).stableNorm();
    if (!(spacing >= 1e-3 && spacing <= 1e3))
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text << "voxel size " << spacing << " mm along axis " << axis + 1 << ", need 0.001 to 1000";
      refuse(text.str());
    }
    direction.col(axis) /= spacing;
    image.grid.spacing[axis] = withoutRoundOff(spacing);
  }
  if (!origin.allFinite() || !(origin.cwiseAbs().maxCoeff() <= 1e6))
  {
    refuse("the origin is not finite or beyond 1e6 mm");
  }
  image.grid.origin = origin;
  image.grid.direction = orthonormalDirection(image, direction);
}

} // namespace moserhex
