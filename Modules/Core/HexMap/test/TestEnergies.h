#pragma once

#include "LatticeVector.h"
#include "TestLattices.h"
#include "moserhex/Analytic/ObservedOrder.h"

#include <cmath>
#include <functional>
#include <vector>

namespace moserhex::testing
{

/** Of a lattice vector: adds its gradient, returns its value. */
using LatticeEnergy = std::function<double(const Eigen::VectorXd & x, Eigen::VectorXd & gradient)>;

inline Eigen::VectorXd
vectorOf(const HexMesh & mesh)
{
  return latticeVector(LatticeLayout(mesh.nodesPerSide, mesh.paddingLayers), mesh.nodes, Vector3::Zero(), 1.0);
}

/** Cells of edge 1, every node moved by up to `amplitude` in every coordinate: from 0.3 on some corners are inverted,
 * from 1 on most. */
inline HexMesh
unitCells(int n, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  return mappedLattice(n, [&](const Vector3 & x) {
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const double c = random.uniform(-1, 1);
    return Vector3((n - 1.0) * x + amplitude * Vector3(a, b, c));
  });
}

/** The same with layers of padding. */
inline HexMesh
paddedUnitCells(int n, int layers, double amplitude, std::uint64_t seed)
{
  Random random(seed);
  return analytic::paddedLattice(n, layers, [&](const Vector3 & index) {
    const double a = random.uniform(-1, 1);
    const double b = random.uniform(-1, 1);
    const double c = random.uniform(-1, 1);
    return Vector3(index + amplitude * Vector3(a, b, c));
  });
}

inline double
valueAt(const LatticeEnergy & energy, const Eigen::VectorXd & x)
{
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
  return energy(x, gradient);
}

inline Eigen::VectorXd
gradientAt(const LatticeEnergy & energy, const Eigen::VectorXd & x)
{
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(x.size());
  (void)energy(x, gradient);
  return gradient;
}

/** Fitted order of |E(x + t d) - E(x) - t dE.d| in t for a random d; t down from `largestStep` by halves. */
inline double
taylorOrder(const LatticeEnergy & energy, const HexMesh & mesh, double largestStep)
{
  const Eigen::VectorXd x = vectorOf(mesh);
  const auto            cells = [&mesh](double amplitude) {
    return vectorOf(paddedUnitCells(mesh.nodesPerSide, mesh.paddingLayers, amplitude, 17));
  };
  const Eigen::VectorXd direction = cells(1.0) - cells(0.0);
  Eigen::VectorXd       gradient = Eigen::VectorXd::Zero(x.size());
  const double          value = energy(x, gradient);
  std::vector<double>   steps;
  std::vector<double>   remainders;
  for (double step = largestStep; step > 0.1 * largestStep; step *= 0.5)
  {
    steps.push_back(step);
    remainders.push_back(std::abs(valueAt(energy, x + step * direction) - value - step * gradient.dot(direction)));
  }
  return analytic::observedOrder(steps, remainders);
}

} // namespace moserhex::testing
