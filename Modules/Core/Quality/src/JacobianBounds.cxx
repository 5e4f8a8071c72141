#include "moserhex/Quality/JacobianBounds.h"

#include "BezierCoefficients.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace moserhex
{
namespace
{

constexpr std::size_t strides[3] = { 1, 3, 9 };

/** A box of the reference cube: its place and size along each direction, and the coefficients over it. */
struct Box
{
  std::array<int, 3>    halvings{ { 0, 0, 0 } }; ///< side 2^-halvings
  std::array<double, 3> begin{ { 0.0, 0.0, 0.0 } };
  BezierCoefficients    coefficients;

  [[nodiscard]] unsigned int
  depth() const
  {
    return static_cast<unsigned int>(halvings[0] + halvings[1] + halvings[2]);
  }

  [[nodiscard]] double
  side(std::size_t direction) const
  {
    return std::ldexp(1.0, -halvings[direction]);
  }
};

/** First coefficients of the nine rows along a direction. */
std::array<std::size_t, 9>
rowsAlong(std::size_t direction)
{
  std::array<std::size_t, 9> rows;
  for (std::size_t row = 0; row < 9; ++row)
  {
    rows[row] = row % 3 * strides[(direction + 1) % 3] + row / 3 * strides[(direction + 2) % 3];
  }
  return rows;
}

/** Where the coefficients are farthest from the polynomial: the direction of the largest second difference. */
std::size_t
mostCurvedDirection(const BezierCoefficients & b)
{
  std::array<double, 3> curvature{};
  for (std::size_t direction = 0; direction < 3; ++direction)
  {
    const std::size_t stride = strides[direction];
    for (const std::size_t row : rowsAlong(direction))
    {
      curvature[direction] =
        std::max(curvature[direction], std::abs(b[row] - 2.0 * b[row + stride] + b[row + 2 * stride]));
    }
  }
  return static_cast<std::size_t>(std::max_element(curvature.begin(), curvature.end()) - curvature.begin());
}

/** De Casteljau's halving along one direction: the lower half replaces `lower`, the upper one is returned. */
Box
halve(Box & lower, std::size_t direction)
{
  const std::size_t stride = strides[direction];
  ++lower.halvings[direction];
  Box upper = lower;
  upper.begin[direction] += upper.side(direction);
  for (const std::size_t row : rowsAlong(direction))
  {
    const double b0 = lower.coefficients[row];
    const double b1 = lower.coefficients[row + stride];
    const double b2 = lower.coefficients[row + 2 * stride];
    const double left = 0.5 * (b0 + b1);
    const double right = 0.5 * (b1 + b2);
    const double middle = 0.5 * (left + right);
    lower.coefficients[row + stride] = left;
    lower.coefficients[row + 2 * stride] = middle;
    upper.coefficients[row] = middle;
    upper.coefficients[row + stride] = right;
    upper.coefficients[row + 2 * stride] = b2;
  }
  return upper;
}

/** Takes the values at the corners of a box into the certificate's upper bound. */
void
meetCorners(const Box & box, JacobianCertificate & certificate)
{
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::array<std::size_t, 3> end{ { corner & 1U, corner >> 1 & 1U, corner >> 2 & 1U } };
    const double                     value = box.coefficients[2 * (end[0] + 3 * (end[1] + 3 * end[2]))];
    if (value < certificate.upperBound)
    {
      certificate.upperBound = value;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        certificate.point[static_cast<Eigen::Index>(axis)] =
          box.begin[axis] + static_cast<double>(end[axis]) * box.side(axis);
      }
    }
  }
}

double
smallestOf(const BezierCoefficients & coefficients)
{
  return *std::min_element(coefficients.begin(), coefficients.end());
}

constexpr unsigned int depthLimit = 60;

/** Depth-first bisection. The lower bound is the smallest coefficient of the boxes that were left undivided. */
JacobianCertificate
subdivide(const Box & root, double rounding, const CertificateOptions & options)
{
  const double                    rootBound = smallestOf(root.coefficients) - rounding;
  JacobianCertificate             certificate{ JacobianSign::Positive,
                                   std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity(),
                                   Vector3::Zero() };
  std::array<Box, depthLimit + 1> stack;
  std::size_t                     waiting = 0;
  std::size_t                     boxes = 0;
  stack[waiting++] = root;
  while (waiting > 0)
  {
    Box          box = stack[--waiting];
    const double smallest = smallestOf(box.coefficients);
    ++boxes;
    meetCorners(box, certificate);
    if (certificate.upperBound < -rounding)
    {
      return { JacobianSign::NotPositive, rootBound, certificate.upperBound, certificate.point };
    }
    const bool leaf = smallest > rounding || box.depth() >= options.maximumDepth || boxes >= options.maximumBoxes;
    if (leaf)
    {
      certificate.sign = smallest > rounding ? certificate.sign : JacobianSign::Undecided;
      certificate.lowerBound = std::min(certificate.lowerBound, smallest - rounding);
      continue;
    }
    Box other = halve(box, mostCurvedDirection(box.coefficients));
    if (smallestOf(other.coefficients) < smallestOf(box.coefficients))
    {
      std::swap(box, other);
    }
    stack[waiting++] = other; // the one with the smaller coefficient is looked at first
    stack[waiting++] = box;
  }
  return certificate;
}

/** A corner that is not positive by cornerJacobians(), which rounds in another order than the coefficients. */
bool
foundAtCorner(const HexCorners & corners, JacobianCertificate & certificate)
{
  constexpr int reference[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                    { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const auto    jacobians = cornerJacobians(corners);
  const auto    smallest = std::min_element(jacobians.begin(), jacobians.end());
  if (*smallest > 0.0)
  {
    return false;
  }
  const int(&at)[3] = reference[smallest - jacobians.begin()];
  certificate.sign = JacobianSign::NotPositive;
  certificate.upperBound = *smallest;
  certificate.point = Vector3(at[0], at[1], at[2]);
  return true;
}

void
requireDepth(const CertificateOptions & options)
{
  if (options.maximumDepth > depthLimit)
  {
    throw InvalidInput("maximumDepth is " + std::to_string(options.maximumDepth) + ", must be at most " +
                       std::to_string(depthLimit));
  }
}

template <typename TMesh>
CertificateCounts
certifyCellsOf(const TMesh & mesh, const CertificateOptions & options, unsigned int threads)
{
  requireDepth(options);
  const std::vector<double> smallest = smallestBezierCoefficients(mesh, threads);
  std::vector<JacobianSign> signs(smallest.size(), JacobianSign::Positive);
  parallelForBlocks(signs.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const HexCorners corners = cellCorners(mesh, cell);
      if (!(smallest[cell] > roundingOfCoefficients(corners)))
      {
        signs[cell] = certifyPositive(corners, options).sign;
      }
    }
  });
  const auto count = [&signs](JacobianSign sign) {
    return static_cast<std::size_t>(std::count(signs.begin(), signs.end(), sign));
  };
  return { count(JacobianSign::Positive), count(JacobianSign::NotPositive), count(JacobianSign::Undecided) };
}

} // namespace

JacobianCertificate
certifyPositive(const HexCorners & corners, const CertificateOptions & options)
{
  requireDepth(options);
  Box root;
  root.coefficients = bezierJacobianCoefficients(corners);
  const double rounding = roundingOfCoefficients(corners);
  if (!std::isfinite(rounding))
  {
    throw InvalidInput("a hexahedron has a coordinate that is not finite, or det J overflows");
  }
  JacobianCertificate certificate;
  certificate.lowerBound = smallestOf(root.coefficients) - rounding;
  if (foundAtCorner(corners, certificate))
  {
    return certificate;
  }
  return subdivide(root, rounding, options);
}

CertificateCounts
certifyCells(const HexMesh & mesh, const CertificateOptions & options, unsigned int threads)
{
  return certifyCellsOf(mesh, options, threads);
}

CertificateCounts
certifyCells(const UnstructuredHexMesh & mesh, const CertificateOptions & options, unsigned int threads)
{
  return certifyCellsOf(mesh, options, threads);
}

} // namespace moserhex
