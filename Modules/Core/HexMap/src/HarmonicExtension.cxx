#include "HarmonicExtension.h"

#include "LatticeNodes.h"
#include "moserhex/Numerics/CosineTransform.h"

#include <cmath>

namespace moserhex
{
using lattice::Index3;

void
diffuseInteriorInPlace(HexMesh & values, double tau)
{
  const int n = values.nodesPerSide;
  const int inner = n - 2;
  if (inner < 1)
  {
    return;
  }
  const DirichletLatticeSolver solver(inner);
  const Eigen::Index           count = static_cast<Eigen::Index>(inner) * inner * inner;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    Eigen::VectorXd field(count);
    Eigen::VectorXd fromBoundary = Eigen::VectorXd::Zero(count);
    Eigen::Index    entry = 0;
    const auto      isInterior = [&](const Index3 & at) { return !lattice::isBoundary(n, at); };
    lattice::forEachNode(n, [&](const Index3 & at, std::size_t node) {
      if (!isInterior(at))
      {
        return;
      }
      field[entry] = values.nodes[node][axis];
      for (const Index3 & step : lattice::neighbourSteps)
      {
        const Index3 neighbour{ at[0] + step[0], at[1] + step[1], at[2] + step[2] };
        if (!isInterior(neighbour))
        {
          fromBoundary[entry] += values.nodes[lattice::number(values, neighbour)][axis];
        }
      }
      ++entry;
    });
    const Eigen::VectorXd harmonic = solver.solvePoisson(fromBoundary);
    const Eigen::VectorXd result =
      std::isfinite(tau) ? Eigen::VectorXd(harmonic + solver.solveHeatStep(field - harmonic, tau)) : harmonic;
    entry = 0;
    lattice::forEachNode(n, [&](const Index3 & at, std::size_t node) {
      if (isInterior(at))
      {
        values.nodes[node][axis] = result[entry++];
      }
    });
  }
}

void
extendOverFacesInPlace(HexMesh & values)
{
  const int n = values.nodesPerSide;
  const int inner = n - 2;
  if (inner < 1)
  {
    return;
  }
  const Eigen::MatrixXd sines = sineMatrix(inner);
  const Eigen::VectorXd eigenvalues = laplacianEigenvalues(inner, CubeTransform::Basis::Sine);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int level : { 0, n - 1 })
    {
      const auto value = [&](int a, int b) -> Vector3 & {
        Index3 at{};
        at[axis] = level;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return values.nodes[lattice::number(values, at)];
      };
      for (Eigen::Index component = 0; component < 3; ++component)
      {
        Eigen::MatrixXd field = Eigen::MatrixXd::Zero(inner, inner);
        for (int a = 0; a < inner; ++a)
        {
          field(a, 0) += value(a + 1, 0)[component];
          field(a, inner - 1) += value(a + 1, n - 1)[component];
          field(0, a) += value(0, a + 1)[component];
          field(inner - 1, a) += value(n - 1, a + 1)[component];
        }
        Eigen::MatrixXd spectrum = sines * field * sines;
        for (int b = 0; b < inner; ++b)
        {
          spectrum.col(b).array() /= eigenvalues.array() + eigenvalues[b];
        }
        field = sines * spectrum * sines;
        for (int b = 0; b < inner; ++b)
        {
          for (int a = 0; a < inner; ++a)
          {
            value(a + 1, b + 1)[component] = field(a, b);
          }
        }
      }
    }
  }
}

} // namespace moserhex
