// Integrals to 1e-6 relative, the customer's bound.
#include "TransferTest.h"

#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/CubeTransfer/CubeSamples.h"
#include "moserhex/CubeTransfer/FieldFunction.h"

#include <numeric>

using namespace moserhex;
using namespace moserhex::app;

TEST_F(TransferCommand, CellMeansTimesVolumesAreTheIntegralOverTheOrgan)
{
  transfer("smooth.nrrd", { "--to-cube", path("cube.nrrd") });
  const FieldVolume cube = image("cube.nrrd");
  EXPECT_EQ(cube.size, (std::array<int, 3>{ { 7, 7, 7 } }));
  EXPECT_EQ(cubeSamplingOf(cube), CubeSampling::Cells);
  const std::vector<double> volumes = cellVolumes(m_Mesh);
  const double              mass = std::inner_product(volumes.begin(), volumes.end(), cube.values.begin(), 0.0);
  // Another road: the midpoint rule for the function itself on a fine lattice. Interpolation limits both to some 1e-4.
  double exact = 0.0;
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    exact += volumes[cell] * smoothDensity(CubeMap(m_Mesh).position({ cell, Vector3::Constant(0.5) }));
  }
  EXPECT_NEAR(mass, exact, 1e-3 * exact);
}

TEST_F(TransferCommand, TheIntegralIsTheSameInTheCubeAndAfterComingBack)
{
  const Outcome there = transferOf("smooth.nrrd", { "--to-cube", path("cube.nrrd"), "--conserve" });
  ASSERT_EQ(there.exitCode, 0) << there.error;
  const double integral = std::stod(there.out.substr(there.out.find(": ") + 2));
  transfer("cube.nrrd", { "--to-image", path("back.nrrd"), "--like", path("smooth.nrrd"), "--conserve" });
  const FieldVolume back = image("back.nrrd");
  EXPECT_NEAR(sumOfValues(back) * back.voxelVolume(), integral, 1e-6 * integral);
  transfer("back.nrrd", { "--to-cube", path("again.nrrd") });
  EXPECT_NEAR(image("again.nrrd").values[171], image("cube.nrrd").values[171], 0.05); // the middle cell
}

TEST_F(TransferCommand, FineSamplingAndBackIsTheImageInTheOrgan)
{
  transfer("smooth.nrrd", { "--to-cube", path("cube.nrrd"), "--sampling", "60" });
  transfer("cube.nrrd", { "--to-image", path("back.nrrd"), "--like", path("smooth.nrrd"), "--background", "-1" });
  const FieldVolume before = image("smooth.nrrd");
  const FieldVolume after = image("back.nrrd");
  std::size_t       inside = 0;
  for (std::size_t voxel = 0; voxel < after.values.size(); ++voxel)
  {
    if (after.values[voxel] != -1.0)
    {
      ++inside;
      EXPECT_NEAR(after.values[voxel], before.values[voxel], 0.1); // half a box at the surface
    }
  }
  EXPECT_GT(inside, 3000u);
}

TEST_F(TransferCommand, NodesHoldTheImageAtTheNodes)
{
  transfer("smooth.nrrd", { "--to-cube", path("cube.nrrd"), "--sampling", "nodes" });
  const FieldVolume cube = image("cube.nrrd");
  ASSERT_EQ(cubeSamplingOf(cube), CubeSampling::Nodes);
  for (std::size_t node = 0; node < m_Mesh.nodes.size(); ++node)
  {
    EXPECT_NEAR(cube.values[node], smoothDensity(m_Mesh.nodes[node]), 0.01);
  }
}

TEST_F(TransferCommand, AnotherSubjectGetsTheValuesOfTheSamePlaces)
{
  writeFieldImage(path("places.nrrd"), imageOfPositions());
  transfer("places.nrrd",
           { "--to-mesh",
             path("b.vtu"),
             "--to-image",
             path("out.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--background",
             "-9" });
  const FieldVolume out = image("out.nrrd");
  const HexMesh     other = bentBar(4.0);
  const CubeMap     from(m_Mesh);
  const CubeMap     to(other);
  std::size_t       inside = 0;
  for (int j = 0; j < out.size[1]; ++j)
  {
    for (int i = 0; i < out.size[0]; ++i)
    {
      const Eigen::Map<const Vector3> value(out.at(out.voxelNumber(i, j, 5)));
      const auto                      place = to.find(out.point(i, j, 5));
      const Vector3                   expected =
        place ? from.position(from.place(to.cubeCoordinates(*place))) : Vector3(Vector3::Constant(-9.0));
      EXPECT_LE((value - expected).norm(), 1e-9); // linear interpolation reproduces coordinates
      inside += place ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 300u);
}

TEST_F(TransferCommand, ADensityKeepsItsMassInAnotherSubject)
{
  const Outcome there = transferOf("smooth.nrrd", { "--to-cube", path("cube.nrrd"), "--conserve" });
  const double  integral = std::stod(there.out.substr(there.out.find(": ") + 2));
  transfer("smooth.nrrd",
           { "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--spacing", "1.5", "--conserve" });
  const FieldVolume out = image("out.nrrd");
  EXPECT_NEAR(sumOfValues(out) * out.voxelVolume(), integral, 1e-6 * integral);
}

TEST_F(TransferCommand, AnImageThatEndsInTheOrganIsReported)
{
  FieldVolume half = image("smooth.nrrd");
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half);
  const Outcome outcome = transferOf("half.nrrd", { "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("% of the mesh lies beyond the image"), std::string::npos) << outcome.error;
  half.origin[0] -= 1000.0;
  writeFieldImage(path("half.nrrd"), half);
  expectErrorCode(transferOf("half.nrrd", { "--to-cube", path("c2.nrrd") }), "E_GEOMETRY");
}

TEST_F(TransferCommand, ThreadsDoNotMatter)
{
  for (const char * threads : { "1", "2" })
  {
    transfer("smooth.nrrd",
             { "--to-mesh",
               path("b.vtu"),
               "--to-image",
               path(std::string(threads) + ".nrrd"),
               "--spacing",
               "2",
               "--conserve",
               "--threads",
               threads });
  }
  EXPECT_EQ(image("1.nrrd").values, image("2.nrrd").values);
}

TEST_F(TransferCommand, TheIntegralOfADensityIsStatedWithItsError)
{
  const Outcome there = transferOf("smooth.nrrd", { "--conserve", "--to-cube", path("cube.nrrd") });
  ASSERT_EQ(there.exitCode, 0) << there.error;
  EXPECT_EQ(there.error, "");
  double integral = 0.0;
  double error = 1.0;
  ASSERT_EQ(std::sscanf(there.out.c_str(), "integral over the mesh: %lf +- %lf,", &integral, &error), 2) << there.out;
  EXPECT_GT(error, 0.0);
  EXPECT_LE(error, 1e-6 * integral);
  const FieldVolume   smoothImage = image("smooth.nrrd");
  const FieldFunction f(smoothImage, ImageInterpolation::Linear);
  const auto          finest = cubeMeans(
    m_Mesh, [&f](const CubePoint & p, double * value) { (void)f.evaluate(p.position, value); }, 1, { 0, 24, 0 });
  const double expected =
    std::inner_product(finest.volumes.begin(), finest.volumes.end(), finest.image.values.begin(), 0.0);
  EXPECT_NEAR(integral, expected, 1e-6 * expected);

  const Outcome on = transferOf(
    "smooth.nrrd", { "--conserve", "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--spacing", "2" });
  ASSERT_EQ(on.exitCode, 0) << on.error;
  EXPECT_EQ(on.out.substr(0, on.out.find(',')), there.out.substr(0, there.out.find(',')));
}

TEST_F(TransferCommand, NothingIsWrittenWhereTheImageDoesNotReachTheMesh)
{
  FieldVolume far = constantImage({ 1.0 });
  far.origin[0] -= 1000.0;
  writeFieldImage(path("far.nrrd"), far);
  expectErrorCode(
    transferOf("far.nrrd",
               { "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--like", path("smooth.nrrd") }),
    "E_GEOMETRY");
  EXPECT_EQ(fileCount(), 4U); // no out.nrrd
}

TEST_F(TransferCommand, MassBeyondTheGridIsOfEachNumber)
{
  FieldVolume cube{ cubeGrid(CubeSampling::Cells, 7), 2, {} };
  for (std::size_t box = 0; box < cube.gridVoxels(); ++box)
  {
    cube.values.insert(cube.values.end(), { 1.0, -1.0 });
  }
  writeFieldImage(path("cube.nrrd"), cube);
  FieldVolume part = constantImage({ 0.0 });
  part.origin[0] -= 25.0;
  writeFieldImage(path("part.nrrd"), part);
  const Outcome outcome =
    transferOf("cube.nrrd", { "--to-image", path("out.nrrd"), "--like", path("part.nrrd"), "--conserve" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("integral over the mesh of number 1"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("integral over the mesh of number 2"), std::string::npos) << outcome.error;
}

TEST_F(TransferCommand, AnIntegralThatIsNoNumberIsAWarning)
{
  FieldVolume half = image("smooth.nrrd");
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half);
  const Outcome outcome =
    transferOf("half.nrrd", { "--to-cube", path("cube.nrrd"), "--conserve", "--background", "nan" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("the integral is known to inf only"), std::string::npos) << outcome.error;
}
