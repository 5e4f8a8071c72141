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

/** How many boundary nodes of the lattice come before boundary node (i,j,k). */
std::size_t
boundaryNumber(int n, int i, int j, int k)
{
  const auto ring = [n](int u, int v) { // of the frame of an n x n square
    if (v == 0)
    {
      return u;
    }
    return v == n - 1 ? n + 2 * (n - 2) + u : n + 2 * (v - 1) + (u > 0 ? 1 : 0);
  };
  const int square = n * n;
  const int frame = 4 * (n - 1);
  if (k == 0)
  {
    return static_cast<std::size_t>(i + n * j);
  }
  return static_cast<std::size_t>(square + frame * (k - 1) + (k == n - 1 ? i + n * j : ring(i, j)));
}

/** Steps of the corners of a cell along the three axes, VTK_HEXAHEDRON order. */
constexpr std::array<std::array<int, 3>, 8> cornerSteps{
  { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } }
};

std::array<std::size_t, 8>
pillowNodes(const HexMesh & mesh, const PillowCell & pillow)
{
  const auto                 axis = static_cast<std::size_t>(pillow.axis);
  std::array<std::size_t, 8> nodes;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::array<int, 3> & step = cornerSteps[corner];
    const bool                 isOuter = (step[axis] == 1) == pillow.last;
    std::array<int, 3>         at = pillow.quad;
    for (std::size_t across = 0; across < 3; ++across)
    {
      at[across] += across == axis ? 0 : step[across];
    }
    nodes[corner] = mesh.paddingNodeNumber(isOuter ? pillow.layer : pillow.layer - 1, at[0], at[1], at[2]);
  }
  return nodes;
}

} // namespace

PillowCell
pillowCell(const HexMesh & mesh, std::size_t cell)
{
  const auto        m = static_cast<std::size_t>(mesh.nodesPerSide - 1);
  const std::size_t pillow = cell - mesh.latticeCellCount();
  const std::size_t quad = pillow % (m * m);
  const std::size_t face = pillow / (m * m);
  const std::size_t axis = face % 6 / 2;
  PillowCell        result{ static_cast<int>(face / 6) + 1, static_cast<int>(axis), face % 2 == 1, {} };
  result.quad[axis] = result.last ? mesh.nodesPerSide - 1 : 0;
  result.quad[axis == 0 ? 1 : 0] = static_cast<int>(quad % m);
  result.quad[axis == 2 ? 1 : 2] = static_cast<int>(quad / m);
  return result;
}

std::size_t
boundaryNodeCount(int nodesPerSide)
{
  const auto n = static_cast<std::size_t>(nodesPerSide);
  return n * n * n - (n - 2) * (n - 2) * (n - 2);
}

std::size_t
nodeCount(int nodesPerSide, int paddingLayers)
{
  const auto n = static_cast<std::size_t>(nodesPerSide);
  return n * n * n + static_cast<std::size_t>(paddingLayers) * boundaryNodeCount(nodesPerSide);
}

std::size_t
HexMesh::paddingNodeNumber(int layer, int i, int j, int k) const
{
  if (layer == 0)
  {
    return nodeNumber(i, j, k);
  }
  const std::size_t all = nodeNumber(nodesPerSide - 1, nodesPerSide - 1, nodesPerSide - 1) + 1;
  return all + static_cast<std::size_t>(layer - 1) * boundaryNodeCount(nodesPerSide) +
         boundaryNumber(nodesPerSide, i, j, k);
}

std::array<std::size_t, 8>
HexMesh::cellNodes(std::size_t cell) const
{
  if (cell >= latticeCellCount())
  {
    return pillowNodes(*this, pillowCell(*this, cell));
  }
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
  if (mesh.nodesPerSide < 2 || mesh.paddingLayers < 0 ||
      mesh.nodes.size() != nodeCount(mesh.nodesPerSide, mesh.paddingLayers))
  {
    throw InvalidInput(
      "hexahedral mesh with " + std::to_string(mesh.nodes.size()) + " nodes, " + std::to_string(mesh.nodesPerSide) +
      " a side, " + std::to_string(mesh.paddingLayers) +
      " layers of padding, must be n^3 nodes with n >= 2, and as many as its boundary has in each layer");
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (!mesh.nodes[node].allFinite())
    {
      throw InvalidInput("node " + std::to_string(node) + " has a coordinate that is not finite");
    }
  }
}

void
requireLattice(const HexMesh & mesh)
{
  requireValid(mesh);
  if (mesh.paddingLayers > 0)
  {
    throw InvalidInput("hexahedral mesh with " + std::to_string(mesh.paddingLayers) +
                       " layers of padding, must be a lattice alone");
  }
}

HexMesh
latticePart(const HexMesh & mesh)
{
  const std::size_t nodes = nodeCount(mesh.nodesPerSide, 0);
  return { mesh.nodesPerSide,
           Positions(mesh.nodes.begin(), mesh.nodes.begin() + static_cast<std::ptrdiff_t>(nodes)),
           0 };
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
