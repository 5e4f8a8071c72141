#include "NiftiGeometry.h"

#include "ImageHeader.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cmath>
#include <locale>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr double largestNumber = 1e9;

/** A matrix from voxel numbers to RAS, in the header's unit of length. */
struct Affine
{
  Matrix3 columns;
  Vector3 origin;
};

[[noreturn]] void
refuse(const ImageDescription & image, const std::string & cause)
{
  throw BadInput(ErrorCode::Geometry, image.fileName, cause, "correct the header's geometry");
}

std::string
textOf(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

void
requireFinite(const NiftiHeader & header, const ImageDescription & image)
{
  double     largest = 0.0;
  bool       finite = true;
  const auto see = [&](double number) {
    finite = finite && std::isfinite(number);
    largest = std::max(largest, std::abs(number));
  };
  for (std::size_t n = 0; n < 8; ++n)
  {
    see(header.pixdim(n));
  }
  for (int row = 0; row < 3; ++row)
  {
    see(header.quaternion()[row]);
    see(header.qformOffset()[row]);
    for (int column = 0; column < 4; ++column)
    {
      see(header.sform(row, column));
    }
  }
  if (!finite || largest > largestNumber)
  {
    refuse(image, "the header's geometry holds a number that is not finite or above 1e9");
  }
}

Vector3
voxelSizes(const NiftiHeader & header, const ImageDescription & image)
{
  Vector3 sizes;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    sizes[axis] = header.pixdim(static_cast<std::size_t>(axis) + 1);
    if (!(sizes[axis] > 0.0))
    {
      refuse(image, "voxel size " + textOf(sizes[axis]) + " along axis " + std::to_string(axis + 1));
    }
  }
  return sizes;
}

/** R = I (a^2 - v.v) + 2 v v^T + 2 a [v]x with a = sqrt(1 - v.v), last column times qfac (the NIfTI-1 standard). */
Affine
qformOf(const NiftiHeader & header, const ImageDescription & image, const Vector3 & sizes)
{
  constexpr double rounding = 1e-4;
  Vector3          v = header.quaternion();
  const double     squares = v.squaredNorm();
  if (squares > 1.0 + rounding)
  {
    refuse(image, "the quaternion's length is " + textOf(std::sqrt(squares)) + ": not a rotation");
  }
  double a = 0.0;
  if (1.0 - squares < 1e-7) // nothing but a float's rounding: the standard's own code takes it as half a turn
  {
    v.normalize();
  }
  else
  {
    a = std::sqrt(1.0 - squares);
  }
  Matrix3 cross;
  cross << 0.0, -v[2], v[1], v[2], 0.0, -v[0], -v[1], v[0], 0.0;
  Matrix3 rotation = (a * a - v.squaredNorm()) * Matrix3::Identity() + 2.0 * v * v.transpose() + 2.0 * a * cross;
  rotation.col(2) *= header.pixdim(0) < 0.0 ? -1.0 : 1.0;
  return { rotation * sizes.asDiagonal(), header.qformOffset() };
}

Affine
sformOf(const NiftiHeader & header)
{
  Affine affine;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      affine.columns(row, column) = header.sform(row, column);
    }
    affine.origin[row] = header.sform(row, 3);
  }
  return affine;
}

/** The sform's columns against pixdim. */
void
requireSameSizes(ImageDescription & image, const Affine & sform, const Vector3 & sizes)
{
  constexpr double rounding = 1e-5;
  constexpr double largest = 1e-3;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double length = sform.columns.col(axis).norm();
    const double difference = std::abs(length / sizes[axis] - 1.0);
    const auto   both = "pixdim says " + textOf(sizes[axis]) + ", the sform " + textOf(length) + " along axis " +
                      std::to_string(axis + 1);
    if (!(difference <= largest))
    {
      refuse(image, both);
    }
    if (difference > rounding)
    {
      image.warnings.push_back(image.fileName + ": " + both + ": the sform is taken");
    }
  }
}

void
requireAgreement(ImageDescription & image, const Affine & qform, const Affine & sform, const Vector3 & sizes)
{
  const Matrix3 difference = (qform.columns - sform.columns) * sizes.cwiseInverse().asDiagonal();
  const double  axes = difference.cwiseAbs().maxCoeff();
  const double  place = (qform.origin - sform.origin).norm() / sizes.minCoeff();
  if (!(axes <= 5e-3 && place <= 0.5))
  {
    refuse(image, "qform and sform disagree: axes by " + textOf(axes) + ", origin by " + textOf(place) + " of a voxel");
  }
  if (axes > 1e-3 || place > 0.01)
  {
    image.warnings.push_back(image.fileName + ": qform and sform differ (axes by " + textOf(axes) + ", origin by " +
                             textOf(place) + " of a voxel): the sform is taken");
  }
}

double
millimetres(const NiftiHeader & header, const ImageDescription & image)
{
  switch (header.lengthUnit())
  {
    case 0:
    case 2:
      return 1.0;
    case 1:
      return 1e3;
    case 3:
      return 1e-3;
    default:
      refuse(image, "unit of length " + std::to_string(header.lengthUnit()) + " is unknown");
  }
}

} // namespace

void
setNiftiGeometry(const NiftiHeader & header, ImageDescription & image)
{
  requireFinite(header, image);
  const Vector3 sizes = voxelSizes(header, image);
  const double  unit = millimetres(header, image);
  if (unit > 1.0 && header.sformCode() > 0)
  {
    // ITK 5.2 takes so small a matrix for a singular one.
    throw BadInput(ErrorCode::Unsupported, image.fileName, "an sform in metres", "convert the image to millimetres");
  }
  const Vector3 toLps(-unit, -unit, unit);
  const auto    take = [&](const Affine & affine) {
    setGeometry(image, toLps.asDiagonal() * affine.columns, toLps.cwiseProduct(affine.origin));
  };
  if (header.sformCode() > 0)
  {
    const Affine sform = sformOf(header);
    take(sform);
    requireSameSizes(image, sform, sizes);
    if (header.qformCode() > 0)
    {
      requireAgreement(image, qformOf(header, image, sizes), sform, sizes);
    }
  }
  else if (header.qformCode() > 0)
  {
    take(qformOf(header, image, sizes));
  }
  else
  {
    image.warnings.push_back(image.fileName + ": the header has neither qform nor sform: axes taken as LPS, origin 0");
    setGeometry(image, unit * Matrix3(sizes.asDiagonal()), Vector3::Zero()); // as ITK and Slicer do
  }
}

} // namespace moserhex
