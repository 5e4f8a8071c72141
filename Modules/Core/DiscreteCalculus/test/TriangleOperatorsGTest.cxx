// Identities: round-off class, 1e-12 relative to the largest entry. Harmonics: discretisation class, the order is
// checked by a fitted slope over four refinements (within 0.1 of 2), the value by its closed form l(l+1).
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

/** An ellipsoid with a bump: obtuse triangles and negative weights among them. */
TriangleMesh
bumpySurface(int levels)
{
  TriangleMesh mesh = analytic::starShapedSurface(
    levels, [](const Vector3 & n) { return 20.0 * (1.0 + 0.3 * n[0] * n[1] * n[2] + 0.2 * n[2] * n[2]); });
  for (Vector3 & p : mesh.vertices)
  {
    p[0] *= 3.0;
  }
  return mesh;
}

double
largestEntry(const SparseMatrix & A)
{
  return Eigen::MatrixXd(A).cwiseAbs().maxCoeff();
}

/** Rayleigh quotient f^T L f / f^T M f of a function on the vertices. */
double
rayleighQuotient(const TriangleMesh & mesh, double (*f)(const Vector3 &))
{
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
  {
    values[static_cast<Eigen::Index>(v)] = f(mesh.vertices[v]);
  }
  return values.dot(cotanLaplacian(mesh) * values) / values.dot(star0(mesh) * values);
}

} // namespace

TEST(TriangleOperators, BoundaryOfABoundaryIsZero)
{
  const TriangleMesh     mesh = bumpySurface(2);
  const TriangleTopology topology = triangleTopology(mesh);
  const SparseMatrix     product = d1(mesh, topology) * d0(topology, mesh.vertices.size());
  EXPECT_EQ(largestEntry(product), 0.0);
}

TEST(TriangleOperators, LaplacianIsD0TransposedStar1D0)
{
  const TriangleMesh     mesh = bumpySurface(2);
  const TriangleTopology topology = triangleTopology(mesh);
  const SparseMatrix     D0 = d0(topology, mesh.vertices.size());
  const SparseMatrix     product = SparseMatrix(D0.transpose()) * star1(mesh, topology) * D0;
  const SparseMatrix     L = cotanLaplacian(mesh);
  EXPECT_LT(largestEntry(product - L), 1e-12 * largestEntry(L));
}

TEST(TriangleOperators, LaplacianOfAConstantIsZero)
{
  const TriangleMesh mesh = bumpySurface(3);
  const SparseMatrix L = cotanLaplacian(mesh);
  EXPECT_LT((L * Eigen::VectorXd::Ones(L.cols())).cwiseAbs().maxCoeff(), 1e-12 * largestEntry(L));
}

TEST(TriangleOperators, LaplacianIsPositiveSemidefiniteWithNegativeWeights)
{
  const TriangleMesh        mesh = bumpySurface(2);
  const TriangleTopology    topology = triangleTopology(mesh);
  const std::vector<double> weights = cotanWeights(mesh, topology);
  ASSERT_LT(*std::min_element(weights.begin(), weights.end()), -0.1) << "the shape must have obtuse triangles";
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(cotanLaplacian(mesh)));
  EXPECT_GT(eigen.eigenvalues()[0], -1e-12 * eigen.eigenvalues().maxCoeff());
  EXPECT_GT(eigen.eigenvalues()[1], 1e-3) << "constants are the only kernel";
}

TEST(TriangleOperators, LinearFunctionHasItsDirichletEnergy)
{
  // x^T L x of the coordinate x is the integral of |grad_S x|^2 = 1 - n_x^2, summed over x, y, z: twice the area.
  const TriangleMesh mesh = bumpySurface(2);
  const SparseMatrix L = cotanLaplacian(mesh);
  double             energy = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Eigen::VectorXd x(L.cols());
    for (Eigen::Index v = 0; v < x.size(); ++v)
    {
      x[v] = mesh.vertices[static_cast<std::size_t>(v)][axis];
    }
    energy += x.dot(L * x);
  }
  EXPECT_NEAR(energy, 2.0 * surfaceArea(mesh), 1e-12 * surfaceArea(mesh));
}

TEST(TriangleOperators, LumpedMassSumsToTheArea)
{
  const TriangleMesh mesh = bumpySurface(3);
  double             sum = 0.0;
  for (const double m : lumpedMass(mesh))
  {
    sum += m;
  }
  EXPECT_NEAR(sum, surfaceArea(mesh), 1e-12 * surfaceArea(mesh));
}

TEST(TriangleOperators, SphericalHarmonicsHaveEigenvaluesWithOrderTwo)
{
  struct Harmonic
  {
    double eigenvalue;
    double (*f)(const Vector3 &);
  };
  const Harmonic harmonics[] = {
    { 6.0, [](const Vector3 & n) { return n[0] * n[1]; } },
    { 12.0, [](const Vector3 & n) { return n[0] * n[1] * n[2]; } },
  };
  for (const Harmonic & harmonic : harmonics)
  {
    std::vector<double> h;
    std::vector<double> errors;
    for (int level = 2; level <= 5; ++level)
    {
      h.push_back(std::pow(0.5, level));
      errors.push_back(std::abs(rayleighQuotient(analytic::icosphere(level), harmonic.f) - harmonic.eigenvalue));
    }
    EXPECT_NEAR(analytic::observedOrder(h, errors), 2.0, 0.1) << "eigenvalue " << harmonic.eigenvalue;
    EXPECT_LT(errors.back(), 5e-3 * harmonic.eigenvalue);
  }
}

TEST(TriangleOperators, FirstHarmonicOfTheIcosphereIsExact)
{
  // By the icosahedron's symmetry z^T L z = 2 area / 3 and z^T M z = area / 3 on every level.
  for (int level = 0; level <= 3; ++level)
  {
    EXPECT_NEAR(rayleighQuotient(analytic::icosphere(level), [](const Vector3 & n) { return n[2]; }), 2.0, 1e-12);
  }
}

TEST(TriangleOperators, WeightsDoNotChangeWithScale)
{
  const TriangleMesh        mesh = bumpySurface(2);
  const TriangleTopology    topology = triangleTopology(mesh);
  const std::vector<double> weights = cotanWeights(mesh, topology);
  for (const double scale : { 1e-8, 1e8 })
  {
    TriangleMesh scaled = mesh;
    for (Vector3 & p : scaled.vertices)
    {
      p *= scale;
    }
    const std::vector<double> scaledWeights = cotanWeights(scaled, topology);
    for (std::size_t e = 0; e < weights.size(); ++e)
    {
      EXPECT_NEAR(scaledWeights[e], weights[e], 1e-9 * (1.0 + std::abs(weights[e])));
    }
  }
}

TEST(TriangleOperators, ClampedWeightsLieInTheirRange)
{
  const TriangleMesh     mesh = bumpySurface(2);
  const TriangleTopology topology = triangleTopology(mesh);
  const auto             plain = cotanWeights(mesh, topology);
  const auto             clamped = clampedCotanWeights(mesh, topology, 0.3, 0.8);
  for (std::size_t e = 0; e < plain.size(); ++e)
  {
    EXPECT_EQ(clamped[e], std::min(std::max(plain[e], 0.3), 0.8));
  }
}

TEST(TriangleOperators, DegenerateTrianglesHaveFiniteWeights)
{
  TriangleMesh mesh = analytic::icosphere(1);
  mesh.vertices[5] = mesh.vertices[mesh.triangles[0][0] == 5 ? mesh.triangles[0][1] : mesh.triangles[0][0]];
  for (Vector3 & p : mesh.vertices)
  {
    p[2] = 0.0;
  }
  for (const double weight : cotanWeights(mesh, triangleTopology(mesh)))
  {
    EXPECT_TRUE(std::isfinite(weight));
  }
}

TEST(TriangleOperators, BadArgumentsAreRefused)
{
  TriangleMesh           mesh = analytic::icosphere(1);
  const TriangleTopology topology = triangleTopology(mesh);
  EXPECT_THROW((void)clampedCotanWeights(mesh, topology, 0.0, 1.0), InvalidInput);
  EXPECT_THROW((void)clampedCotanWeights(mesh, topology, 2.0, 1.0), InvalidInput);
  EXPECT_THROW((void)weightedLaplacian(topology, { 1.0 }, mesh.vertices.size()), InvalidInput);
  mesh.vertices[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)cotanWeights(mesh, topology), InvalidInput);
}
