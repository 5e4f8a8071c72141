// Exact: what the command makes and says of a mesh that is tied to another one. Distances of nodes: bounds above what
// was measured. A lattice of 4 shells keeps the runs short.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/Geometry/AffineTransform.h"
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
#include <iostream>

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

  /** An image on a grid. \param valueAt  of a point [mm] */
  template <typename TFunction>
  void
  writeImage(const std::string & name, const VoxelGrid & grid, const TFunction & valueAt) const
  {
    FieldVolume image;
    static_cast<VoxelGrid &>(image) = grid;
    for (int k = 0; k < grid.size[2]; ++k)
    {
      for (int j = 0; j < grid.size[1]; ++j)
      {
        for (int i = 0; i < grid.size[0]; ++i)
        {
          image.values.push_back(valueAt(grid.point(i, j, k)));
        }
      }
    }
    writeFieldImage(path(name), image);
  }

  /** Waves, moved along the patient's left. \param shift  [mm] \param level  they are about it */
  void
  writePattern(const std::string & name, const VoxelGrid & grid, double shift, double level = 0.0) const
  {
    writeImage(name, grid, [=](const Vector3 & p) {
      return level + std::sin(0.15 * (p.x() - shift)) + std::cos(0.12 * p.y()) + std::sin(0.1 * p.z());
    });
  }

  /** A bright ball in the middle of the gland. \param radius  [mm] */
  void
  writeBall(const std::string & name, const LabelVolume & gland, double radius) const
  {
    const Vector3 middle = gland.point(gland.size[0] / 2, gland.size[1] / 2, gland.size[2] / 2);
    writeImage(name, gland, [=](const Vector3 & p) { return std::tanh(radius - (p - middle).norm()); });
  }

  /** Volume of the template's cells whose centres are in such a ball, now over before. */
  [[nodiscard]] double
  growthOfBall(const LabelVolume & gland, double radius) const
  {
    const Vector3             middle = gland.point(gland.size[0] / 2, gland.size[1] / 2, gland.size[2] / 2);
    const HexMesh             baseline = readHexMesh(path("baseline.vtu"));
    const std::vector<double> before = cellVolumes(baseline);
    const std::vector<double> after = cellVolumes(readHexMesh(path("tied.vtu")));
    double                    sumBefore = 0.0;
    double                    sumAfter = 0.0;
    for (std::size_t cell = 0; cell < before.size(); ++cell)
    {
      Vector3 centre = Vector3::Zero();
      for (const Vector3 & corner : cellCorners(baseline, cell))
      {
        centre += corner / 8.0;
      }
      if ((centre - middle).norm() < radius)
      {
        sumBefore += before[cell];
        sumAfter += after[cell];
      }
    }
    return sumAfter / sumBefore;
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
  EXPECT_FALSE(said["template"].contains("template_to_label"));
  EXPECT_NEAR(said["template"]["scale"], 1.0, 1e-6);
  EXPECT_LT(said["template"]["surface_rms_after_mm"], 0.5);
  EXPECT_LT(said["template"]["surface_median_after_mm"], 0.3);
  EXPECT_EQ(said["template"]["start"], "template");
  EXPECT_EQ(said["stages"][1]["note"].get<std::string>().rfind("brought by a given transform, scaled by 1", 0), 0u);
  EXPECT_TRUE(said["warnings"].empty()) << said["warnings"];
  writeTransform("mirror.tfm", "-1 0 0 0 1 0 0 0 1 0 0 0");
  expectErrorCode(tied("prostate.nrrd", { "--align=" + path("mirror.tfm") }), "E_GEOMETRY");
  expectErrorCode(tied("prostate.nrrd", { "--align=" + path("missing.tfm") }), "E_NOINPUT");
}

TEST_F(TemplateCommand, ATransformTheWrongWayRoundIsSaidToBe)
{
  LabelVolume gland = makeSampleProstate().gland;
  gland.origin += Vector3(6.0, -4.0, 3.0);
  writeLabelImage(path("moved.nrrd"), gland);
  writeTransform("back.tfm", "1 0 0 0 1 0 0 0 1 -6 4 -3");
  const Outcome near = tied("moved.nrrd", { "--align=" + path("back.tfm"), "--allow-partial" });
  ASSERT_EQ(near.exitCode, 0) << near.error;
  EXPECT_NE(near.error.find("warning: the inverse of the transform"), std::string::npos) << near.error;
  EXPECT_NE(near.error.find("--align"), std::string::npos) << near.error;
  writeTransform("far.tfm", "1 0 0 0 1 0 0 0 1 -90 40 -100");
  const Outcome far = tied("moved.nrrd", { "--align=" + path("far.tfm") });
  expectErrorCode(far, "E_TEMPLATE");
  EXPECT_NE(far.error.find("far.tfm"), std::string::npos) << far.error;
  EXPECT_EQ(far.error.find("moved.nrrd"), std::string::npos) << far.error;
}

TEST_F(TemplateCommand, ATemplateOfAnotherSizeOrPlaceIsDoubted)
{
  HexMesh baseline = readHexMesh(path("baseline.vtu"));
  for (Vector3 & node : baseline.nodes)
  {
    node = 0.1 * node;
  }
  writeHexMesh(path("baseline.vtu"), baseline); // centimetres
  const Outcome scaled = tied("prostate.nrrd");
  ASSERT_EQ(scaled.exitCode, 0) << scaled.error;
  EXPECT_NE(scaled.error.find("10 times as large"), std::string::npos) << scaled.error;
  EXPECT_NEAR(report()["template"]["scale"], 10.0, 1e-6);
  for (Vector3 & node : baseline.nodes)
  {
    node = 10.0 * node + Vector3(20.0, 0.0, 0.0);
  }
  writeHexMesh(path("baseline.vtu"), baseline);
  const Outcome beside = tied("prostate.nrrd", { "--align=none", "--allow-partial" });
  ASSERT_EQ(beside.exitCode, 0) << beside.error;
  EXPECT_NE(beside.error.find("before it was bent, the template's surface was"), std::string::npos) << beside.error;
  EXPECT_NE(beside.error.find("try --align rigid"), std::string::npos) << beside.error;
  EXPECT_GT(report()["template"]["surface_median_after_mm"], 5.0);
  EXPECT_EQ(report()["stages"][1]["note"].get<std::string>().rfind("taken as it lies, scaled by 1", 0), 0u);
}

TEST_F(TemplateCommand, AWrittenTransformBringsTheTemplateToTheSamePlace)
{
  LabelVolume   gland = makeSampleProstate().gland;
  const Matrix3 turn = Eigen::AngleAxis<double>(0.2, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  gland.origin = turn * gland.origin + Vector3(30.0, -20.0, 100.0);
  gland.direction = turn * gland.direction;
  writeLabelImage(path("moved.nrrd"), gland);
  const Outcome outcome = tied("moved.nrrd", { "--write-transform=" + path("found.tfm") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const HexMesh   once = readHexMesh(path("tied.vtu"));
  const auto      rows = report()["template"]["template_to_label"];
  AffineTransform motion;
  for (int row = 0; row < 3; ++row)
  {
    motion.matrix.row(row) = Vector3(rows[row][0], rows[row][1], rows[row][2]).transpose();
    motion.translation[row] = rows[row][3];
  }
  EXPECT_LT((motion.matrix - turn).norm(), 0.02);

  const std::vector<std::string> compare{ "compare", path("baseline.vtu"), path("tied.vtu"), "--output", path("out"),
                                          "--quiet", "--transforms",       path("found.tfm") };
  ASSERT_EQ(run(compare).exitCode, 0);
  const HexMesh aligned = readHexMesh(path("out/time-001.vtu"));
  ASSERT_EQ(aligned.nodes.size(), once.nodes.size());
  double farthest = 0.0;
  for (std::size_t node = 0; node < once.nodes.size(); ++node)
  {
    farthest = std::max(farthest, (motion(aligned.nodes[node]) - once.nodes[node]).norm());
  }
  EXPECT_LT(farthest, 1e-9);

  const std::string note = report()["template"].dump();
  ASSERT_EQ(tied("moved.nrrd", { "--align=" + path("found.tfm") }).exitCode, 0);
  const HexMesh again = readHexMesh(path("tied.vtu"));
  farthest = 0.0;
  for (std::size_t node = 0; node < once.nodes.size(); ++node)
  {
    farthest = std::max(farthest, (again.nodes[node] - once.nodes[node]).norm());
  }
  EXPECT_LT(farthest, 1e-3) << note;
}

TEST_F(TemplateCommand, OnlyATransformThatWasFoundIsWritten)
{
  writeTransform("move.tfm", "1 0 0 0 1 0 0 0 1 30 -20 100");
  const std::string write = "--write-transform=" + path("found.tfm");
  expectErrorCode(tied("prostate.nrrd", { write, "--align=none" }), "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { write, "--align=" + path("move.tfm") }), "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { "--write-transform=" + path("found.h5") }), "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { "--write-transform=" + path("no/found.tfm") }), "E_CANTCREAT");
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.vtu"), write }), "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { write, "--report=" + path("found.tfm") }), "E_USAGE");
}

TEST_F(TemplateCommand, AnAlignmentWithoutATemplateIsRefused)
{
  for (const char * align : { "affine", "none" })
  {
    expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--align", align }), "E_USAGE");
  }
}

TEST_F(TemplateCommand, FaultsAreThoseOfTheirFiles)
{
  const LabelVolume gland = makeSampleProstate().gland;
  VoxelGrid         aside = gland;
  aside.origin += Vector3(15.0, 0.0, 0.0);
  writePattern("good.nrrd", gland, 0.0);
  writePattern("aside.nrrd", aside, 0.0);
  std::ofstream(path("here.csv")) << "label,x,y,z\na,3,-21,14\nb,8,-21,14\n";
  std::ofstream(path("mirrored.csv")) << "label,x,y,z\na,-3,21,14\nb,-8,21,14\n";
  LabelVolume far = gland;
  far.origin += Vector3(150.0, 0.0, 0.0);
  writeLabelImage(path("far.nrrd"), far);
  const auto expectFault =
    [this](const std::string & label, const std::vector<std::string> & more, const char * code, const char * file) {
      std::vector<std::string> arguments{ "--align=none" };
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Outcome outcome = tied(label, arguments);
      expectErrorCode(outcome, code);
      EXPECT_NE(outcome.error.find(std::string(file) + ": "), std::string::npos) << outcome.error;
      EXPECT_EQ(outcome.error.find("editor"), std::string::npos) << outcome.error;
    };
  const auto images = [this](const std::string & image, const std::string & ofTemplate) {
    return std::vector<std::string>{ "--image=" + path(image), "--template-image=" + path(ofTemplate) };
  };
  const auto landmarks = [this](const std::string & points, const std::string & ofTemplate) {
    return std::vector<std::string>{ "--landmarks=" + path(points), "--template-landmarks=" + path(ofTemplate) };
  };
  expectFault("prostate.nrrd", images("aside.nrrd", "good.nrrd"), "E_IMAGE", "aside.nrrd");
  expectFault("prostate.nrrd", images("good.nrrd", "aside.nrrd"), "E_TEMPLATE_IMAGE", "aside.nrrd");
  expectFault("prostate.nrrd", landmarks("mirrored.csv", "here.csv"), "E_LANDMARKS", "mirrored.csv");
  expectFault("prostate.nrrd", landmarks("here.csv", "mirrored.csv"), "E_TEMPLATE_LANDMARKS", "mirrored.csv");
  expectFault("far.nrrd", {}, "E_TEMPLATE", "baseline.vtu");
}

TEST_F(TemplateCommand, LandmarksOutsideOfTheOrganAreNamed)
{
  std::ofstream(path("t.csv")) << "label,x,y,z\ncentre,3,-21,14\nleft,8,-21,14\nback,3,-16,14\n";
  std::ofstream(path("s.csv")) << "label,x,y,z\nback,3,79,14\ncentre,3,-21,14\nleft,8,-21,14\n";
  const Outcome outcome =
    tied("prostate.nrrd", { "--align=none", "--landmarks=" + path("s.csv"), "--template-landmarks=" + path("t.csv") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("warning: landmarks outside of the label: back by "), std::string::npos)
    << outcome.error;
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

TEST_F(TemplateCommand, ANoduleThatDoublesIsMeasured)
{
  const LabelVolume gland = makeSampleProstate().gland;
  writeBall("t.nrrd", gland, 10.0);
  writeBall("s.nrrd", gland, 10.0 * std::cbrt(2.0));
  const std::vector<std::string> images{ "--align=none",
                                         "--image=" + path("s.nrrd"),
                                         "--template-image=" + path("t.nrrd") };
  std::vector<std::string>       growing = images;
  growing.emplace_back("--local-growth");
  const auto largestGrowth = [&](const std::vector<std::string> & options, bool isUniform) {
    EXPECT_EQ(tied("prostate.nrrd", options).exitCode, 0);
    EXPECT_TRUE(report()["exact"]["reached"]);
    EXPECT_EQ(report()["template"].contains("local_growth"), !isUniform);
    const Outcome compared =
      run({ "compare", path("baseline.vtu"), path("tied.vtu"), "--align=none", "--output=" + path("change") });
    EXPECT_EQ(compared.exitCode, 0) << compared.error;
    EXPECT_EQ(compared.out.find("cells grow differently") == std::string::npos, isUniform);
    const auto followUp = nlohmann::json::parse(contentOf(path("change/summary.json")))["times"][1];
    EXPECT_EQ(followUp["uniform_growth"].get<bool>(), isUniform);
    return followUp["organ"]["volumetric"]["max"].get<double>();
  };
  EXPECT_NEAR(largestGrowth(images, true), 0.0, 1e-6);
  EXPECT_NEAR(growthOfBall(gland, 10.0), 1.0, 1e-6);
  EXPECT_GT(largestGrowth(growing, false), 0.6); // single cells overshoot
  const double found = growthOfBall(gland, 10.0);
  std::cout << "growth of the ball " << found << std::endl;
  EXPECT_NEAR(found, 2.0, 0.4); // cells of 5 mm, a ball of 10
}

TEST_F(TemplateCommand, ATemplateWhoseCellsAreOtherPartsOfTheOrganIsAWarning)
{
  HexMeshFields fields;
  for (const char * array : { "MeanDensity", "SmallestGrowth", "NotExact" })
  {
    fields.meshArrays.push_back({ array, 1, { 1.0 } });
  }
  const HexMesh baseline = readHexMesh(path("baseline.vtu"));
  writeHexMesh(path("baseline.vtu"), baseline, fields);
  const Outcome outcome = tied("prostate.nrrd", { "--align=none" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  for (const char * what : { "hold equal masses of a density", "were free to grow", "was not made exact" })
  {
    EXPECT_NE(outcome.error.find(what), std::string::npos) << outcome.error;
  }
}

TEST_F(TemplateCommand, LocalGrowthNeedsATemplateOfEqualCells)
{
  HexMesh uneven = readHexMesh(path("baseline.vtu"));
  for (Vector3 & node : uneven.nodes)
  {
    node += 0.002 * node[0] * node[0] * Vector3::UnitX();
  }
  writeHexMesh(path("baseline.vtu"), uneven);
  const LabelVolume gland = makeSampleProstate().gland;
  writeBall("t.nrrd", gland, 10.0);
  const Outcome outcome =
    tied("prostate.nrrd",
         { "--align=none", "--image=" + path("t.nrrd"), "--template-image=" + path("t.nrrd"), "--local-growth" });
  expectErrorCode(outcome, "E_TEMPLATE");
  EXPECT_NE(outcome.error.find("baseline.vtu: the volumes of its cells differ"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("tie to a mesh of equal cells"), std::string::npos) << outcome.error;
}

TEST_F(TemplateCommand, RefinementsThatAreHalfGivenAreRefused)
{
  expectErrorCode(tied("prostate.nrrd", { "--local-growth" }), "E_USAGE");
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
