#include "moserhex/Geometry/TriangleMesh.h"

#include <Eigen/Geometry>

namespace moserhex
{

double
triangleArea(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

std::vector<double>
triangleAreas(const TriangleMesh & mesh)
{
  std::vector<double> areas;
  areas.reserve(mesh.triangles.size());
  for (const Triangle & t : mesh.triangles)
  {
    areas.push_back(triangleArea(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
  }
  return areas;
}

double
surfaceArea(const TriangleMesh & mesh)
{
  double sum = 0.0;
  for (const double area : triangleAreas(mesh))
  {
    sum += area;
  }
  return sum;
}

double
enclosedVolume(const TriangleMesh & mesh)
{
  if (mesh.triangles.empty())
  {
    return 0.0;
  }
  // Seen from a vertex of the mesh, not from the origin: a small organ far from the origin keeps its digits.
  const Vector3 apex = mesh.vertices[mesh.triangles.front()[0]];
  double        sum = 0.0;
  for (const Triangle & t : mesh.triangles)
  {
    const Vector3 a = mesh.vertices[t[0]] - apex;
    const Vector3 b = mesh.vertices[t[1]] - apex;
    const Vector3 c = mesh.vertices[t[2]] - apex;
    sum += a.dot(b.cross(c));
  }
  return sum / 6.0;
}

Vector3
surfaceCentroid(const TriangleMesh & mesh)
{
  Vector3 moment = Vector3::Zero();
  double  total = 0.0;
  for (const Triangle & t : mesh.triangles)
  {
    const Vector3 & a = mesh.vertices[t[0]];
    const Vector3 & b = mesh.vertices[t[1]];
    const Vector3 & c = mesh.vertices[t[2]];
    const double    area = triangleArea(a, b, c);
    moment += area / 3.0 * (a + b + c);
    total += area;
  }
  return total > 0.0 ? Vector3(moment / total) : Vector3::Zero();
}

Positions
vertexNormals(const TriangleMesh & mesh)
{
  Positions normals(mesh.vertices.size(), Vector3::Zero());
  for (const Triangle & t : mesh.triangles)
  {
    const Vector3 & a = mesh.vertices[t[0]];
    const Vector3   doubleArea = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    for (const VertexIndex v : t)
    {
      normals[v] += doubleArea;
    }
  }
  for (Vector3 & normal : normals)
  {
    const double length = normal.norm();
    normal = length > 0.0 ? Vector3(normal / length) : Vector3::Zero();
  }
  return normals;
}

BoundingBox
boundingBox(const Positions & points)
{
  BoundingBox box;
  if (points.empty())
  {
    return box;
  }
  box.lower = box.upper = points.front();
  for (const Vector3 & p : points)
  {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

} // namespace moserhex
