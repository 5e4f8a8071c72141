#include "moserhex/Geometry/SignedDistance.h"

#include <cmath>

namespace moserhex
{

SignedDistance::SignedDistance(const TriangleMesh & surface) : m_Search(surface), m_Normals(surface)
{}

double
SignedDistance::operator()(const Vector3 & p) const
{
  const ClosestPointOnSurface nearest = m_Search.closest(p);
  const double                distance = std::sqrt(nearest.squaredDistance);
  return (p - nearest.point).dot(m_Normals.at(nearest)) < 0.0 ? -distance : distance;
}

} // namespace moserhex
