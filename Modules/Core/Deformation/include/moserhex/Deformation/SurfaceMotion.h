#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <vector>

namespace moserhex
{

/** The boundary quadrilaterals of a lattice in the order of boundaryQuads, all counter-clockwise seen from outside.
 * \throws InvalidInput  as requireLattice */
[[nodiscard]] std::vector<Quadrilateral>
outwardQuads(const HexMesh & mesh);

/** The boundary of a lattice: each quadrilateral as four triangles about the mean of its corners, so that no diagonal
 * is preferred. Vertices: boundaryNodes(mesh) in their order, then a centre for each of the outwardQuads; triangles 4 q
 * ... 4 q + 3 are those of quadrilateral q. \throws InvalidInput  as requireLattice */
[[nodiscard]] TriangleMesh
latticeSurface(const HexMesh & mesh);

/** How the organ's surface has moved. */
struct SurfaceMotion
{
  std::vector<std::size_t> nodes;          ///< numbers of the B boundary nodes, as boundaryNodes
  Positions                normals;        ///< N, outward unit normal of the baseline at each of them, B x 3 [1]
  std::vector<double>      normalMotion;   ///< (x - X) . N, positive outwards, B [mm]
  std::vector<double>      signedDistance; ///< of the follow-up's node from the baseline's surface, outside > 0, B [mm]
  /** Of the baseline's node from the follow-up's surface, inside > 0, so that growth is positive as above, B [mm]. */
  std::vector<double> baselineSignedDistance;
  std::vector<double> area;      ///< of the baseline, 6 (n-1)^2 in the order of boundaryQuads [mm^2]
  std::vector<double> areaRatio; ///< area after / before, 6 (n-1)^2 [1]
};

/** Normal motion follows the nodes, so what slides along the surface and where the surface bends adds to it; the signed
 * distance asks only how far the new surface is from the old one, whichever node is there. On a smooth surface both
 * agree up to the square of the motion over the radius of curvature.
 *
 * A signed distance sees what its own nodes lie on: that of the follow-up a part that has appeared, to its tip, that of
 * the baseline one that has gone. The other of the two passes by: nodes around the foot of a lost finger are no farther
 * from the old surface than the finger is thick. Read the first for growth, the second for shrinkage.
 *
 * Normals are area-weighted over the triangles around a node: O(h^2) on smooth surfaces, O(h) along the cube's edges,
 * where lattice lines bend; on the edges of a box they are the mean of its faces. Areas and distances are those of
 * latticeSurface, O(h^2).
 * \param threads  as in parallelFor; the result does not depend on it
 * \throws InvalidInput  as requireComparable, or a quadrilateral of the baseline has no area (names it) */
[[nodiscard]] SurfaceMotion
surfaceMotion(const HexMesh & baseline, const HexMesh & followUp, unsigned int threads = 1);

} // namespace moserhex
