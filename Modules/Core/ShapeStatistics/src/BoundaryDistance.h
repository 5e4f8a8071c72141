#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMap/SignedDistance.h"

namespace moserhex
{

/** The boundary of a mesh, each quadrilateral as two triangles; vertices are the mesh's nodes on its boundary. */
[[nodiscard]] TriangleMesh
boundaryTriangles(const HexMesh & mesh);

/** Signed distance to the boundary of a mesh, each quadrilateral as two triangles. The sign is right everywhere
 * (Pseudonormals) where the boundary does not cut itself; the gradient is the vertex normals', interpolated at the
 * nearest point. Shares what it needs of the mesh.
 * \throws InvalidInput  as requireValid(mesh) */
[[nodiscard]] SignedDistance
boundaryDistance(const HexMesh & mesh);

} // namespace moserhex
