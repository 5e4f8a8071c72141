#include "moserhex/DiscreteCalculus/TriangleOperators.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

using Triplet = Eigen::Triplet<double>;

void
requireFinite(const Positions & positions)
{
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    if (!positions[v].allFinite())
    {
      std::ostringstream message;
      message << "position of vertex " << v << " is not finite";
      throw InvalidInput(message.str());
    }
  }
}

/** Cotangent of the angle between u and v; sines below 1e-6 are raised to 1e-6. Zero for an edge of no length. */
double
boundedCotangent(const Vector3 & u, const Vector3 & v)
{
  constexpr double smallestSine = 1e-6;
  const double     lengths = u.norm() * v.norm();
  const double     sine = std::max(u.cross(v).norm(), smallestSine * lengths);
  return sine > 0.0 ? u.dot(v) / sine : 0.0;
}

SparseMatrix
diagonal(const std::vector<double> & values)
{
  const auto   n = static_cast<Eigen::Index>(values.size());
  SparseMatrix result(n, n);
  result.reserve(Eigen::VectorXi::Constant(n, 1));
  for (Eigen::Index i = 0; i < n; ++i)
  {
    result.insert(i, i) = values[static_cast<std::size_t>(i)];
  }
  result.makeCompressed();
  return result;
}

SparseMatrix
fromTriplets(std::size_t rows, std::size_t columns, const std::vector<Triplet> & triplets)
{
  SparseMatrix result(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

} // namespace

SparseMatrix
d0(const TriangleTopology & topology, std::size_t vertexCount)
{
  std::vector<Triplet> triplets;
  triplets.reserve(2 * topology.edges.size());
  for (std::size_t e = 0; e < topology.edges.size(); ++e)
  {
    triplets.emplace_back(static_cast<int>(e), topology.edges[e][0], -1.0);
    triplets.emplace_back(static_cast<int>(e), topology.edges[e][1], 1.0);
  }
  return fromTriplets(topology.edges.size(), vertexCount, triplets);
}

SparseMatrix
d1(const TriangleMesh & mesh, const TriangleTopology & topology)
{
  std::vector<Triplet> triplets;
  triplets.reserve(3 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int  e = topology.triangleEdges[f][k];
      const bool along = mesh.triangles[f][k] == topology.edges[e][0];
      triplets.emplace_back(static_cast<int>(f), e, along ? 1.0 : -1.0);
    }
  }
  return fromTriplets(mesh.triangles.size(), topology.edges.size(), triplets);
}

std::vector<double>
cotanWeights(const TriangleMesh & mesh, const TriangleTopology & topology)
{
  requireFinite(mesh.vertices);
  std::vector<double> weights(topology.edges.size(), 0.0);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    const Triangle & t = mesh.triangles[f];
    for (int k = 0; k < 3; ++k)
    {
      // Side k is opposite the corner k+2.
      const Vector3 & corner = mesh.vertices[t[(k + 2) % 3]];
      const Vector3   u = mesh.vertices[t[k]] - corner;
      const Vector3   v = mesh.vertices[t[(k + 1) % 3]] - corner;
      weights[topology.triangleEdges[f][k]] += 0.5 * boundedCotangent(u, v);
    }
  }
  return weights;
}

std::vector<double>
clampedCotanWeights(const TriangleMesh & mesh, const TriangleTopology & topology, double smallest, double largest)
{
  if (!(smallest > 0.0) || !(largest >= smallest) || !std::isfinite(largest))
  {
    std::ostringstream message;
    message << "weights from " << smallest << " to " << largest << ", need 0 < smallest <= largest";
    throw InvalidInput(message.str());
  }
  std::vector<double> weights = cotanWeights(mesh, topology);
  for (double & weight : weights)
  {
    weight = std::min(std::max(weight, smallest), largest);
  }
  return weights;
}

std::vector<double>
lumpedMass(const TriangleMesh & mesh)
{
  const std::vector<double> areas = triangleAreas(mesh);
  std::vector<double>       mass(mesh.vertices.size(), 0.0);
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    for (const VertexIndex v : mesh.triangles[f])
    {
      mass[v] += areas[f] / 3.0;
    }
  }
  return mass;
}

SparseMatrix
star0(const TriangleMesh & mesh)
{
  return diagonal(lumpedMass(mesh));
}

SparseMatrix
star1(const TriangleMesh & mesh, const TriangleTopology & topology)
{
  return diagonal(cotanWeights(mesh, topology));
}

SparseMatrix
weightedLaplacian(const TriangleTopology & topology, const std::vector<double> & edgeWeights, std::size_t vertexCount)
{
  if (edgeWeights.size() != topology.edges.size())
  {
    std::ostringstream message;
    message << edgeWeights.size() << " weights for " << topology.edges.size() << " edges";
    throw InvalidInput(message.str());
  }
  std::vector<double>  sums(vertexCount, 0.0);
  std::vector<Triplet> triplets;
  triplets.reserve(2 * edgeWeights.size() + vertexCount);
  for (std::size_t e = 0; e < edgeWeights.size(); ++e)
  {
    const Edge & edge = topology.edges[e];
    triplets.emplace_back(edge[0], edge[1], -edgeWeights[e]);
    triplets.emplace_back(edge[1], edge[0], -edgeWeights[e]);
    sums[edge[0]] += edgeWeights[e];
    sums[edge[1]] += edgeWeights[e];
  }
  for (std::size_t v = 0; v < vertexCount; ++v)
  {
    triplets.emplace_back(static_cast<int>(v), static_cast<int>(v), sums[v]);
  }
  return fromTriplets(vertexCount, vertexCount, triplets);
}

SparseMatrix
cotanLaplacian(const TriangleMesh & mesh)
{
  const TriangleTopology topology = triangleTopology(mesh);
  return weightedLaplacian(topology, cotanWeights(mesh, topology), mesh.vertices.size());
}

} // namespace moserhex
