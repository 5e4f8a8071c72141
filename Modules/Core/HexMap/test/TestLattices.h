#pragma once

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Random.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/SurfaceProjection.h"
#include "moserhex/StructuredGrid/CubeLattice.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <cmath>

namespace moserhex::testing
{

/** Lattice over [0,1]^3 whose node (x,y,z) lies at map(x,y,z). */
template <typename TMap>
HexMesh
mappedLattice(int n, TMap map)
{
  return analytic::lattice(n, [&](const Vector3 & index) { return Vector3(map(index / (n - 1.0))); });
}

inline HexMesh
regularLattice(int n)
{
  return mappedLattice(n, [](const Vector3 & x) { return x; });
}

inline bool
onBoundary(int n, std::size_t node)
{
  const auto        m = static_cast<std::size_t>(n);
  const std::size_t index[3] = { node % m, node / m % m, node / m / m };
  return index[0] == 0 || index[1] == 0 || index[2] == 0 || index[0] == m - 1 || index[1] == m - 1 || index[2] == m - 1;
}

/** Inner nodes moved by up to `amplitude` in every coordinate. */
inline HexMesh
shaken(HexMesh mesh, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    const Vector3 shift(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (!onBoundary(mesh.nodesPerSide, node))
    {
      mesh.nodes[node] += amplitude * shift;
    }
  }
  return mesh;
}

/** A star-shaped organ r(direction) with homothetic shells, filled along rays: volumes vary like r^3. */
template <typename TRadius>
HexMesh
starShapedMesh(int shells, TRadius radius)
{
  const CubeLattice lattice(shells);
  HexMesh           mesh{ lattice.nodesPerSide(), Positions(lattice.nodeCount()) };
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    const Vector3 direction = cubeToSphere(lattice.positionOnShell(node));
    mesh.nodes[node] = lattice.relativeSize(lattice.shellOfNode(node)) * radius(direction) * direction;
  }
  return mesh;
}

/** Onto the star-shaped surface along the ray: slides well enough where the surface is not steep. */
template <typename TRadius>
SurfaceProjection
alongRays(TRadius radius)
{
  return [radius](const Vector3 & p) {
    const Vector3 direction = p.normalized();
    return Vector3(radius(direction) * direction);
  };
}

/** Ten lobes and ten hollows, 16 % of the radius. */
inline double
bumpyRadius(const Vector3 & d)
{
  const double planar = std::pow(d[0], 5) - 10 * std::pow(d[0], 3) * d[1] * d[1] + 5 * d[0] * std::pow(d[1], 4);
  return 20.0 * (1.0 + 0.6 * planar * d[2]);
}

/** Ellipsoid 3:2:2. */
inline double
ellipsoidRadius(const Vector3 & d)
{
  return 10.0 / d.cwiseQuotient(Vector3(3, 2, 2)).norm();
}

} // namespace moserhex::testing
