#include "moserhex/Correspondence/LandmarkErrors.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace moserhex
{
namespace
{

/** Smallest over largest spread of points that do not lie in a plane. */
constexpr double smallestSpread = 1e-12;

void
requirePairs(std::size_t a, std::size_t b)
{
  if (a != b || a == 0)
  {
    throw InvalidInput("corresponding points: " + std::to_string(a) + " and " + std::to_string(b) +
                       ", need as many, and at least one");
  }
}

Vector3
meanOf(const Positions & points)
{
  const Vector3 sum = std::accumulate(points.begin(), points.end(), Vector3(Vector3::Zero()));
  return sum / static_cast<double>(points.size());
}

double
edgeOfMeanCell(const HexMesh & mesh)
{
  const std::vector<double> volumes = cellVolumes(mesh);
  return std::cbrt(std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(volumes.size()));
}

} // namespace

std::vector<double>
pointDistances(const Positions & a, const Positions & b)
{
  requirePairs(a.size(), b.size());
  std::vector<double> distances(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    distances[i] = (a[i] - b[i]).norm();
  }
  return distances;
}

std::vector<double>
innerLandmarkErrors(const HexMesh &                                   baseline,
                    const HexMesh &                                   followUp,
                    const std::function<Vector3(const Vector3 & p)> & deformation)
{
  requireLattice(baseline);
  requireLattice(followUp);
  const int n = baseline.nodesPerSide;
  if (followUp.nodesPerSide != n || n < 3)
  {
    throw InvalidInput("landmark errors: lattices of " + std::to_string(n) + " and " +
                       std::to_string(followUp.nodesPerSide) + " nodes a side, need as many, and at least 3");
  }
  const double        edge = edgeOfMeanCell(followUp);
  std::vector<double> errors;
  for (int k = 1; k + 1 < n; ++k)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      for (int i = 1; i + 1 < n; ++i)
      {
        const std::size_t node = baseline.nodeNumber(i, j, k);
        errors.push_back((followUp.nodes[node] - deformation(baseline.nodes[node])).norm() / edge);
      }
    }
  }
  return errors;
}

Matrix3
affinePart(const Positions & from, const Positions & to)
{
  requirePairs(from.size(), to.size());
  const Vector3 middleFrom = meanOf(from);
  const Vector3 middleTo = meanOf(to);
  Matrix3       squares = Matrix3::Zero();
  Matrix3       products = Matrix3::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const Vector3 x = from[i] - middleFrom;
    squares += x * x.transpose();
    products += (to[i] - middleTo) * x.transpose();
  }
  const Vector3 spread = Eigen::SelfAdjointEigenSolver<Matrix3>(squares).eigenvalues();
  if (!(spread[0] > smallestSpread * spread[2]))
  {
    throw InvalidInput("affine part: the points lie in a plane");
  }
  return products * squares.inverse();
}

double
affinePartError(const HexMesh &                                   baseline,
                const HexMesh &                                   followUp,
                const std::function<Vector3(const Vector3 & p)> & deformation)
{
  Positions expected(baseline.nodes.size());
  std::transform(baseline.nodes.begin(), baseline.nodes.end(), expected.begin(), deformation);
  return (affinePart(baseline.nodes, followUp.nodes) - affinePart(baseline.nodes, expected)).cwiseAbs().maxCoeff();
}

} // namespace moserhex
