// Exact: what the command makes and says of a mesh that is tied to another one. Distances of nodes: bounds above what
// was measured. A lattice of 4 shells keeps the runs short.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class TemplateCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    writeSample();
    ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("baseline.vtu"), "--shells=4", "--quiet" }).exitCode, 0);
  }

  [[nodiscard]] Outcome
  tied(const std::string & label, const std::vector<std::string> & more = {}) const
  {
    std::vector<std::string> arguments{ "mesh",
                                        path(label),
                                        path("tied.vtu"),
                                        "--shells=4",
                                        "--quiet",
                                        "--template=" + path("baseline.vtu"),
                                        "--report=" + path("tied.json") };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /** Of corresponding nodes [mm]. */
  [[nodiscard]] double
  medianDistance() const
  {
    const HexMesh       a = readHexMesh(path("baseline.vtu"));
    const HexMesh       b = readHexMesh(path("tied.vtu"));
    std::vector<double> distances;
    for (std::size_t node = 0; node < a.nodes.size(); ++node)
    {
      distances.push_back((a.nodes[node] - b.nodes[node]).norm());
    }
    std::sort(distances.begin(), distances.end());
    return distances[distances.size() / 2];
  }

  /** \param matrix  rows of the matrix, then the translation */
  void
  writeTransform(const std::string & name, const std::string & matrix) const
  {
    std::ofstream(path(name)) << "#Insight Transform File V1.0\n#Transform 0\n"
                                 "Transform: AffineTransform_double_3_3\nParameters: "
                              << matrix << "\nFixedParameters: 0 0 0\n";
  }

  /** Waves on the label's grid, moved along the patient's left. \param shift  [mm] \param level  they are about it */
  void
  writePattern(const std::string & name, const VoxelGrid & grid, double shift, double level = 0.0) const
  {
    FieldVolume image;
    static_cast<VoxelGrid &>(image) = grid;
    for (int k = 0; k < grid.size[2]; ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          const Vector3 p = grid.point(i, j, k);
          image.values.push_back(level + std::sin(0.15 * (p.x() - shift)) + std::cos(0.12 * p.y()) +
                                 std::sin(0.1 * p.z()));
        }
      }
    }
    writeFieldImage(path(name), image);
  }

  [[nodiscard]] nlohmann::json
  report() const
  {
    return nlohmann::json::parse(contentOf(path("tied.json")));
  }
};

} // namespace

TEST_F(TemplateCommand, TheSameLabelGetsTheSameMesh)
{
  ASSERT_EQ(tied("prostate.nrrd", { "--align=none" }).exitCode, 0);
  EXPECT_LT(medianDistance(), 1e-9); // scaled to the same volume, to round-off
  const nlohmann::json said = report();
  EXPECT_EQ(said["template"]["file"], path("baseline.vtu"));
  EXPECT_EQ(said["template"]["sha256"], sha256OfFile(path("baseline.vtu")));
  EXPECT_EQ(said["stages"][1]["name"], "template");
  EXPECT_TRUE(said["exact"]["reached"]);
}

TEST_F(TemplateCommand, ATurnOfTheTemplateIsTheMeshes)
{
  const NamedArray turn{ "LatticeTurn", 3, { 0.0, 0.0, 45.0 } };
  HexMeshFields    fields;
  fields.meshArrays = { turn };
  writeHexMesh(path("turned.vtu"), readHexMesh(path("baseline.vtu")), fields);
  std::filesystem::rename(path("turned.vtu"), path("baseline.vtu"));
  const Outcome outcome = tied("prostate.nrrd", { "--align=none" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("baseline.vtu: the lattice is turned by 45 degrees about (0 0 1)"), std::string::npos)
    << outcome.error;
  const HexMeshFile mesh = readHexMeshFile(path("tied.vtu"));
  ASSERT_EQ(mesh.meshArrays.size(), 1u);
  EXPECT_EQ(mesh.meshArrays[0].name, turn.name);
  EXPECT_EQ(mesh.meshArrays[0].values, turn.values);
  EXPECT_EQ(report()["lattice_turn_degrees"], nlohmann::json(turn.values));
}

TEST_F(TemplateCommand, WithADensityMassesAreEqual)
{
  writePattern("density.nrrd", makeSampleProstate().gland, 0.0, 4.0);
  const std::string density = "--density=" + path("density.nrrd");
  ASSERT_EQ(tied("prostate.nrrd", { "--align=none", density }).exitCode, 0);
  const nlohmann::json said = report();
  EXPECT_TRUE(said["exact"]["reached"]);
  EXPECT_LE(said["exact"]["variance"].get<double>(), 1e-18);
  EXPECT_EQ(said["density"]["file"], path("density.nrrd"));
  EXPECT_EQ(said["stages"].back()["name"], "masses");
  const Outcome refused =
    tied("prostate.nrrd", { density, "--image=" + path("density.nrrd"), "--template-image=" + path("density.nrrd") });
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_NE(refused.error.find("--density"), std::string::npos) << refused.error;
}

TEST_F(TemplateCommand, AMovedLabelIsFound)
{
  LabelVolume gland = makeSampleProstate().gland;
  gland.origin += Vector3(30.0, -20.0, 100.0);
  writeLabelImage(path("moved.nrrd"), gland);
  const Outcome outcome = tied("moved.nrrd");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NEAR(report()["template"]["moved_mm"], Vector3(30.0, -20.0, 100.0).norm(), 0.5);
  EXPECT_LT(report()["template"]["turned_degrees"], 1.0);
  EXPECT_NEAR(medianDistance(), Vector3(30.0, -20.0, 100.0).norm(), 0.5);
}

TEST_F(TemplateCommand, TemplatesThatDoNotFitAreRefused)
{
  expectErrorCode(tied("prostate.nrrd", { "--padding=1" }), "E_USAGE");
  expectErrorCode(
    run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--template=" + path("baseline.vtu"), "--quiet" }),
    "E_NOT_HEXAHEDRA"); // 10 shells
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--template=" + path("missing.vtu"), "--quiet" }),
                  "E_NOINPUT");
  expectErrorCode(
    run({ "mesh", path("prostate.nrrd"), path("baseline.vtu"), "--template=" + path("baseline.vtu"), "--quiet" }),
    "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { "--align=similarity" }), "E_USAGE");
}

TEST_F(TemplateCommand, ATransformOfAFileBringsTheTemplateToTheLabel)
{
  LabelVolume gland = makeSampleProstate().gland;
  gland.origin += Vector3(30.0, -20.0, 100.0);
  writeLabelImage(path("moved.nrrd"), gland);
  writeTransform("move.tfm", "1 0 0 0 1 0 0 0 1 30 -20 100");
  const Outcome outcome = tied("moved.nrrd", { "--align=" + path("move.tfm") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NEAR(medianDistance(), Vector3(30.0, -20.0, 100.0).norm(), 1e-6);
  const nlohmann::json said = report();
  EXPECT_EQ(said["template"]["alignment"], "file");
  EXPECT_EQ(said["template"]["transform"]["sha256"], sha256OfFile(path("move.tfm")));
  EXPECT_FALSE(said["template"].contains("moved_mm"));
  writeTransform("mirror.tfm", "-1 0 0 0 1 0 0 0 1 0 0 0");
  expectErrorCode(tied("prostate.nrrd", { "--align=" + path("mirror.tfm") }), "E_GEOMETRY");
  expectErrorCode(tied("prostate.nrrd", { "--align=" + path("missing.tfm") }), "E_NOINPUT");
}

TEST_F(TemplateCommand, LandmarksDrawTheMesh)
{
  const HexMesh baseline = readHexMesh(path("baseline.vtu"));
  std::ofstream onTemplate(path("t.csv"));
  std::ofstream onLabel(path("s.csv"));
  onTemplate << "label,x,y,z\n";
  onLabel << "label,x,y,z\n";
  const Matrix3 turn = Eigen::AngleAxis<double>(0.15, Vector3::UnitZ()).toRotationMatrix();
  for (const std::size_t node : { 219u, 220u, 227u, 228u, 283u, 284u, 291u, 292u }) // the cell in the middle
  {
    const Vector3 from = baseline.nodes[node];
    const Vector3 to = turn * from;
    onTemplate << node << ',' << from[0] << ',' << from[1] << ',' << from[2] << '\n';
    onLabel << node << ',' << to[0] << ',' << to[1] << ',' << to[2] << '\n';
  }
  onTemplate.close();
  onLabel.close();
  const Outcome outcome =
    tied("prostate.nrrd", { "--align=none", "--landmarks=" + path("s.csv"), "--template-landmarks=" + path("t.csv") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const nlohmann::json said = report();
  EXPECT_TRUE(said["exact"]["reached"]);
  EXPECT_EQ(said["stages"].back()["name"], "refined");
  EXPECT_EQ(said["template"]["landmarks"]["sha256"], sha256OfFile(path("s.csv")));
  const double before = said["template"]["landmark_rms_mm_before"];
  const double after = said["template"]["landmark_rms_mm_after"];
  EXPECT_GT(before, 0.1);
  EXPECT_LT(after, 0.5 * before);
}

TEST_F(TemplateCommand, ImagesDrawTheMesh)
{
  const LabelVolume gland = makeSampleProstate().gland;
  writePattern("t.nrrd", gland, 0.0);
  writePattern("s.nrrd", gland, 3.0);
  const Outcome outcome =
    tied("prostate.nrrd", { "--align=none", "--image=" + path("s.nrrd"), "--template-image=" + path("t.nrrd") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const nlohmann::json said = report();
  EXPECT_TRUE(said["exact"]["reached"]);
  const double before = said["template"]["image_difference_before"];
  const double after = said["template"]["image_difference_after"];
  EXPECT_LT(after, 0.9 * before); // the surface has not moved with the waves, so that only a part can be followed
}

TEST_F(TemplateCommand, RefinementsThatAreHalfGivenAreRefused)
{
  std::ofstream(path("t.csv")) << "label,x,y,z\na,1,2,3\n";
  expectErrorCode(tied("prostate.nrrd", { "--landmarks=" + path("t.csv") }), "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { "--template-image=" + path("t.nrrd") }), "E_USAGE");
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--align=" + path("move.tfm") }), "E_USAGE");
  expectErrorCode(run({ "mesh",
                        path("prostate.nrrd"),
                        path("a.vtu"),
                        "--landmarks=" + path("t.csv"),
                        "--template-landmarks=" + path("t.csv") }),
                  "E_USAGE");
  expectErrorCode(tied("prostate.nrrd",
                       { "--image=" + path("prostate.nrrd"),
                         "--template-image=" + path("prostate.nrrd"),
                         "--landmarks=" + path("missing.csv"),
                         "--template-landmarks=" + path("t.csv") }),
                  "E_NOINPUT");
}
