#include "MoserVelocity.h"

#include "LatticeNodes.h"

#include <algorithm>

namespace moserhex
{
namespace
{
using lattice::Index3;

/** Volume ratio below which cells count as this large in the denominator of X_t: folded cells have no density. */
constexpr double smallestDensity = 0.05;

/** Trilinear interpolation of a field on a box of values, first index fastest; the point in index coordinates is
 * clamped to the box. */
double
interpolate(const Eigen::VectorXd & field, const Index3 & size, const Vector3 & point)
{
  Eigen::Index                base = 0;
  std::array<double, 3>       weight{};
  std::array<Eigen::Index, 3> step{};
  Eigen::Index                stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int    last = size[axis] - 1;
    const double coordinate = std::clamp(point[static_cast<Eigen::Index>(axis)], 0.0, static_cast<double>(last));
    const int    below = std::min(static_cast<int>(coordinate), std::max(last - 1, 0));
    weight[axis] = coordinate - below;
    base += stride * below;
    step[axis] = last > 0 ? stride : 0;
    stride *= size[axis];
  }
  const auto alongI = [&](Eigen::Index at) { return field[at] + weight[0] * (field[at + step[0]] - field[at]); };
  const auto overIJ = [&](Eigen::Index at) {
    const double first = alongI(at);
    return first + weight[1] * (alongI(at + step[1]) - first);
  };
  const double below = overIJ(base);
  return below + weight[2] * (overIJ(base + step[2]) - below);
}
} // namespace

MoserFlowOperators::MoserFlowOperators(int nodesPerSide)
  : poisson(nodesPerSide - 1), fluxFromPotential(CubeLatticeOperators(nodesPerSide).fluxFromPotential())
{}

MoserVelocity::MoserVelocity(int                         nodesPerSide,
                             const std::vector<double> & volumes,
                             const MoserFlowOperators &  operators)
  : m_N(nodesPerSide)
{
  const Eigen::Map<const Eigen::VectorXd> volume(volumes.data(), static_cast<Eigen::Index>(volumes.size()));
  const Eigen::VectorXd                   ratio = volume / volume.mean();
  m_Density = ratio.cwiseMax(smallestDensity);

  const Eigen::VectorXd divergence = (1.0 - ratio.array()).matrix();
  const Eigen::VectorXd theta = operators.poisson.solve(divergence);
  const Eigen::VectorXd flux = operators.fluxFromPotential * theta;
  const Eigen::Index    count = flux.size() / 3;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    m_Flux[axis] = flux.segment(static_cast<Eigen::Index>(axis) * count, count);
  }
}

Vector3
MoserVelocity::at(const Vector3 & point, double t) const
{
  const Vector3 centred = point - Vector3::Constant(0.5);
  const int     cells = m_N - 1;
  Vector3       v;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    Index3     size{ cells, cells, cells };
    Vector3    inFaces = centred;
    size[axis] = m_N;
    inFaces[a] = point[a];
    v[a] = interpolate(m_Flux[axis], size, inFaces);
  }
  const double density = interpolate(m_Density, { cells, cells, cells }, centred);
  return -v / ((1.0 - t) * density + t);
}

Vector3
MoserVelocity::originOf(const Vector3 & point, int steps) const
{
  const double dt = 1.0 / steps;
  const double last = m_N - 1;
  Vector3      y = point;
  for (int step = 0; step < steps; ++step)
  {
    const double  t = 1.0 - step * dt;
    const Vector3 k1 = at(y, t);
    const Vector3 k2 = at(y - 0.5 * dt * k1, t - 0.5 * dt);
    const Vector3 k3 = at(y - 0.5 * dt * k2, t - 0.5 * dt);
    const Vector3 k4 = at(y - dt * k3, t - dt);
    y -= dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    y = y.cwiseMax(0.0).cwiseMin(last);
  }
  return y;
}

double
MoserVelocity::largestSpeed() const
{
  double largest = 0.0;
  lattice::forEachNode(m_N, [&](const Index3 & index, std::size_t) {
    const Vector3 point(index[0], index[1], index[2]);
    largest = std::max({ largest, at(point, 0.0).norm(), at(point, 1.0).norm() });
  });
  return largest;
}

} // namespace moserhex
