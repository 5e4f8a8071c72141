#include "moserhex/Geometry/HexMesh.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{

/** Corner and its neighbours along +xi, +eta, +zeta (right-handed), VTK_HEXAHEDRON order. */
constexpr int cornerFrame[8][4] = { { 0, 1, 3, 4 }, { 1, 2, 0, 5 }, { 2, 3, 1, 6 }, { 3, 0, 2, 7 },
                                    { 4, 7, 5, 0 }, { 5, 4, 6, 1 }, { 6, 5, 7, 2 }, { 7, 6, 4, 3 } };

} // namespace

std::array<std::size_t, 8>
HexMesh::cellNodes(std::size_t cell) const
{
  const auto        n = static_cast<std::size_t>(nodesPerSide);
  const std::size_t m = n - 1;
  const std::size_t i = cell % m;
  const std::size_t j = cell / m % m;
  const std::size_t k = cell / (m * m);
  const std::size_t base = i + n * (j + n * k);
  const std::size_t up = n * n;
  return { base, base + 1, base + 1 + n, base + n, base + up, base + 1 + up, base + 1 + n + up, base + n + up };
}

void
requireValid(const HexMesh & mesh)
{
  const auto n = static_cast<std::size_t>(std::max(mesh.nodesPerSide, 0));
  if (n < 2 || mesh.nodes.size() != n * n * n)
  {
    throw InvalidInput("hexahedral mesh with " + std::to_string(mesh.nodes.size()) + " nodes and " +
                       std::to_string(mesh.nodesPerSide) + " a side, must be n^3 nodes with n >= 2");
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (!mesh.nodes[node].allFinite())
    {
      throw InvalidInput("node " + std::to_string(node) + " has a coordinate that is not finite");
    }
  }
}

HexCorners
cellCorners(const HexMesh & mesh, std::size_t cell)
{
  const std::array<std::size_t, 8> nodes = mesh.cellNodes(cell);
  HexCorners                       corners;
  for (int c = 0; c < 8; ++c)
  {
    corners[c] = mesh.nodes[nodes[c]];
  }
  return corners;
}

double
hexVolume(const HexCorners & x)
{
  // det J = a(eta,zeta) . b(xi,zeta) x c(xi,eta) is at most quadratic in each variable: 2x2x2 Gauss points are exact.
  const Vector3    a[4] = { x[1] - x[0], x[2] - x[3], x[5] - x[4], x[6] - x[7] }; // along xi at (eta, zeta)
  const Vector3    b[4] = { x[3] - x[0], x[2] - x[1], x[7] - x[4], x[6] - x[5] }; // along eta at (xi, zeta)
  const Vector3    c[4] = { x[4] - x[0], x[5] - x[1], x[7] - x[3], x[6] - x[2] }; // along zeta at (xi, eta)
  constexpr double low = 0.21132486540518711775;                                  // (1 - 1/sqrt(3)) / 2
  constexpr double g[2] = { low, 1.0 - low };
  const auto       blend = [](const Vector3 * e, double u, double v) -> Vector3 {
    return (1 - u) * (1 - v) * e[0] + u * (1 - v) * e[1] + (1 - u) * v * e[2] + u * v * e[3];
  };
  double sum = 0.0;
  for (const double zeta : g)
  {
    for (const double eta : g)
    {
      for (const double xi : g)
      {
        sum += blend(a, eta, zeta).dot(blend(b, xi, zeta).cross(blend(c, xi, eta)));
      }
    }
  }
  return sum / 8.0;
}

std::array<double, 8>
cornerJacobians(const HexCorners & x)
{
  std::array<double, 8> jacobians;
  for (int c = 0; c < 8; ++c)
  {
    const int *     f = cornerFrame[c];
    const Vector3 & o = x[f[0]];
    jacobians[c] = (x[f[1]] - o).dot((x[f[2]] - o).cross(x[f[3]] - o));
  }
  return jacobians;
}

std::vector<double>
cellVolumes(const HexMesh & mesh)
{
  std::vector<double> volumes(mesh.cellCount());
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    volumes[cell] = hexVolume(cellCorners(mesh, cell));
  }
  return volumes;
}

} // namespace moserhex
