// Identities to round-off (1e-12 of the cell's size); Taylor remainders: slope fitted, within 0.1 of theory.
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/CellMeasure.h"

#include "TestLattices.h"
#include "TestMeasures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::testing;

TEST(VolumeMeasure, IsTheVolumeByQuadrature)
{
  const HexMesh             mesh = farAndOblique(shaken(regularLattice(7), 0.06, 1));
  const std::vector<double> expected = cellVolumes(mesh);
  const std::vector<double> volumes = measuresOf(VolumeMeasure(), mesh);
  ASSERT_EQ(volumes.size(), mesh.cellCount());
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    EXPECT_NEAR(volumes[cell], expected[cell], 1e-12 * 8.0) << cell;
  }
}

TEST(VolumeMeasure, InvertedCellIsNegative)
{
  const HexMesh mirrored = mappedLattice(2, [](const Vector3 & x) { return Vector3(-x.x(), 2 * x.y(), 3 * x.z()); });
  EXPECT_NEAR(measuresOf(VolumeMeasure(), mirrored).front(), -6.0, 1e-14);
}

TEST(VolumeMeasure, CellsAddUpToWhatTheBoundaryEncloses)
{
  const HexMesh         mesh = shaken(regularLattice(9), 0.05, 2); // inner nodes only
  const MeasureEquality equality = measureEquality(mesh, VolumeMeasure());
  EXPECT_NEAR(equality.total, 1.0, 1e-12);
}

TEST(VolumeMeasure, GradientHasTaylorRemainderOfSecondOrder)
{
  EXPECT_NEAR(taylorOrder(VolumeMeasure(), shaken(regularLattice(5), 0.08, 3)), 2.0, 0.1);
}

TEST(VolumeMeasure, IsTheSameForAnyNumberOfThreads)
{
  expectSameForThreads(VolumeMeasure(), shaken(regularLattice(12), 0.03, 4));
}

TEST(SharedVolumeMeasure, IsEqualWhereVolumesAreAsTheShares)
{
  const HexMesh       mesh = shaken(regularLattice(5), 0.08, 5);
  std::vector<double> shares = cellVolumes(mesh);
  for (double & share : shares)
  {
    share *= 17.0; // divided by their mean
  }
  const MeasureEquality equality = measureEquality(mesh, SharedVolumeMeasure(shares));
  EXPECT_LT(equality.variance, 1e-24);
  EXPECT_NEAR(equality.total, 1.0, 1e-12);
}

TEST(SharedVolumeMeasure, GradientHasTaylorRemainderOfSecondOrder)
{
  const HexMesh       mesh = shaken(regularLattice(5), 0.08, 6);
  std::vector<double> shares(mesh.cellCount());
  for (std::size_t cell = 0; cell < shares.size(); ++cell)
  {
    shares[cell] = 1.0 + 0.1 * static_cast<double>(cell % 7);
  }
  EXPECT_NEAR(taylorOrder(SharedVolumeMeasure(shares), mesh), 2.0, 0.1);
}

TEST(SharedVolumeMeasure, ShareThatIsNotPositiveIsRefused)
{
  EXPECT_THROW((void)SharedVolumeMeasure({ 1.0, 0.0 }), InvalidInput);
  EXPECT_THROW((void)SharedVolumeMeasure({ 1.0, std::nan("") }), InvalidInput);
  EXPECT_THROW((void)SharedVolumeMeasure({}), InvalidInput);
}

TEST(MeasureEquality, MatchesTheClosedForm)
{
  const MeasureEquality equality = measureEquality(std::vector<double>{ 1.0, 2.0, 3.0, 6.0 });
  EXPECT_DOUBLE_EQ(equality.total, 12.0);
  EXPECT_DOUBLE_EQ(equality.variance, (4.0 + 1.0 + 0.0 + 9.0) / 9.0 / 4.0);
  EXPECT_DOUBLE_EQ(equality.ratioMin, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(equality.ratioMax, 2.0);
}

TEST(MeasureEquality, NoMeasureIsRefused)
{
  EXPECT_THROW((void)measureEquality(std::vector<double>{}), InvalidInput);
}

TEST(MeasureEquality, MeanThatIsNotPositiveIsRefused)
{
  EXPECT_THROW((void)measureEquality(std::vector<double>{ 1.0, -1.0 }), InvalidInput);
}

TEST(MeasureEquality, MeshWithTooFewNodesIsRefused)
{
  HexMesh mesh = regularLattice(3);
  mesh.nodes.pop_back();
  EXPECT_THROW((void)measureEquality(mesh, VolumeMeasure()), InvalidInput);
}
