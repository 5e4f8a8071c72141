#include "BezierCoefficients.h"

#include "moserhex/Common/Parallel.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

} // namespace

double
roundingOfCoefficients(const HexCorners & x)
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

BezierCoefficients
bezierJacobianCoefficients(const HexCorners & corners)
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

} // namespace moserhex
