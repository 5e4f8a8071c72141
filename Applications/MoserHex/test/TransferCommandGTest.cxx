// Integrals to 1e-6 relative, the customer's bound; positions to 1e-9 mm. Exit codes, streams and files exact.
#include "CommandTest.h"

#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/CubeTransfer/CubeSamples.h"
#include "moserhex/CubeTransfer/FieldFunction.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <numeric>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

constexpr int nodesPerSide = 8;

/** A bent, tapered bar in [0,40] x [0,40] x [0,20], roughly. */
HexMesh
bar(double bend)
{
  HexMesh mesh;
  mesh.nodesPerSide = nodesPerSide;
  for (int k = 0; k < nodesPerSide; ++k)
  {
    for (int j = 0; j < nodesPerSide; ++j)
    {
      for (int i = 0; i < nodesPerSide; ++i)
      {
        const Vector3 c = Vector3(i, j, k) / (nodesPerSide - 1);
        mesh.nodes.emplace_back(5.0 + 30.0 * c[0],
                                5.0 + 20.0 * c[1] * (1.0 - 0.2 * c[0]) + bend * c[0] * c[0],
                                3.0 + 12.0 * c[2] + 2.0 * c[1]);
      }
    }
  }
  return mesh;
}

double
smooth(const Vector3 & p)
{
  return 3.0 + std::sin(0.1 * p[0]) + 0.02 * p[1] * p[2];
}

template <typename TFunction>
FieldVolume
imageOf(int components, const TFunction & f)
{
  FieldVolume image{ VoxelGrid{ { { 50, 45, 14 } }, { 0.9, 1.0, 1.7 }, { -2.0, -2.0, -1.0 } }, components, {} };
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        f(image.point(i, j, k), image.values);
      }
    }
  }
  return image;
}

double
sum(const FieldVolume & image)
{
  return std::accumulate(image.values.begin(), image.values.end(), 0.0);
}

class TransferCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    m_Mesh = bar(15.0);
    writeHexMesh(path("a.vtu"), m_Mesh);
    writeHexMesh(path("b.vtu"), bar(4.0));
    writeFieldImage(path("smooth.nrrd"),
                    imageOf(1, [](const Vector3 & p, std::vector<double> & values) { values.push_back(smooth(p)); }));
  }

  [[nodiscard]] FieldVolume
  image(const std::string & name) const
  {
    return readFieldImage(path(name)).volume;
  }

  void
  transfer(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), "transfer");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
  }

  HexMesh m_Mesh;
};

} // namespace

TEST_F(TransferCommand, CellMeansTimesVolumesAreTheIntegralOverTheOrgan)
{
  transfer({ path("smooth.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd") });
  const FieldVolume cube = image("cube.nrrd");
  EXPECT_EQ(cube.size, (std::array<int, 3>{ { 7, 7, 7 } }));
  EXPECT_EQ(cubeSamplingOf(cube), CubeSampling::Cells);
  const std::vector<double> volumes = cellVolumes(m_Mesh);
  const double              mass = std::inner_product(volumes.begin(), volumes.end(), cube.values.begin(), 0.0);
  // Another road: the midpoint rule for the function itself on a fine lattice. Interpolation limits both to some 1e-4.
  double exact = 0.0;
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    exact += volumes[cell] * smooth(CubeMap(m_Mesh).position({ cell, Vector3::Constant(0.5) }));
  }
  EXPECT_NEAR(mass, exact, 1e-3 * exact);
}

TEST_F(TransferCommand, TheIntegralIsTheSameInTheCubeAndAfterComingBack)
{
  const Outcome there =
    run({ "transfer", path("smooth.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--conserve" });
  ASSERT_EQ(there.exitCode, 0) << there.error;
  const double integral = std::stod(there.out.substr(there.out.find(": ") + 2));
  transfer({ path("cube.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-image",
             path("back.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--conserve" });
  const FieldVolume back = image("back.nrrd");
  EXPECT_NEAR(sum(back) * back.voxelVolume(), integral, 1e-6 * integral);
  transfer({ path("back.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("again.nrrd") });
  EXPECT_NEAR(image("again.nrrd").values[171], image("cube.nrrd").values[171], 0.05); // the middle cell
}

TEST_F(TransferCommand, FineSamplingAndBackIsTheImageInTheOrgan)
{
  transfer({ path("smooth.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--sampling", "60" });
  transfer({ path("cube.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-image",
             path("back.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--background",
             "-1" });
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
  transfer({ path("smooth.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--sampling", "nodes" });
  const FieldVolume cube = image("cube.nrrd");
  ASSERT_EQ(cubeSamplingOf(cube), CubeSampling::Nodes);
  for (std::size_t node = 0; node < m_Mesh.nodes.size(); ++node)
  {
    EXPECT_NEAR(cube.values[node], smooth(m_Mesh.nodes[node]), 0.01);
  }
}

TEST_F(TransferCommand, AnotherSubjectGetsTheValuesOfTheSamePlaces)
{
  const auto coordinates = [](const Vector3 & p, std::vector<double> & values) {
    values.insert(values.end(), p.data(), p.data() + 3);
  };
  writeFieldImage(path("places.nrrd"), imageOf(3, coordinates));
  transfer({ path("places.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-mesh",
             path("b.vtu"),
             "--to-image",
             path("out.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--background",
             "-9" });
  const FieldVolume out = image("out.nrrd");
  const HexMesh     other = bar(4.0);
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
  const Outcome there =
    run({ "transfer", path("smooth.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--conserve" });
  const double integral = std::stod(there.out.substr(there.out.find(": ") + 2));
  transfer({ path("smooth.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-mesh",
             path("b.vtu"),
             "--to-image",
             path("out.nrrd"),
             "--spacing",
             "1.5",
             "--conserve" });
  const FieldVolume out = image("out.nrrd");
  EXPECT_NEAR(sum(out) * out.voxelVolume(), integral, 1e-6 * integral);
}

TEST_F(TransferCommand, LabelsGoToMostOfACellAndBack)
{
  writeFieldImage(path("labels.nrrd"),
                  imageOf(1,
                          [](const Vector3 & p, std::vector<double> & values) {
                            values.push_back(p[0] < 14.0 ? 0.0 : p[0] < 24.0 ? 3.0 : 300.0);
                          }),
                  FieldValues::Labels);
  transfer({ path("labels.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--labels" });
  transfer(
    { path("labels.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("parts.nrrd"), "--labels", "--fractions" });
  const FieldVolume cube = image("cube.nrrd");
  const FieldVolume parts = image("parts.nrrd");
  ASSERT_EQ(parts.components, 2);
  EXPECT_EQ(cube.values[0], 0.0);
  EXPECT_EQ(cube.values[3], 3.0);
  EXPECT_EQ(cube.values[6], 300.0);
  EXPECT_NEAR(parts.at(3)[0], 1.0, 1e-12);
  EXPECT_NEAR(parts.at(4)[0] + parts.at(4)[1], 1.0, 1e-12);
  EXPECT_NEAR(parts.at(0)[0] + parts.at(0)[1], 0.0, 1e-12);
  transfer({ path("cube.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-image",
             path("back.nrrd"),
             "--like",
             path("labels.nrrd"),
             "--labels" });
  for (const double value : image("back.nrrd").values)
  {
    EXPECT_TRUE(value == 0.0 || value == 3.0 || value == 300.0) << value;
  }
}

TEST_F(TransferCommand, TurnedVectorsComeBackInTheSubjectsAxes)
{
  const auto constant = [](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), { 1.0, 2.0, -2.0 });
  };
  writeFieldImage(path("vectors.nrrd"), imageOf(3, constant));
  transfer({ path("vectors.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-mesh",
             path("a.vtu"),
             "--to-image",
             path("same.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--rotate" });
  transfer({ path("vectors.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-cube",
             path("cube.nrrd"),
             "--rotate",
             "--sampling",
             "nodes" });
  const FieldVolume same = image("same.nrrd");
  const std::size_t middle = same.voxelNumber(24, 20, 6);
  EXPECT_NEAR(same.at(middle)[0], 1.0, 1e-9);
  EXPECT_NEAR(same.at(middle)[2], -2.0, 1e-9);
  const FieldVolume cube = image("cube.nrrd");
  double            largestTurn = 0.0;
  for (std::size_t node = 0; node < cube.gridVoxels(); ++node)
  {
    const Eigen::Map<const Vector3> vector(cube.at(node));
    EXPECT_NEAR(vector.norm(), 3.0, 1e-12);
    largestTurn = std::max(largestTurn, (vector - Vector3(1.0, 2.0, -2.0)).norm());
  }
  EXPECT_GT(largestTurn, 0.5);
}

TEST_F(TransferCommand, TurnedTensorsStayTensorsAndComeBack)
{
  const std::vector<double> tensor{ 3.0, 0.5, 0.0, 2.0, -0.25, 1.0 };
  const auto                constant = [&tensor](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), tensor.begin(), tensor.end());
  };
  writeFieldImage(path("tensors.nrrd"), imageOf(6, constant), FieldValues::SymmetricTensors);
  transfer(
    { path("tensors.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd"), "--rotate", "--sampling", "35" });
  transfer({ path("cube.nrrd"),
             "--mesh",
             path("a.vtu"),
             "--to-image",
             path("back.nrrd"),
             "--like",
             path("smooth.nrrd"),
             "--rotate" });
  EXPECT_NE(contentOf(path("back.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
  const FieldVolume cube = image("cube.nrrd");
  const FieldVolume back = image("back.nrrd");
  const std::size_t middle = back.voxelNumber(24, 20, 6);
  double            largestTurn = 0.0;
  for (std::size_t n = 0; n < tensor.size(); ++n)
  {
    EXPECT_NEAR(back.at(middle)[n], tensor[n], 0.02); // the rotation is a mean over a box
    largestTurn = std::max(largestTurn, std::abs(cube.at(cube.gridVoxels() - 1)[n] - tensor[n]));
  }
  EXPECT_GT(largestTurn, 0.2);
}

TEST_F(TransferCommand, PointsComeBackToTheirPlaces)
{
  const CubeMap map(m_Mesh);
  std::ofstream table(path("points.csv"));
  table.precision(17);
  table << "grade,label,x,y,z\n";
  std::vector<Vector3> positions;
  for (const Vector3 & c : { Vector3(0.1, 0.2, 0.3), Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.5, 0.9) })
  {
    positions.push_back(map.position(map.place(c)));
    table << "4," << positions.size() << ',' << positions.back()[0] << ',' << positions.back()[1] << ','
          << positions.back()[2] << '\n';
  }
  table << "5,far away,200,0,0\n";
  table.close();
  const Outcome there = run({ "transfer", path("points.csv"), "--mesh", path("a.vtu"), "--to-cube", path("cube.csv") });
  EXPECT_EQ(there.exitCode, 0);
  EXPECT_NE(there.out.find("3 of 4 points"), std::string::npos) << there.out;
  EXPECT_NE(there.error.find("warning: far away: outside of the mesh"), std::string::npos) << there.error;
  EXPECT_NE(contentOf(path("cube.csv")).find("far away,,5,200,0,0,,,\n"), std::string::npos);
  EXPECT_NE(contentOf(path("cube.csv")).find("1,,4,"), std::string::npos);

  const Outcome back = run({ "transfer", path("cube.csv"), "--mesh", path("a.vtu"), "--to-points", path("back.csv") });
  EXPECT_EQ(back.exitCode, 0);
  std::ifstream stream(path("back.csv"));
  std::string   line;
  std::getline(stream, line);
  for (const Vector3 & position : positions)
  {
    ASSERT_TRUE(std::getline(stream, line));
    Vector3 found;
    ASSERT_EQ(std::sscanf(line.c_str(), "%*[^,],,%*[^,],%lf,%lf,%lf", &found[0], &found[1], &found[2]), 3) << line;
    EXPECT_LE((found - position).norm(), 1e-9);
  }
}

TEST_F(TransferCommand, FiducialsGoToAnotherSubject)
{
  const HexMesh other = bar(4.0);
  const CubeMap from(m_Mesh);
  const CubeMap to(other);
  const Vector3 c(0.8, 0.5, 0.5);
  const Vector3 p = from.position(from.place(c));
  std::ofstream(path("p.fcsv")) << "# CoordinateSystem = RAS\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,"
                                   "associatedNodeID\n1,"
                                << std::to_string(-p[0]) << ',' << std::to_string(-p[1]) << ',' << std::to_string(p[2])
                                << ",0,0,0,1,1,1,0,apex,,\n";
  transfer(
    { path("p.fcsv"), "--mesh", path("a.vtu"), "--to-mesh", path("b.vtu"), "--to-points", path("q.csv"), "--quiet" });
  const std::string text = contentOf(path("q.csv"));
  Vector3           found;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("apex"), "apex,,%lf,%lf,%lf", &found[0], &found[1], &found[2]), 3)
    << text;
  EXPECT_LE((found - to.position(to.place(c))).norm(), 1e-5); // the file has six decimals
}

TEST_F(TransferCommand, RefusesWithOneLine)
{
  const std::vector<std::string> start{ "transfer", path("smooth.nrrd"), "--mesh", path("a.vtu") };
  const auto                     with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    return run(more);
  };
  const std::string out = path("out.nrrd");
  expectErrorCode(with({}), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--to-image", out }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("smooth.nrrd") }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--sampling", "many" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--sampling", "nodes", "--conserve" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("out.mha") }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("no/out.nrrd") }), "E_CANTCREAT");
  expectErrorCode(with({ "--to-cube", out, "--rotate" }), "E_PIXELTYPE");
  expectErrorCode(with({ "--to-cube", out, "--labels" }), "E_LABELS");
  expectErrorCode(with({ "--to-image", out, "--like", path("smooth.nrrd") }), "E_GEOMETRY"); // no image of the cube
  expectErrorCode(with({ "--to-image", out, "--to-mesh", path("b.vtu") }), "E_USAGE");
  expectErrorCode(with({ "--to-image", out, "--to-mesh", path("b.vtu"), "--spacing", "1", "2" }), "E_USAGE");
  expectErrorCode(with({ "--to-points", path("out.csv") }), "E_USAGE");
  expectErrorCode(run({ "transfer", path("no.nrrd"), "--mesh", path("a.vtu"), "--to-cube", out }), "E_NOINPUT");
  expectErrorCode(run({ "transfer", path("no.csv"), "--mesh", path("a.vtu"), "--to-cube", path("o.csv") }),
                  "E_NOINPUT");
  EXPECT_EQ(fileCount(), 3U);
}

TEST_F(TransferCommand, AnImageThatEndsInTheOrganIsReported)
{
  FieldVolume half = imageOf(1, [](const Vector3 & p, std::vector<double> & values) { values.push_back(smooth(p)); });
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half);
  const Outcome outcome =
    run({ "transfer", path("half.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("% of the mesh lies beyond the image"), std::string::npos) << outcome.error;
  half.origin[0] -= 1000.0;
  writeFieldImage(path("half.nrrd"), half);
  expectErrorCode(run({ "transfer", path("half.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("c2.nrrd") }),
                  "E_GEOMETRY");
}

TEST_F(TransferCommand, ThreadsDoNotMatter)
{
  for (const char * threads : { "1", "2" })
  {
    transfer({ path("smooth.nrrd"),
               "--mesh",
               path("a.vtu"),
               "--to-mesh",
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

namespace
{

/** NRRD text of 32-bit floats over the voxels of `image`, of another number of values each. */
std::string
nrrdLike(const FieldVolume & image, const std::string & kind, const std::vector<float> & values)
{
  const std::size_t count = values.size() / image.gridVoxels();
  std::string       text =
    "NRRD0004\ntype: float\ndimension: 4\nspace: left-posterior-superior\nsizes: " + std::to_string(count) +
    " 50 45 14\nspace directions: none (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: " + kind +
    " domain domain domain\nendian: little\nencoding: raw\nspace origin: (-2,-2,-1)\n\n";
  return text.append(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(float));
}

} // namespace

TEST_F(TransferCommand, MaskedTensorsHaveNoDataOutsideTheirMask)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values;
  for (std::size_t voxel = 0; voxel < grid.gridVoxels(); ++voxel)
  {
    const bool isIn = voxel % 50 < 25; // the right half
    values.insert(values.end(), { isIn ? 1.0F : 0.0F, 3.0F, 0.5F, 0.0F, 2.0F, -0.25F, isIn ? 1.0F : 77.0F });
  }
  std::ofstream(path("masked.nrrd"), std::ios::binary) << nrrdLike(grid, "3D-masked-symmetric-matrix", values);
  const Outcome outcome = run({ "transfer",
                                path("masked.nrrd"),
                                "--mesh",
                                path("a.vtu"),
                                "--to-cube",
                                path("cube.nrrd"),
                                "--sampling",
                                "nodes",
                                "--background",
                                "-9" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("beyond the image or its mask"), std::string::npos) << outcome.error;
  const FieldVolume cube = image("cube.nrrd");
  ASSERT_EQ(cube.components, 6);
  std::size_t inside = 0;
  for (std::size_t node = 0; node < cube.gridVoxels(); ++node)
  {
    const bool isIn = m_Mesh.nodes[node][0] < -2.0 + 0.9 * 24.5;
    EXPECT_NEAR(cube.at(node)[0], isIn ? 3.0 : -9.0, 1e-12);
    EXPECT_NEAR(cube.at(node)[5], isIn ? 1.0 : -9.0, 1e-12);
    inside += isIn ? 1 : 0;
  }
  EXPECT_GT(inside, cube.gridVoxels() / 4);
  EXPECT_LT(inside, 3 * cube.gridVoxels() / 4);
}

TEST_F(TransferCommand, AMaskWithoutAnythingOfTheMeshIsRefused)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values(7 * grid.gridVoxels(), 0.0F);
  std::ofstream(path("masked.nrrd"), std::ios::binary) << nrrdLike(grid, "3D-masked-symmetric-matrix", values);
  expectErrorCode(run({ "transfer", path("masked.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd") }),
                  "E_GEOMETRY");
}

TEST_F(TransferCommand, NiftiVectorsGoToTheCubeAndBack)
{
  const auto coordinates = [](const Vector3 & p, std::vector<double> & values) {
    values.insert(values.end(), p.data(), p.data() + 3);
  };
  writeFieldImage(path("places.nii.gz"), imageOf(3, coordinates));
  transfer({ path("places.nii.gz"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nii.gz"), "--sampling", "nodes" });
  const FieldVolume cube = image("cube.nii.gz");
  EXPECT_EQ(cubeSamplingOf(cube), CubeSampling::Nodes);
  for (std::size_t node = 0; node < m_Mesh.nodes.size(); ++node)
  {
    const Eigen::Map<const Vector3> place(cube.at(node));
    EXPECT_LE((place - m_Mesh.nodes[node]).norm(), 1e-5) << node; // the grid's place is single precision
  }
  transfer(
    { path("cube.nii.gz"), "--mesh", path("a.vtu"), "--to-image", path("back.nii"), "--like", path("smooth.nrrd") });
  const FieldVolume back = image("back.nii");
  const std::size_t middle = back.voxelNumber(24, 20, 6);
  EXPECT_LE((Eigen::Map<const Vector3>(back.at(middle)) - back.point(24, 20, 6)).norm(), 1e-4);
}

TEST_F(TransferCommand, VectorsOfAnUnknownSpaceAreTurnedWhenItIsSaid)
{
  const auto constant = [](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), { 1.0, 2.0, -2.0 });
  };
  writeFieldImage(path("lps.nii"), imageOf(3, constant));
  std::string bytes = contentOf(path("lps.nii"));
  bytes.replace(328, 3, 3, '\0'); // intent_name
  const auto inRas = [](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), { -1.0, -2.0, -2.0 });
  };
  std::ofstream(path("unknown.nii"), std::ios::binary) << bytes;
  writeFieldImage(path("ras.nrrd"), imageOf(3, inRas));
  const std::vector<std::string> rest{ "--mesh", path("a.vtu"), "--rotate", "--to-cube" };
  const auto                     arguments = [&](const std::string & input, const std::string & output) {
    std::vector<std::string> all{ path(input) };
    all.insert(all.end(), rest.begin(), rest.end());
    all.push_back(path(output));
    return all;
  };
  std::vector<std::string> refused = arguments("unknown.nii", "a.nrrd");
  refused.insert(refused.begin(), "transfer");
  const Outcome outcome = run(refused);
  expectErrorCode(outcome, "E_GEOMETRY");
  EXPECT_NE(outcome.error.find("--values-in"), std::string::npos) << outcome.error;

  std::vector<std::string> said = arguments("unknown.nii", "a.nrrd");
  said.insert(said.end(), { "--values-in", "LPS" });
  transfer(said);
  transfer(arguments("lps.nii", "b.nrrd"));
  said = arguments("ras.nrrd", "c.nrrd");
  said.insert(said.end(), { "--values-in", "RAS" });
  transfer(said);
  EXPECT_EQ(image("a.nrrd").values, image("b.nrrd").values);
  EXPECT_EQ(image("a.nrrd").values, image("c.nrrd").values);
  expectErrorCode(
    run({ "transfer", path("lps.nii"), "--mesh", path("a.vtu"), "--to-cube", path("d.nrrd"), "--values-in", "LPS" }),
    "E_USAGE");
}

TEST_F(TransferCommand, TheIntegralOfADensityIsStatedWithItsError)
{
  const std::vector<std::string> start{ "transfer", path("smooth.nrrd"), "--mesh", path("a.vtu"), "--conserve" };
  std::vector<std::string>       cube = start;
  cube.insert(cube.end(), { "--to-cube", path("cube.nrrd") });
  const Outcome there = run(cube);
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

  std::vector<std::string> other = start;
  other.insert(other.end(), { "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--spacing", "2" });
  const Outcome on = run(other);
  ASSERT_EQ(on.exitCode, 0) << on.error;
  EXPECT_EQ(on.out.substr(0, on.out.find(',')), there.out.substr(0, there.out.find(',')));
}

TEST_F(TransferCommand, NothingIsWrittenWhereTheImageDoesNotReachTheMesh)
{
  FieldVolume far = imageOf(1, [](const Vector3 &, std::vector<double> & values) { values.push_back(1.0); });
  far.origin[0] -= 1000.0;
  writeFieldImage(path("far.nrrd"), far);
  expectErrorCode(run({ "transfer",
                        path("far.nrrd"),
                        "--mesh",
                        path("a.vtu"),
                        "--to-mesh",
                        path("b.vtu"),
                        "--to-image",
                        path("out.nrrd"),
                        "--like",
                        path("smooth.nrrd") }),
                  "E_GEOMETRY");
  EXPECT_EQ(fileCount(), 4U); // no out.nrrd
}

TEST_F(TransferCommand, PointsWithoutAPlaceAreAnError)
{
  std::ofstream(path("subject.csv")) << "label,x,y,z\na,20,15,8\n";
  std::ofstream(path("far.csv")) << "label,x,y,z\na,200,0,0\nb,,,\n";
  std::ofstream(path("beyond.csv")) << "label,c1,c2,c3\na,0.5,0.5,1.5\n";
  std::ofstream(path("empty.csv")) << "label,x,y,z\n";
  std::ofstream(path("empty.fcsv")) << "";
  const auto from = [this](const std::string & input, const std::vector<std::string> & to) {
    std::vector<std::string> arguments{ "transfer", path(input), "--mesh", path("a.vtu") };
    arguments.insert(arguments.end(), to.begin(), to.end());
    return run(arguments);
  };
  const std::size_t files = fileCount();
  const Outcome     withoutCube = from("subject.csv", { "--to-points", path("out.csv") });
  expectErrorCode(withoutCube, "E_USAGE");
  EXPECT_NE(withoutCube.error.find("--to-mesh"), std::string::npos) << withoutCube.error;
  expectErrorCode(from("far.csv", { "--to-cube", path("out.csv") }), "E_GEOMETRY");
  expectErrorCode(from("beyond.csv", { "--to-points", path("out.csv") }), "E_GEOMETRY");
  expectErrorCode(from("empty.csv", { "--to-cube", path("out.csv") }), "E_EMPTY");
  expectErrorCode(from("empty.fcsv", { "--to-mesh", path("b.vtu"), "--to-points", path("out.csv") }), "E_EMPTY");
  EXPECT_EQ(fileCount(), files);
}

TEST_F(TransferCommand, AnUnknownSystemOfFiducialsIsAWarning)
{
  std::ofstream(path("p.fcsv")) << "1,-20,-15,8,0,0,0,1,1,1,0,+L1,,,2,0\n";
  const Outcome outcome = run({ "transfer", path("p.fcsv"), "--mesh", path("a.vtu"), "--to-cube", path("q.csv") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("no CoordinateSystem: points taken as RAS"), std::string::npos) << outcome.error;
  EXPECT_NE(contentOf(path("q.csv")).find("\n+L1,,20,15,8,0."), std::string::npos) << contentOf(path("q.csv"));
}

namespace
{

/** 1 nearly everywhere, 2 in one voxel in the middle of the bar. */
void
withSmallLabel(const Vector3 & p, std::vector<double> & values)
{
  values.push_back((p - Vector3(19.6, 15.0, 9.2)).cwiseAbs().maxCoeff() < 0.45 ? 2.0 : 1.0);
}

} // namespace

TEST_F(TransferCommand, ALabelThatHasNoPlaceAnyMoreIsAWarning)
{
  writeFieldImage(path("labels.nrrd"), imageOf(1, withSmallLabel), FieldValues::Labels);
  const std::vector<std::string> start{ "transfer", path("labels.nrrd"), "--mesh", path("a.vtu"), "--labels" };
  const auto                     with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    return run(more);
  };
  const Outcome cells = with({ "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(cells.exitCode, 0) << cells.error;
  EXPECT_NE(cells.error.find("label 2 has "), std::string::npos) << cells.error;
  EXPECT_NE(
    cells.error.find(" mm3 in the organ, but is in no box of the cube; take --sampling N above 7, or --fractions"),
    std::string::npos)
    << cells.error;
  double             before = 0.0;
  double             after = -1.0;
  const char * const line = std::strstr(cells.out.c_str(), "label 2: ");
  ASSERT_NE(line, nullptr) << cells.out;
  ASSERT_EQ(std::sscanf(line, "label 2: %lf mm3 in the organ, %lf mm3 in the cube", &before, &after), 2) << line;
  EXPECT_NEAR(before, 0.9 * 1.0 * 1.7, 0.8); // a voxel, by some 16 points in it
  EXPECT_EQ(after, 0.0);
  EXPECT_EQ(with({ "--to-cube", path("cube.nrrd"), "--fractions" }).error, "");
  EXPECT_EQ(with({ "--to-cube", path("cube.nrrd"), "--sampling", "60" }).error, "");
  EXPECT_NE(with({ "--to-cube", path("cube.nrrd"), "--sampling", "nodes" }).error.find("in no node of the cube"),
            std::string::npos);
  const std::vector<std::string> coarse{ "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--spacing", "7" };
  EXPECT_NE(with(coarse).error.find("in no voxel; take smaller voxels"), std::string::npos);
}

TEST_F(TransferCommand, AnEmptyLabelmapIsTransferred)
{
  writeFieldImage(path("labels.nrrd"),
                  imageOf(1, [](const Vector3 &, std::vector<double> & values) { values.push_back(0.0); }),
                  FieldValues::Labels);
  const Outcome outcome =
    run({ "transfer", path("labels.nrrd"), "--mesh", path("a.vtu"), "--labels", "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("no voxel differs from 0"), std::string::npos) << outcome.error;
  EXPECT_EQ(image("cube.nrrd").values, std::vector<double>(343, 0.0));
}

TEST_F(TransferCommand, BeyondTheImageIsTheLabelOfTheBackground)
{
  FieldVolume half = imageOf(1, [](const Vector3 &, std::vector<double> & values) { values.push_back(3.0); });
  half.origin[0] -= 25.0;
  writeFieldImage(path("half.nrrd"), half, FieldValues::Labels);
  const auto with = [&](std::vector<std::string> more) {
    const std::vector<std::string> start{ "transfer", path("half.nrrd"), "--mesh", path("a.vtu"), "--labels" };
    more.insert(more.begin(), start.begin(), start.end());
    return run(more);
  };
  ASSERT_EQ(with({ "--to-cube", path("cube.nrrd"), "--background", "7" }).exitCode, 0);
  const FieldVolume cube = image("cube.nrrd");
  EXPECT_EQ(cube.values[0], 3.0);
  EXPECT_EQ(cube.values[6], 7.0);
  ASSERT_EQ(with({ "--to-cube", path("parts.nrrd"), "--background", "7", "--fractions" }).exitCode, 0);
  const FieldVolume parts = image("parts.nrrd");
  ASSERT_EQ(parts.components, 2); // of 3 and 7
  EXPECT_NEAR(parts.at(6)[1], 1.0, 1e-12);
  expectErrorCode(with({ "--to-cube", path("no.nrrd"), "--background", "0.5" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("no.nrrd"), "--background", "-1" }), "E_USAGE");
}

TEST_F(TransferCommand, NumbersThatAreNotFiniteAreNoDataInEveryFormat)
{
  const FieldVolume  grid = image("smooth.nrrd");
  std::vector<float> values(grid.gridVoxels(), 3.0F);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    if (voxel % 50 >= 25) // the left half
    {
      values[voxel] = voxel % 2 == 0 ? std::nanf("") : HUGE_VALF;
    }
  }
  const std::string voxels(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(float));
  std::ofstream(path("a.nrrd"), std::ios::binary)
    << "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 50 45 14\n"
       "space directions: (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: domain domain domain\nendian: little\n"
       "encoding: raw\nspace origin: (-2,-2,-1)\n\n"
    << voxels;
  std::ofstream(path("a.mha"), std::ios::binary)
    << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
       "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -2 -2 -1\nElementSpacing = 0.9 1 1.7\nDimSize = 50 45 14\n"
       "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n"
    << voxels;
  writeFieldImage(path("a.nii"), grid);
  std::string nifti = contentOf(path("a.nii")).substr(0, 352) + voxels;
  nifti[70] = 16; // 32-bit real numbers
  nifti[72] = 32;
  std::ofstream(path("a.nii"), std::ios::binary) << nifti;
  std::vector<double> first;
  for (const char * name : { "a.nrrd", "a.mha", "a.nii" })
  {
    const Outcome outcome =
      run({ "transfer", path(name), "--mesh", path("a.vtu"), "--to-cube", path("c.nrrd"), "--background", "-9" });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("voxels are not finite numbers"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find("% of the mesh lies beyond the image or its mask, or on voxels that are not finite"),
              std::string::npos)
      << outcome.error;
    const FieldVolume cube = image("c.nrrd");
    EXPECT_NEAR(cube.values[0], 3.0, 1e-9) << name;
    EXPECT_NEAR(cube.values[6], -9.0, 1e-9) << name;
    first = first.empty() ? cube.values : first;
    for (std::size_t box = 0; box < first.size(); ++box)
    {
      EXPECT_NEAR(cube.values[box], first[box], 0.01) << name << ' ' << box; // the place of NIfTI is single precision
    }
  }
}

TEST_F(TransferCommand, AListOfSixNumbersIsNoTensor)
{
  const auto list = [](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 });
  };
  writeFieldImage(path("list.nrrd"), imageOf(6, list));
  transfer({ path("list.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd") });
  EXPECT_EQ(contentOf(path("cube.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
  transfer({ path("list.nrrd"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nii") });
  const std::string nifti = contentOf(path("cube.nii"));
  constexpr int     vectors = 1007;
  EXPECT_EQ(static_cast<unsigned char>(nifti[68]) + 256 * static_cast<unsigned char>(nifti[69]), vectors);
  for (std::size_t plane = 0; plane < 6; ++plane)
  {
    double value = 0.0;
    std::memcpy(&value, nifti.data() + 352 + plane * 343 * sizeof value, sizeof value);
    EXPECT_NEAR(value, static_cast<double>(plane) + 1.0, 1e-12);
  }
  writeFieldImage(path("tensors.nii"), imageOf(6, list), FieldValues::SymmetricTensors);
  transfer({ path("tensors.nii"), "--mesh", path("a.vtu"), "--to-cube", path("cube.nrrd") });
  EXPECT_NE(contentOf(path("cube.nrrd")).find("3D-symmetric-matrix"), std::string::npos);
}

TEST_F(TransferCommand, OneSegmentIsTakenByItsName)
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 50 45 14\n"
                     "space directions: (0.9,0,0) (0,1,0) (0,0,1.7)\nkinds: domain domain domain\n"
                     "encoding: raw\nspace origin: (-2,-2,-1)\n"
                     "Segment0_ID:=S1\nSegment0_Name:=gland\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                     "Segment1_ID:=S2\nSegment1_Name:=lesion\nSegment1_LabelValue:=2\nSegment1_Layer:=0\n\n";
  for (std::size_t voxel = 0; voxel < std::size_t{ 50 } * 45 * 14; ++voxel)
  {
    text += voxel % 50 < 25 ? '\1' : '\2';
  }
  std::ofstream(path("a.seg.nrrd"), std::ios::binary) << text;
  const Outcome outcome = run({ "transfer",
                                path("a.seg.nrrd"),
                                "--mesh",
                                path("a.vtu"),
                                "--labels",
                                "--segment",
                                "lesion",
                                "--to-cube",
                                path("cube.nrrd") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("label 2 (lesion): "), std::string::npos) << outcome.out;
  EXPECT_EQ(image("cube.nrrd").values[0], 0.0);
  EXPECT_EQ(image("cube.nrrd").values[6], 2.0);
}

TEST_F(TransferCommand, RemediesAreOptionsOfThisCommand)
{
  const Outcome outcome =
    run({ "transfer", path("smooth.nrrd"), "--mesh", path("a.vtu"), "--labels", "--to-cube", path("cube.nrrd") });
  expectErrorCode(outcome, "E_LABELS");
  EXPECT_NE(outcome.error.find("leave --labels out"), std::string::npos) << outcome.error;
  const Outcome nodes = run({ "transfer",
                              path("smooth.nrrd"),
                              "--mesh",
                              path("a.vtu"),
                              "--to-mesh",
                              path("b.vtu"),
                              "--to-image",
                              path("out.nrrd"),
                              "--spacing",
                              "2",
                              "--conserve",
                              "--sampling",
                              "nodes" });
  expectErrorCode(nodes, "E_USAGE");
  EXPECT_NE(nodes.error.find("needs cells"), std::string::npos) << nodes.error;
}

TEST_F(TransferCommand, OptionsWithoutAPartAreRefused)
{
  std::ofstream(path("p.csv")) << "x,y,z\n20,15,8\n";
  writeFieldImage(path("cube.nrrd"), FieldVolume{ cubeGrid(CubeSampling::Cells, 7), 1, std::vector<double>(343, 1.0) });
  const std::size_t files = fileCount();
  const auto refused = [this](const std::string & input, std::vector<std::string> direction, const char * option) {
    std::vector<std::string> arguments{ "transfer", path(input), "--mesh", path("a.vtu") };
    arguments.insert(arguments.end(), direction.begin(), direction.end());
    const Outcome outcome = run(arguments);
    expectErrorCode(outcome, "E_USAGE");
    EXPECT_NE(outcome.error.find(option), std::string::npos) << outcome.error;
  };
  const std::string out = path("out.nrrd");
  const std::string like = path("smooth.nrrd");
  refused("p.csv", { "--to-cube", path("q.csv"), "--background", "3" }, "--background");
  refused("p.csv", { "--to-cube", path("q.csv"), "--sampling", "40" }, "--sampling");
  refused("p.csv", { "--to-cube", path("q.csv"), "--points", "8" }, "--points");
  refused("p.csv", { "--to-cube", path("q.csv"), "--nearest" }, "--nearest");
  refused("smooth.nrrd", { "--to-cube", out, "--like", like }, "--like");
  refused("smooth.nrrd", { "--to-cube", out, "--segment", "1" }, "--segment");
  refused("smooth.nrrd", { "--to-cube", out, "--fractions" }, "--fractions");
  refused("smooth.nrrd", { "--to-cube", out, "--values-in", "LPS" }, "--values-in");
  refused("smooth.nrrd", { "--to-cube", out, "--sampling", "nodes", "--points", "8" }, "--points");
  refused("smooth.nrrd", { "--to-cube", out, "--labels", "--conserve" }, "--labels");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--sampling", "40" }, "--sampling");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--points", "8" }, "--points");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--conserve", "--nearest" }, "--nearest");
  refused(
    "smooth.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", out, "--like", like, "--sampling", "40" }, "--sampling");
  refused(
    "smooth.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", out, "--like", like, "--points", "8" }, "--points");
  EXPECT_EQ(fileCount(), files);
}

TEST_F(TransferCommand, MassBeyondTheGridIsOfEachNumber)
{
  FieldVolume cube{ cubeGrid(CubeSampling::Cells, 7), 2, {} };
  for (std::size_t box = 0; box < cube.gridVoxels(); ++box)
  {
    cube.values.insert(cube.values.end(), { 1.0, -1.0 });
  }
  writeFieldImage(path("cube.nrrd"), cube);
  FieldVolume part = imageOf(1, [](const Vector3 &, std::vector<double> & values) { values.push_back(0.0); });
  part.origin[0] -= 25.0;
  writeFieldImage(path("part.nrrd"), part);
  const Outcome outcome = run({ "transfer",
                                path("cube.nrrd"),
                                "--mesh",
                                path("a.vtu"),
                                "--to-image",
                                path("out.nrrd"),
                                "--like",
                                path("part.nrrd"),
                                "--conserve" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("integral over the mesh of number 1"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("integral over the mesh of number 2"), std::string::npos) << outcome.error;
}

TEST_F(TransferCommand, TheMeasurementFrameIsWhereTheNumbersAre)
{
  const auto withFrame = [this](const std::string & frame, const std::vector<float> & vector) {
    const FieldVolume  grid = image("smooth.nrrd");
    std::vector<float> values;
    for (std::size_t voxel = 0; voxel < grid.gridVoxels(); ++voxel)
    {
      values.insert(values.end(), vector.begin(), vector.end());
    }
    std::string text = nrrdLike(grid, "vector", values);
    return text.insert(text.find("endian"), frame);
  };
  std::ofstream(path("lps.nrrd"), std::ios::binary) << withFrame("", { 1.0F, 2.0F, -2.0F });
  // The first axis of the frame is the second one of the image, and so on.
  std::ofstream(path("framed.nrrd"), std::ios::binary)
    << withFrame("measurement frame: (0,1,0) (0,0,1) (1,0,0)\n", { 2.0F, -2.0F, 1.0F });
  for (const char * name : { "lps", "framed" })
  {
    transfer({ path(std::string(name) + ".nrrd"),
               "--mesh",
               path("a.vtu"),
               "--to-cube",
               path(std::string(name) + "_cube.nrrd"),
               "--rotate" });
  }
  EXPECT_EQ(image("lps_cube.nrrd").values, image("framed_cube.nrrd").values);
}
