// Identities and closed forms to round-off (1e-12 relative); orders fitted, within 0.1 of theory (0.2 for order 6).
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/LevelSet/DensityImage.h"

#include "TestLattices.h"
#include "TestMeasures.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

/** mu = exp(rate . x) */
class ExponentialDensity : public Density
{
public:
  explicit ExponentialDensity(const Vector3 & rate) : m_Rate(rate)
  {}

  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const override
  {
    const double value = std::exp(m_Rate.dot(p));
    return { value, value * m_Rate };
  }

  /** Integral over the parallelepiped with this first corner and these edges. */
  [[nodiscard]] double
  massOf(const Vector3 & corner, const Matrix3 & edges) const
  {
    double mass = std::exp(m_Rate.dot(corner)) * edges.determinant();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double along = m_Rate.dot(edges.col(axis));
      mass *= std::expm1(along) / along;
    }
    return mass;
  }

private:
  Vector3 m_Rate;
};

/** Edges of a box whose cells are sheared. */
const Matrix3 shear = (Matrix3() << 1.0, 0.3, -0.2, 0.1, 0.8, 0.25, -0.15, 0.2, 1.1).finished();

HexMesh
shearedLattice(int n)
{
  return mappedLattice(n, [](const Vector3 & x) -> Vector3 { return shear * x; });
}

/** Smooth and positive, 1/5 to 5, on 11 x 9 x 7 voxels that hold the unit cube. */
ScalarVolume
wavyImage()
{
  ScalarVolume image;
  image.size = { { 11, 9, 7 } };
  image.spacing = Vector3(0.15, 0.2, 0.3);
  image.origin = Vector3(-0.25, -0.3, -0.4);
  for (int k = 0; k < 7; ++k)
  {
    for (int j = 0; j < 9; ++j)
    {
      for (int i = 0; i < 11; ++i)
      {
        const Vector3 p = image.point(i, j, k);
        image.values.push_back(std::exp(std::sin(4.0 * p.x()) + 0.6 * std::cos(3.0 * p.y() - 2.0 * p.z())));
      }
    }
  }
  return image;
}

/** Largest relative error of a cell's mass in the sheared lattice. */
double
largestError(const ExponentialDensity & density, int n, int pointsPerAxis)
{
  const HexMesh             mesh = shearedLattice(n);
  const std::vector<double> masses = measuresOf(MassMeasure(density, { pointsPerAxis }), mesh);
  double                    largest = 0.0;
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    const double exact = density.massOf(mesh.nodes[mesh.cellNodes(cell)[0]], shear / (n - 1.0));
    largest = std::max(largest, analytic::relativeError(masses[cell], exact));
  }
  return largest;
}

} // namespace

TEST(MassMeasure, UniformDensityGivesTheVolume)
{
  const HexMesh             mesh = farAndOblique(shaken(regularLattice(4), 0.07, 5));
  const std::vector<double> volumes = cellVolumes(mesh);
  ScalarVolume              image = wavyImage();
  image.values.assign(image.values.size(), 2.5);
  const DensityImage density(image);
  for (const int points : { 2, 3, 4, 7, 48 })
  {
    const std::vector<double> masses = measuresOf(MassMeasure(density, { points }), mesh);
    for (std::size_t cell = 0; cell < masses.size(); ++cell)
    {
      EXPECT_NEAR(masses[cell], 2.5 * volumes[cell], 1e-12 * volumes[cell]) << points << " points, cell " << cell;
    }
  }
}

TEST(MassMeasure, UniformDensityGivesTheGradientOfTheVolume)
{
  const HexMesh       mesh = shaken(regularLattice(6), 0.07, 6);
  const LinearDensity density(3.0, Vector3::Zero());
  std::vector<double> measures;
  CellGradients       volumeGradients;
  CellGradients       massGradients;
  VolumeMeasure().evaluate(mesh, 1, measures, &volumeGradients);
  MassMeasure(density, { 2 }).evaluate(mesh, 1, measures, &massGradients);
  EXPECT_LT((massGradients - 3.0 * volumeGradients).cwiseAbs().maxCoeff(),
            1e-13 * volumeGradients.cwiseAbs().maxCoeff() * 10.0);
}

TEST(MassMeasure, LinearDensityInParallelepipedsIsVolumeTimesDensityOfTheCentre)
{
  const HexMesh             mesh = shearedLattice(5);
  const LinearDensity       density(4.0, Vector3(1.0, -1.5, 0.7));
  const std::vector<double> masses = measuresOf(MassMeasure(density, { 2 }), mesh);
  const double              volume = (shear / 4.0).determinant();
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    const Vector3 centre = mesh.nodes[mesh.cellNodes(cell)[0]] + 0.5 * (shear / 4.0).rowwise().sum();
    EXPECT_NEAR(masses[cell], volume * density.value(centre), 1e-13 * volume) << cell;
  }
}

TEST(MassMeasure, LinearDensityIsExactInEveryTrilinearCell)
{
  const HexMesh             mesh = shaken(regularLattice(6), 0.07, 7);
  const LinearDensity       density(4.0, Vector3(1.0, -1.5, 0.7));
  const std::vector<double> coarse = measuresOf(MassMeasure(density, { 2 }), mesh);
  const std::vector<double> fine = measuresOf(MassMeasure(density, { 9 }), mesh);
  double                    total = 0.0;
  for (std::size_t cell = 0; cell < coarse.size(); ++cell)
  {
    EXPECT_NEAR(coarse[cell], fine[cell], 1e-12 * fine[cell]) << cell;
    total += coarse[cell];
  }
  EXPECT_NEAR(total, density.value(Vector3(0.5, 0.5, 0.5)), 1e-12);
}

TEST(MassMeasure, ErrorIsOfOrderTwiceThePointsInTheCellSize)
{
  const ExponentialDensity density(Vector3(2.0, -3.0, 1.5));
  for (const int points : { 2, 3 })
  {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const int n : { 3, 5, 7, 9 })
    {
      sizes.push_back(1.0 / (n - 1.0));
      errors.push_back(largestError(density, n, points));
    }
    EXPECT_NEAR(analytic::observedOrder(sizes, errors), 2.0 * points, points == 2 ? 0.1 : 0.2) << points;
  }
}

TEST(MassMeasure, ErrorOfADensityImageIsOfThirdOrderInThePoints)
{
  const DensityImage        density(wavyImage());
  const HexMesh             mesh = shaken(regularLattice(4), 0.05, 8);
  const std::vector<double> exact = measuresOf(MassMeasure(density, { 48 }), mesh);
  std::vector<double>       steps;
  std::vector<double>       errors;
  for (const int points : { 3, 4, 6, 9, 13 })
  {
    const std::vector<double> masses = measuresOf(MassMeasure(density, { points }), mesh);
    double                    sum = 0.0;
    for (std::size_t cell = 0; cell < masses.size(); ++cell)
    {
      sum += std::pow(masses[cell] - exact[cell], 2);
    }
    steps.push_back(1.0 / points);
    errors.push_back(std::sqrt(sum));
  }
  EXPECT_GT(analytic::observedOrder(steps, errors), 3.0);
}

TEST(MassMeasure, GradientHasTaylorRemainderOfSecondOrder)
{
  const HexMesh            mesh = shaken(regularLattice(4), 0.08, 9);
  const ExponentialDensity smooth(Vector3(2.0, -3.0, 1.5));
  const DensityImage       image(wavyImage());
  EXPECT_NEAR(taylorOrder(MassMeasure(smooth, { 3 }), mesh), 2.0, 0.1);
  EXPECT_NEAR(taylorOrder(MassMeasure(image, { 4 }), mesh), 2.0, 0.1);
}

TEST(MassMeasure, InvertedCellIsNegative)
{
  const HexMesh       mirrored = mappedLattice(2, [](const Vector3 & x) { return Vector3(-x.x(), x.y(), x.z()); });
  const LinearDensity density(2.0, Vector3(0.5, 0.0, 0.0));
  EXPECT_NEAR(measuresOf(MassMeasure(density), mirrored).front(), -1.75, 1e-13);
}

TEST(MassMeasure, MeshAndImageMovedTogetherKeepTheirMasses)
{
  const Matrix3 turn = Eigen::AngleAxisd(1.1, Vector3(0.3, 1.0, -0.4).normalized()).toRotationMatrix();
  const Vector3 shift(30.0, -80.0, 12.0);
  const HexMesh mesh = shaken(regularLattice(4), 0.05, 10);
  HexMesh       moved = mesh;
  for (Vector3 & node : moved.nodes)
  {
    node = turn * node + shift;
  }
  const ScalarVolume image = wavyImage();
  ScalarVolume       movedImage = image;
  movedImage.direction = turn * image.direction;
  movedImage.origin = turn * image.origin + shift;
  const DensityImage        density(image);
  const DensityImage        movedDensity(movedImage);
  const std::vector<double> masses = measuresOf(MassMeasure(density), mesh);
  const std::vector<double> movedMasses = measuresOf(MassMeasure(movedDensity), moved);
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    EXPECT_NEAR(movedMasses[cell], masses[cell], 1e-11 * masses[cell]);
  }
}

TEST(MassMeasure, EstimatedErrorIsTheErrorOfTheWorstCell)
{
  const ExponentialDensity density(Vector3(2.0, -3.0, 1.5));
  const HexMesh            mesh = shearedLattice(4);
  const MassMeasure        measure(density, { 3 });
  std::vector<double>      masses = measuresOf(measure, mesh);
  const double             mean = measureEquality(masses).total / static_cast<double>(masses.size());
  double                   error = 0.0;
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    const double exact = density.massOf(mesh.nodes[mesh.cellNodes(cell)[0]], shear / 3.0);
    error = std::max(error, std::abs(masses[cell] - exact) / mean);
  }
  EXPECT_NEAR(measure.estimateError(mesh), error, 0.05 * error);
}

TEST(MassMeasure, IsTheSameForAnyNumberOfThreads)
{
  const DensityImage density(wavyImage());
  expectSameForThreads(MassMeasure(density), shaken(regularLattice(9), 0.03, 11));
}

TEST(MassMeasure, MassesAreTheSameWithAndWithoutGradients)
{
  const DensityImage  density(wavyImage());
  const MassMeasure   measure(density);
  const HexMesh       mesh = shaken(regularLattice(5), 0.05, 13);
  std::vector<double> masses;
  CellGradients       gradients;
  measure.evaluate(mesh, 1, masses, &gradients);
  const std::vector<double> alone = measuresOf(measure, mesh);
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    EXPECT_NEAR(alone[cell], masses[cell], 1e-14 * masses[cell]);
  }
}

TEST(MassMeasure, MassVarianceOfEqualCellsIsThatOfTheDensity)
{
  // Two cells a side: masses are the density at the centres 1/4 and 3/4, 2 -+ 1/4: variance (1/8)^2.
  const LinearDensity   density(1.5, Vector3(1.0, 0.0, 0.0));
  const MeasureEquality equality = measureEquality(regularLattice(3), MassMeasure(density));
  EXPECT_NEAR(equality.variance, 1.0 / 64.0, 1e-14);
  EXPECT_NEAR(equality.total, 2.0, 1e-13);
}

TEST(MassMeasure, PointsOutsideTheRangeAreRefused)
{
  const LinearDensity density(1.0, Vector3::Zero());
  EXPECT_THROW(MassMeasure(density, { 1 }), InvalidInput);
  EXPECT_THROW(MassMeasure(density, { 49 }), InvalidInput);
}

TEST(MassMeasure, EstimateWithoutAFinerRuleIsRefused)
{
  const LinearDensity density(1.0, Vector3::Zero());
  EXPECT_NO_THROW((void)MassMeasure(density, { 32 }).estimateError(regularLattice(2)));
  try
  {
    (void)MassMeasure(density, { 33 }).estimateError(regularLattice(2));
    FAIL() << "accepted";
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(std::string(error.what()),
              "mass quadrature: estimate of the error with 33 points per axis, need 2 to 32");
  }
}

TEST(MassQuadrature, UniformDensityNeedsTwoPoints)
{
  const LinearDensity  density(3.0, Vector3::Zero());
  const MassQuadrature quadrature = chooseMassQuadrature(shearedLattice(4), density, 1e-10);
  EXPECT_EQ(quadrature.options.pointsPerAxis, 2);
  EXPECT_TRUE(quadrature.reached);
}

TEST(MassQuadrature, ChosenRuleHasTheAccuracyAskedFor)
{
  const ExponentialDensity density(Vector3(6.0, -9.0, 4.5));
  for (const double accuracy : { 1e-2, 1e-4, 1e-8 })
  {
    const MassQuadrature quadrature = chooseMassQuadrature(shearedLattice(4), density, accuracy);
    EXPECT_TRUE(quadrature.reached);
    EXPECT_LE(quadrature.relativeError, accuracy);
    EXPECT_EQ(quadrature.relativeError, MassMeasure(density, quadrature.options).estimateError(shearedLattice(4)));
    EXPECT_LE(largestError(density, 4, quadrature.options.pointsPerAxis), 10.0 * accuracy); // of the cell, not the mean
  }
}

TEST(MassQuadrature, AccuracyOutOfReachIsSaid)
{
  ScalarVolume image = wavyImage();
  Random       random(12);
  for (double & value : image.values)
  {
    value = std::exp(random.uniform(-4.0, 4.0));
  }
  const DensityImage   density(image);
  const MassQuadrature quadrature = chooseMassQuadrature(regularLattice(2), density, 1e-12);
  EXPECT_FALSE(quadrature.reached);
  EXPECT_EQ(quadrature.options.pointsPerAxis, 9);
  EXPECT_GT(quadrature.relativeError, 1e-12);
}

TEST(MassQuadrature, AccuracyThatIsNotPositiveIsRefused)
{
  const LinearDensity density(1.0, Vector3::Zero());
  EXPECT_THROW((void)chooseMassQuadrature(regularLattice(3), density, 0.0), InvalidInput);
}

TEST(MassQuadrature, MeshThatIsNotALatticeIsRefused)
{
  const LinearDensity density(1.0, Vector3::Zero());
  HexMesh             mesh = regularLattice(3);
  mesh.nodes.pop_back();
  EXPECT_THROW((void)chooseMassQuadrature(mesh, density, 1e-3), InvalidInput);
}
