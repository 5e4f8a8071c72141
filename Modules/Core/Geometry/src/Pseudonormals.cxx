#include "moserhex/Geometry/Pseudonormals.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace moserhex
{
namespace
{

Positions
faceNormals(const TriangleMesh & surface)
{
  Positions normals;
  normals.reserve(surface.triangles.size());
  for (const Triangle & t : surface.triangles)
  {
    const Vector3 & a = surface.vertices[t[0]];
    normals.push_back((surface.vertices[t[1]] - a).cross(surface.vertices[t[2]] - a).normalized());
  }
  return normals;
}

using Edge = std::pair<VertexIndex, VertexIndex>;

/** The edge opposite to a corner, the same for both its triangles. */
Edge
edgeOf(const Triangle & t, std::size_t corner)
{
  return std::minmax(t[(corner + 1) % 3], t[(corner + 2) % 3]);
}

std::vector<std::array<Vector3, 3>>
edgeNormals(const std::vector<Triangle> & triangles, const Positions & normals)
{
  std::map<Edge, std::pair<Vector3, int>> sums;
  for (std::size_t face = 0; face < triangles.size(); ++face)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      auto & [sum, count] = sums.try_emplace(edgeOf(triangles[face], corner), Vector3::Zero(), 0).first->second;
      sum += normals[face];
      ++count;
    }
  }
  std::vector<std::array<Vector3, 3>> result(triangles.size());
  for (std::size_t face = 0; face < triangles.size(); ++face)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Edge edge = edgeOf(triangles[face], corner);
      const auto & [sum, count] = sums.at(edge);
      if (count != 2)
      {
        throw InvalidInput("pseudonormals: the edge of vertices " + std::to_string(edge.first) + " and " +
                           std::to_string(edge.second) + " has " + std::to_string(count) + " triangles, need 2");
      }
      result[face][corner] = sum;
    }
  }
  return result;
}

Positions
angleWeightedNormals(const TriangleMesh & surface, const Positions & normals)
{
  Positions result(surface.vertices.size(), Vector3::Zero());
  for (std::size_t face = 0; face < surface.triangles.size(); ++face)
  {
    const Triangle & t = surface.triangles[face];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Vector3 & at = surface.vertices[t[corner]];
      const Vector3   a = surface.vertices[t[(corner + 1) % 3]] - at;
      const Vector3   b = surface.vertices[t[(corner + 2) % 3]] - at;
      result[t[corner]] += std::atan2(a.cross(b).norm(), a.dot(b)) * normals[face];
    }
  }
  return result;
}

} // namespace

Pseudonormals::Pseudonormals(const TriangleMesh & surface)
  : m_Triangles(surface.triangles)
  , m_FaceNormals(faceNormals(surface))
  , m_EdgeNormals(edgeNormals(surface.triangles, m_FaceNormals))
  , m_VertexNormals(angleWeightedNormals(surface, m_FaceNormals))
{}

Vector3
Pseudonormals::at(const ClosestPointOnSurface & nearest) const
{
  const auto      face = static_cast<std::size_t>(nearest.triangle);
  const Vector3 & weights = nearest.barycentric;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    if (weights[static_cast<Eigen::Index>(corner)] == 1.0)
    {
      return m_VertexNormals[m_Triangles[face][corner]];
    }
  }
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    if (weights[static_cast<Eigen::Index>(corner)] == 0.0)
    {
      return m_EdgeNormals[face][corner];
    }
  }
  return m_FaceNormals[face];
}

} // namespace moserhex
