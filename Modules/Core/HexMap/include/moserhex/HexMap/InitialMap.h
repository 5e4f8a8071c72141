#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMap/CubeShellMaps.h"

#include <functional>
#include <vector>

namespace moserhex
{

/** Puts a point near shell k (1..N) onto that shell's exact level set [mm]. Must be pure and thread-safe. */
using ShellProjection = std::function<Vector3(int shell, const Vector3 & point)>;

/** Options of initialMap. */
struct InitialMapOptions
{
  CubeShellMapOptions cubeShells; ///< stage F

  /** Applied to every node after the barycentric interpolation, so that nodes lie on the smooth surface and not on
   * the chords of its triangles. Empty: none. */
  ShellProjection projection;

  unsigned int threads{ 0 }; ///< 0: all of the machine's; the result does not depend on it
};

/** The initial map f of the paper, stage G: for every shell k, node of the cube shell -> sphere -> shell k.
 *
 *   f = q_k^-1 o Q_k,   Q_k the cube shell's map to the sphere (stage F), q_k shell k's own (stages D, E)
 *
 * The spherical triangle that holds the direction is found by a tree (SphereLocator), the point is interpolated with
 * its barycentric weights. The shells are connected by the cube's own connectivity.
 *
 * \param shells      shells[k-1] = shell k, closed, genus 0, outward [mm]; N = shells.size() >= 1
 * \param sphereMaps  sphereMaps[k-1] = one unit vector per vertex of shell k, no flipped triangle, all in one frame
 * \return mesh of (2N)^3 nodes; node (i,j,k) grows towards +x, +y, +z of the sphere's frame (LPS)
 * \throws InvalidInput  no shell, or a map with another number of vertices than its shell
 * \note O(nodes log triangles). Deterministic for any number of threads. */
[[nodiscard]] HexMesh
initialMap(const std::vector<TriangleMesh> & shells,
           const std::vector<Positions> &    sphereMaps,
           const InitialMapOptions &         options = {},
           const ProgressCallback &          progress = {});

} // namespace moserhex
