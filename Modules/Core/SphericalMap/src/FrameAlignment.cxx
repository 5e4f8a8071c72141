#include "moserhex/SphericalMap/FrameAlignment.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <sstream>

namespace moserhex
{
namespace
{

void
requireSameSize(std::size_t positions, std::size_t vertices)
{
  if (positions != vertices)
  {
    std::ostringstream message;
    message << positions << " directions for " << vertices << " vertices";
    throw InvalidInput(message.str());
  }
}

} // namespace

Matrix3
bestRotation(const Positions & from, const Positions & to, const std::vector<double> & weights)
{
  requireSameSize(from.size(), to.size());
  requireSameSize(weights.size(), to.size());
  if (from.empty())
  {
    throw InvalidInput("no directions to align");
  }
  Matrix3 correlation = Matrix3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    correlation += weights[i] * to[i] * from[i].transpose();
  }
  if (!correlation.allFinite())
  {
    throw InvalidInput("a direction or weight to align is not finite");
  }
  const Eigen::JacobiSVD<Matrix3> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Without the sign the best orthogonal matrix might be a reflection.
  Vector3 signs = Vector3::Ones();
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

Matrix3
bodyFrameRotation(const TriangleMesh & surface, const Positions & sphere)
{
  requireSameSize(sphere.size(), surface.vertices.size());
  const Vector3             centroid = surfaceCentroid(surface);
  const std::vector<double> areas = triangleAreas(surface);
  Positions                 onSphere(areas.size());
  Positions                 inBody(areas.size());
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const Triangle & t = surface.triangles[f];
    onSphere[f] = (sphere[t[0]] + sphere[t[1]] + sphere[t[2]]).normalized();
    const Vector3 centre = (surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3.0;
    inBody[f] = (centre - centroid).normalized();
  }
  return bestRotation(onSphere, inBody, areas);
}

Matrix3
referenceFrameRotation(const TriangleMesh & surface, const Positions & sphere, const Positions & referenceDirections)
{
  requireSameSize(sphere.size(), surface.vertices.size());
  std::vector<double>       mass(surface.vertices.size(), 0.0);
  const std::vector<double> areas = triangleAreas(surface);
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    for (const VertexIndex v : surface.triangles[f])
    {
      mass[v] += areas[f] / 3.0;
    }
  }
  return bestRotation(sphere, referenceDirections, mass);
}

Positions
rotated(const Positions & sphere, const Matrix3 & rotation)
{
  Positions result;
  result.reserve(sphere.size());
  for (const Vector3 & s : sphere)
  {
    result.push_back((rotation * s).normalized());
  }
  return result;
}

} // namespace moserhex
