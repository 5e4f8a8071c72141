#include "BoundaryDistance.h"

#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/Pseudonormals.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include <cmath>
#include <memory>

namespace moserhex
{
namespace
{

struct Boundary
{
  TriangleMesh       surface;
  Positions          normals;
  ClosestPointSearch search;
  Pseudonormals      sides;

  explicit Boundary(TriangleMesh triangles)
    : surface(std::move(triangles)), normals(vertexNormals(surface)), search(surface), sides(surface)
  {}

  double
  distance(const Vector3 & point, Vector3 & gradient) const
  {
    const ClosestPointOnSurface closest = search.closest(point);
    const Triangle &            corners = surface.triangles[static_cast<std::size_t>(closest.triangle)];
    gradient.setZero();
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      gradient +=
        closest.barycentric[static_cast<Eigen::Index>(corner)] * normals[static_cast<std::size_t>(corners[corner])];
    }
    gradient.normalize();
    const double length = std::sqrt(closest.squaredDistance);
    return (point - closest.point).dot(sides.at(closest)) < 0.0 ? -length : length;
  }
};

} // namespace

TriangleMesh
boundaryTriangles(const HexMesh & mesh)
{
  TriangleMesh             surface;
  std::vector<VertexIndex> vertexOfNode(mesh.nodes.size(), -1);
  for (const std::size_t node : boundaryNodes(mesh))
  {
    vertexOfNode[node] = static_cast<VertexIndex>(surface.vertices.size());
    surface.vertices.push_back(mesh.nodes[node]);
  }
  for (const Quadrilateral & quad : boundaryFaces(unstructured(mesh)))
  {
    const auto vertex = [&](std::size_t corner) { return vertexOfNode[quad[corner]]; };
    surface.triangles.push_back({ vertex(0), vertex(1), vertex(2) });
    surface.triangles.push_back({ vertex(0), vertex(2), vertex(3) });
  }
  return surface;
}

SignedDistance
boundaryDistance(const HexMesh & mesh)
{
  requireValid(mesh);
  const auto boundary = std::make_shared<const Boundary>(boundaryTriangles(mesh));
  return [boundary](const Vector3 & point, Vector3 & gradient) { return boundary->distance(point, gradient); };
}

} // namespace moserhex
