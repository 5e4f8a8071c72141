#include "moserhex/HexMap/InitialMap.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/SphericalMap/SphereLocator.h"

#include <string>

namespace moserhex
{
namespace
{
void
requireShells(const std::vector<TriangleMesh> & shells, const std::vector<Positions> & sphereMaps)
{
  if (shells.empty())
  {
    throw InvalidInput("no shells, need at least one");
  }
  if (shells.size() != sphereMaps.size())
  {
    throw InvalidInput(std::to_string(shells.size()) + " shells but " + std::to_string(sphereMaps.size()) +
                       " sphere maps");
  }
  for (std::size_t k = 0; k < shells.size(); ++k)
  {
    if (shells[k].vertices.size() != sphereMaps[k].size())
    {
      throw InvalidInput("shell " + std::to_string(k + 1) + " has " + std::to_string(shells[k].vertices.size()) +
                         " vertices, its sphere map " + std::to_string(sphereMaps[k].size()));
    }
  }
}

/** Point of a surface whose image on the sphere is `direction`. */
Vector3
pointOnShell(const TriangleMesh & shell, const SphereLocator & locator, const Vector3 & direction)
{
  const SphereLocator::Hit hit = locator.locate(direction);
  const Triangle &         triangle = shell.triangles[static_cast<std::size_t>(hit.triangle)];
  Vector3                  point = Vector3::Zero();
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    point +=
      hit.barycentric[static_cast<Eigen::Index>(corner)] * shell.vertices[static_cast<std::size_t>(triangle[corner])];
  }
  return point;
}
} // namespace

HexMesh
initialMap(const std::vector<TriangleMesh> & shells,
           const std::vector<Positions> &    sphereMaps,
           const InitialMapOptions &         options,
           const ProgressCallback &          progress)
{
  requireShells(shells, sphereMaps);
  const CubeLattice lattice(static_cast<int>(shells.size()));
  HexMesh           mesh{ lattice.nodesPerSide(), Positions(lattice.nodeCount()) };

  reportProgress(progress, 0.0);
  parallelFor(shells.size(), options.threads, [&](std::size_t i) {
    const std::size_t              k = shells.size() - 1 - i; // the largest shells first, so that threads end together
    const int                      shell = static_cast<int>(k) + 1;
    const SphereLocator            locator(shells[k].triangles, sphereMaps[k]);
    const std::vector<std::size_t> nodes = lattice.nodesOfShell(shell);
    const Positions                directions = cubeShellMap(lattice, shell, options.cubeShells);
    for (std::size_t m = 0; m < nodes.size(); ++m)
    {
      const Vector3 point = pointOnShell(shells[k], locator, directions[m]);
      mesh.nodes[nodes[m]] = options.projection ? options.projection(shell, point) : point;
    }
  });
  reportProgress(progress, 1.0);
  return mesh;
}

} // namespace moserhex
