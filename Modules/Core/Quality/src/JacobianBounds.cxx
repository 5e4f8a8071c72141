#include "moserhex/Quality/JacobianBounds.h"

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

/** Cells evaluated side by side: the inner loops run over them and become vector instructions. */
constexpr std::size_t lanes = 8;

/** Coordinates of the corners of L cells, [corner][axis][cell]. */
template <std::size_t L>
using CornerLanes = std::array<std::array<std::array<double, L>, 3>, 8>;

/** Coefficients of L cells, [coefficient][cell]. */
template <std::size_t L>
using CoefficientLanes = std::array<std::array<double, L>, 27>;

template <std::size_t L>
using VectorLanes = std::array<std::array<double, L>, 3>;

/** The four edges along each reference axis, from and to, numbered by the two other coordinates (first + 2 second). */
constexpr std::size_t edgesAlongXi[4][2] = { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } };   // (eta, zeta)
constexpr std::size_t edgesAlongEta[4][2] = { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } };  // (xi, zeta)
constexpr std::size_t edgesAlongZeta[4][2] = { { 0, 4 }, { 1, 5 }, { 3, 7 }, { 2, 6 } }; // (xi, eta)

template <std::size_t L>
VectorLanes<L>
edgeOf(const CornerLanes<L> & x, const std::size_t (&edge)[2])
{
  VectorLanes<L> result;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t lane = 0; lane < L; ++lane)
    {
      result[axis][lane] = x[edge[1]][axis][lane] - x[edge[0]][axis][lane];
    }
  }
  return result;
}

template <std::size_t L>
VectorLanes<L>
crossProduct(const VectorLanes<L> & u, const VectorLanes<L> & v)
{
  VectorLanes<L> result;
  for (std::size_t lane = 0; lane < L; ++lane)
  {
    result[0][lane] = u[1][lane] * v[2][lane] - u[2][lane] * v[1][lane];
    result[1][lane] = u[2][lane] * v[0][lane] - u[0][lane] * v[2][lane];
    result[2][lane] = u[0][lane] * v[1][lane] - u[1][lane] * v[0][lane];
  }
  return result;
}

/** The product of the Bezier forms of a, b and c: each is of degree 1 in two of the variables, so that
 *
 *   B_pqr = mean of a_jk . (b_il x c_mn) over i + m = p, j + n = q, k + l = r
 *
 * with 1 (p = 0, 2) or 2 (p = 1) terms per direction. */
template <std::size_t L>
void
evaluateCoefficients(const CornerLanes<L> & x, CoefficientLanes<L> & coefficients)
{
  std::array<VectorLanes<L>, 4> a;
  std::array<VectorLanes<L>, 4> b;
  std::array<VectorLanes<L>, 4> c;
  for (std::size_t edge = 0; edge < 4; ++edge)
  {
    a[edge] = edgeOf(x, edgesAlongXi[edge]);
    b[edge] = edgeOf(x, edgesAlongEta[edge]);
    c[edge] = edgeOf(x, edgesAlongZeta[edge]);
  }
  for (auto & coefficient : coefficients)
  {
    coefficient.fill(0.0);
  }
  for (std::size_t edgeB = 0; edgeB < 4; ++edgeB)
  {
    for (std::size_t edgeC = 0; edgeC < 4; ++edgeC)
    {
      const VectorLanes<L> normal = crossProduct(b[edgeB], c[edgeC]);
      const std::size_t    p = edgeB % 2 + edgeC % 2;
      for (std::size_t edgeA = 0; edgeA < 4; ++edgeA)
      {
        const std::size_t q = edgeA % 2 + edgeC / 2;
        const std::size_t r = edgeA / 2 + edgeB / 2;
        const double      weight = (p == 1 ? 0.5 : 1.0) * (q == 1 ? 0.5 : 1.0) * (r == 1 ? 0.5 : 1.0);
        auto &            sum = coefficients[p + 3 * (q + 3 * r)];
        const auto &      u = a[edgeA];
        for (std::size_t lane = 0; lane < L; ++lane)
        {
          sum[lane] +=
            weight * (u[0][lane] * normal[0][lane] + u[1][lane] * normal[1][lane] + u[2][lane] * normal[2][lane]);
        }
      }
    }
  }
}

/** 64 eps times the product of the lengths of the four edges along each axis, taken as one vector: bounds the rounding
 * of every coefficient, subdivision included. Not a number when a coordinate is not. */
double
roundingOf(const HexCorners & x)
{
  double product = 64.0 * std::numeric_limits<double>::epsilon();
  for (const auto & edges : { edgesAlongXi, edgesAlongEta, edgesAlongZeta })
  {
    double squares = 0.0;
    for (std::size_t edge = 0; edge < 4; ++edge)
    {
      squares += (x[edges[edge][1]] - x[edges[edge][0]]).squaredNorm();
    }
    product *= std::sqrt(squares);
  }
  return product;
}

/** Corners of the cells [first, first + count), count <= L; the last cell is repeated in the lanes left over. */
template <std::size_t L, typename TMesh>
void
gatherCorners(const TMesh & mesh, std::size_t first, std::size_t count, CornerLanes<L> & x)
{
  for (std::size_t lane = 0; lane < L; ++lane)
  {
    const std::array<std::size_t, 8> nodes = mesh.cellNodes(first + std::min(lane, count - 1));
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const Vector3 & node = mesh.nodes[nodes[corner]];
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        x[corner][axis][lane] = node[static_cast<Eigen::Index>(axis)];
      }
    }
  }
}

template <typename TMesh>
std::vector<double>
smallestCoefficientsOf(const TMesh & mesh, unsigned int threads)
{
  std::vector<double> smallest(mesh.cellCount());
  parallelForBlocks(smallest.size(), 128 * lanes, threads, [&mesh, &smallest](std::size_t begin, std::size_t end) {
    CornerLanes<lanes>      corners;
    CoefficientLanes<lanes> coefficients;
    for (std::size_t first = begin; first < end; first += lanes)
    {
      const std::size_t count = std::min(lanes, end - first);
      gatherCorners(mesh, first, count, corners);
      evaluateCoefficients(corners, coefficients);
      std::array<double, lanes> minimum = coefficients[0];
      for (const auto & coefficient : coefficients)
      {
        for (std::size_t lane = 0; lane < lanes; ++lane)
        {
          minimum[lane] = coefficient[lane] < minimum[lane] ? coefficient[lane] : minimum[lane];
        }
      }
      std::copy_n(minimum.begin(), count, smallest.begin() + static_cast<std::ptrdiff_t>(first));
    }
  });
  return smallest;
}

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

BezierCoefficients
coefficientsOf(const HexCorners & corners)
{
  CornerLanes<1>      x;
  CoefficientLanes<1> lanesOfOne;
  BezierCoefficients  coefficients;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      x[corner][axis][0] = corners[corner][static_cast<Eigen::Index>(axis)];
    }
  }
  evaluateCoefficients(x, lanesOfOne);
  for (std::size_t i = 0; i < 27; ++i)
  {
    coefficients[i] = lanesOfOne[i][0];
  }
  return coefficients;
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
  const std::vector<double> smallest = smallestCoefficientsOf(mesh, threads);
  std::vector<JacobianSign> signs(smallest.size(), JacobianSign::Positive);
  parallelForBlocks(signs.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      const HexCorners corners = cellCorners(mesh, cell);
      if (!(smallest[cell] > roundingOf(corners)))
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

BezierCoefficients
bezierJacobianCoefficients(const HexCorners & corners)
{
  return coefficientsOf(corners);
}

std::vector<double>
smallestBezierCoefficients(const HexMesh & mesh, unsigned int threads)
{
  return smallestCoefficientsOf(mesh, threads);
}

std::vector<double>
smallestBezierCoefficients(const UnstructuredHexMesh & mesh, unsigned int threads)
{
  return smallestCoefficientsOf(mesh, threads);
}

JacobianCertificate
certifyPositive(const HexCorners & corners, const CertificateOptions & options)
{
  requireDepth(options);
  Box root;
  root.coefficients = coefficientsOf(corners);
  const double rounding = roundingOf(corners);
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
