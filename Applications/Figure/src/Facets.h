#pragma once

#include "Camera.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <cstddef>
#include <vector>

namespace moserhex::app
{

/** The faces of these cells that no other of them shares and that look at the viewer; of a warped one the half that
 * does. Light comes from beside the viewer, above and to the left; 1 on faces that look there, 0.7 on those at right
 * angles.
 */
[[nodiscard]] std::vector<SeenFacet>
facesSeen(const UnstructuredHexMesh & mesh, const std::vector<std::size_t> & cells, const Camera & camera);

/** What a plane across LPS axis `axis` (0 L, 1 P, 2 S) at `position` cuts out of every cell: one polygon for a cell,
 * with a corner on each edge that the plane crosses. Exact for convex cells with plane faces; in others the section is
 * the polygon with these corners in the order of their angle around their centre. \param position  [mm] */
[[nodiscard]] std::vector<SeenFacet>
sectionsSeen(const UnstructuredHexMesh & mesh, int axis, double position, const Camera & camera);

/** The cells of one layer of the lattice, i, j or k (axis 0, 1, 2) = index, as the quadrilaterals in their middle:
 * corners halfway along the edges across the layer. Lit from both sides. \throws InvalidInput  index not in [0, n-2] */
[[nodiscard]] std::vector<SeenFacet>
layerSeen(const HexMesh & lattice, int axis, int index, const Camera & camera);

/** Middle of every cell in the cube [0,1]^3; of padding, on the face of the cube that it stands on. */
[[nodiscard]] Positions
cellPlaces(const HexMesh & lattice);

/** Those of the cells that are left when the eighth of the cube nearest the viewer is taken away, the middle layers
 * kept. \param places  as by cellPlaces */
[[nodiscard]] std::vector<std::size_t>
withoutNearestOctant(const std::vector<std::size_t> & cells, const Positions & places, const Camera & camera);

} // namespace moserhex::app
