// Fields that are linear in the cube: quadrature and interpolation are exact for them, so images to 1e-9.
#include "CommandTest.h"
#include "TextTable.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <nlohmann/json.hpp>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

constexpr int nodesPerSide = 6;
constexpr int cells = nodesPerSide - 1;

/** Boxes of other sides and places each. */
Vector3
sidesOf(int subject)
{
  return { 30.0 + subject, 24.0 - 0.5 * subject, 20.0 + 0.3 * subject * subject };
}

Vector3
cornerOf(int subject)
{
  return { 10.0 * subject, -5.0, 3.0 * subject };
}

HexMesh
boxOf(int subject)
{
  HexMesh mesh{ nodesPerSide, {} };
  for (int node = 0; node < nodesPerSide * nodesPerSide * nodesPerSide; ++node)
  {
    const Vector3 c =
      Vector3(node % nodesPerSide, node / nodesPerSide % nodesPerSide, node / (nodesPerSide * nodesPerSide)) / cells;
    mesh.nodes.push_back(cornerOf(subject) + sidesOf(subject).cwiseProduct(c));
  }
  return mesh;
}

/** Over the cube a subject's field is level + slope c_x. */
double
levelOf(int subject)
{
  return 100.0 + 7.0 * subject;
}

double
slopeOf(int subject)
{
  return 20.0 - 3.0 * subject;
}

/** Mean and standard deviation over subjects 0 to count - 1 of level + slope c. */
std::pair<double, double>
momentsAt(double c, int count)
{
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += levelOf(i) + slopeOf(i) * c;
  }
  for (int i = 0; i < count; ++i)
  {
    squares += std::pow(levelOf(i) + slopeOf(i) * c - sum / count, 2);
  }
  return { sum / count, std::sqrt(squares / (count - 1)) };
}

/** The subject's field, and minus it as a second component where asked for, on voxels around its box. */
FieldVolume
imageOf(int subject, int components, const Vector3 & shift = Vector3::Zero())
{
  FieldVolume image{ VoxelGrid{ { { 30, 18, 24 } }, { 1.5, 2.0, 1.7 }, cornerOf(subject) - Vector3(3, 4, 5) + shift },
                     components,
                     {} };
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        const double c = (image.point(i, j, k)[0] - cornerOf(subject)[0]) / sidesOf(subject)[0];
        for (int component = 0; component < components; ++component)
        {
          image.values.push_back((component == 0 ? 1.0 : -1.0) * (levelOf(subject) + slopeOf(subject) * c));
        }
      }
    }
  }
  return image;
}

class AtlasImages : public CommandTest
{
protected:
  /** 0.vtu, 0.nrrd, ... and table.csv with a column mri. */
  void
  writeSubjects(int count, int components = 1) const
  {
    std::string table = "mesh,mri\n";
    for (int i = 0; i < count; ++i)
    {
      const std::string name = std::to_string(i);
      writeHexMesh(path(name + ".vtu"), boxOf(i));
      writeFieldImage(path(name + ".nrrd"), imageOf(i, components));
      table += name + ".vtu," + name + ".nrrd\n";
    }
    writeTextFile(path("table.csv"), table);
  }

  [[nodiscard]] Outcome
  atlas(const std::vector<std::string> & more, const std::string & input = "table.csv") const
  {
    std::vector<std::string> arguments{ "atlas",        path(input),       "--output",    path("out"),
                                        "--no-sandbox", "--mode-meshes=0", "--samples=10" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  [[nodiscard]] FieldVolume
  image(const std::string & name) const
  {
    return readFieldImage(path("out/" + name)).volume;
  }

  [[nodiscard]] nlohmann::json
  summary() const
  {
    return nlohmann::json::parse(contentOf(path("out/atlas.json")));
  }
};

} // namespace

TEST_F(AtlasImages, MeanAndDeviationInTheCubeAreThoseOfTheFields)
{
  writeSubjects(5);
  const Outcome outcome = atlas({ "--images=mri" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  const FieldVolume mean = image("mean_image_cube.nrrd");
  const FieldVolume deviation = image("sd_image_cube.nrrd");
  ASSERT_EQ(cubeSamplingOf(mean), CubeSampling::Cells);
  ASSERT_EQ(mean.size[0], cells);
  ASSERT_EQ(deviation.values.size(), mean.values.size());
  for (std::size_t cell = 0; cell < mean.values.size(); ++cell)
  {
    const auto [expectedMean, expectedDeviation] = momentsAt((static_cast<double>(cell % cells) + 0.5) / cells, 5);
    EXPECT_NEAR(mean.values[cell], expectedMean, 1e-9);
    EXPECT_NEAR(deviation.values[cell], expectedDeviation, 1e-9);
  }
  EXPECT_EQ(summary()["images"]["subjects"], 5);
  EXPECT_EQ(summary()["images"]["left_out"], std::vector<std::string>{});
}

TEST_F(AtlasImages, TheMeanImageLiesOnTheTemplatesVoxels)
{
  writeSubjects(4);
  ASSERT_EQ(atlas({ "--images=mri", "--image-sampling=nodes" }).exitCode, 0);
  EXPECT_EQ(cubeSamplingOf(image("mean_image_cube.nrrd")), CubeSampling::Nodes);
  const FieldVolume label = image("template.nrrd");
  const FieldVolume mean = image("mean_image.nrrd");
  ASSERT_EQ(mean.size, label.size);
  EXPECT_EQ(mean.origin, label.origin);
  const BoundingBox box = boundingBox(readHexMesh(path("out/mean.vtu")).nodes);
  std::size_t       inside = 0;
  for (std::size_t voxel = 0; voxel < mean.values.size(); ++voxel)
  {
    if (label.values[voxel] == 0.0)
    {
      EXPECT_EQ(mean.values[voxel], 0.0);
      continue;
    }
    ++inside;
    const double x = mean.point(static_cast<int>(voxel) % mean.size[0], 0, 0)[0];
    const double c = (x - box.lower[0]) / (box.upper[0] - box.lower[0]);
    EXPECT_NEAR(mean.values[voxel], momentsAt(c, 4).first, 1e-6);
  }
  EXPECT_GT(inside, 10000u);
}

TEST_F(AtlasImages, NormalisedImagesOfOneFormAreAllTheSame)
{
  writeSubjects(4);
  ASSERT_EQ(atlas({ "--images=mri", "--normalise-images", "--image-sampling=3" }).exitCode, 0);
  const FieldVolume mean = image("mean_image_cube.nrrd");
  const FieldVolume deviation = image("sd_image_cube.nrrd");
  ASSERT_EQ(mean.size[0], 3);
  for (std::size_t box = 0; box < mean.values.size(); ++box)
  {
    const double c = (static_cast<double>(box % 3) + 0.5) / 3.0;
    EXPECT_NEAR(mean.values[box], (c - 0.5) * std::sqrt(12.0), 1e-9); // of c uniform in [0,1]
    EXPECT_NEAR(deviation.values[box], 0.0, 1e-9);
  }
  EXPECT_EQ(summary()["images"]["normalised"], true);
}

TEST_F(AtlasImages, ComponentsAreAveragedEachByItself)
{
  writeSubjects(3, 2);
  ASSERT_EQ(atlas({ "--images=mri" }).exitCode, 0);
  const FieldVolume mean = image("mean_image_cube.nrrd");
  ASSERT_EQ(mean.components, 2);
  for (std::size_t cell = 0; cell < mean.gridVoxels(); ++cell)
  {
    EXPECT_NEAR(mean.at(cell)[0], momentsAt((static_cast<double>(cell % cells) + 0.5) / cells, 3).first, 1e-9);
    EXPECT_EQ(mean.at(cell)[1], -mean.at(cell)[0]);
  }
}

TEST_F(AtlasImages, SubjectsWithoutAnImageOfTheWholeOrganAreLeftOutAndNamed)
{
  writeSubjects(5);
  writeFieldImage(path("3.nrrd"), imageOf(3, 1, Vector3(20, 0, 0))); // begins within the box
  writeTextFile(path("table.csv"), "mesh,mri\n0.vtu,0.nrrd\n1.vtu,1.nrrd\n2.vtu,2.nrrd\n3.vtu,3.nrrd\n4.vtu,n/a\n");
  const Outcome outcome = atlas({ "--images=mri" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("images: 3 is left out: "), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("images: 4 is left out: no image in the table"), std::string::npos) << outcome.error;
  const auto json = summary();
  EXPECT_EQ(json["images"]["subjects"], 3);
  EXPECT_EQ(json["images"]["left_out"], (std::vector<std::string>{ "3", "4" }));
  EXPECT_EQ(json["warnings"].size(), 2u);
  EXPECT_EQ(json["subjects"], 5);
  EXPECT_NEAR(image("mean_image_cube.nrrd").values[0], momentsAt(0.5 / cells, 3).first, 1e-9);
}

TEST_F(AtlasImages, GroupsAreComparedInTheCellsOfTheImages)
{
  writeSubjects(8, 2);
  // The level rises by 7 a subject, the slope falls by 3; the groups are 3.5 subjects apart.
  std::string table = "mesh,mri,arm\n";
  for (int i = 0; i < 8; ++i)
  {
    const std::string name = std::to_string(i);
    table += name + ".vtu," + (i == 7 ? "" : name + ".nrrd") + "," + (i < 4 ? "low" : "up") + "\n";
  }
  writeTextFile(path("table.csv"), table);
  const Outcome outcome = atlas({ "--images=mri", "--group=arm", "--permutations=999" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto test = summary()["tests"]["group_image"];
  EXPECT_EQ(test["group_sizes"], (std::vector<int>{ 4, 3 })); // one has no image
  EXPECT_EQ(summary()["tests"]["group"]["group_sizes"], (std::vector<int>{ 4, 4 }));
  EXPECT_EQ(test["permutations"], 35);
  EXPECT_NE(outcome.out.find("of 125 cells at 0.05"), std::string::npos) << outcome.out;
  const TextTable result = readTextTable(path("out/group_image.csv"));
  ASSERT_EQ(result.rows.size(), 125u);
  EXPECT_EQ(std::vector<std::string>(result.columns.begin(), result.columns.begin() + 9),
            (std::vector<std::string>{ "cell", "i", "j", "k", "x", "y", "z", "difference_1", "difference_2" }));
  for (const TextTable::Row & row : result.rows)
  {
    const double c = (std::stod(row.cells[1]) + 0.5) / cells;
    EXPECT_NEAR(std::stod(row.cells[7]), 24.5 - 10.5 * c, 1e-9);
    EXPECT_NEAR(std::stod(row.cells[8]), -24.5 + 10.5 * c, 1e-9);
  }
  EXPECT_NE(contentOf(path("out/group_image.vtu")).find("Name=\"Difference_2\""), std::string::npos);
}

TEST_F(AtlasImages, WhereTheirTestsCannotBeMadeTheRestIs)
{
  writeSubjects(7);
  std::string table = "mesh,mri,arm\n";
  for (int i = 0; i < 7; ++i)
  {
    const std::string name = std::to_string(i);
    table += name + ".vtu," + (i < 4 ? name + ".nrrd" : "") + "," + (i < 4 ? "low" : "up") + "\n";
  }
  writeTextFile(path("table.csv"), table);
  const Outcome nobody = atlas({ "--images=mri", "--group=arm", "--permutations=9" });
  ASSERT_EQ(nobody.exitCode, 0) << nobody.error;
  EXPECT_NE(nobody.error.find("images: not tested; arm: no subject of the group up"), std::string::npos)
    << nobody.error;
  EXPECT_TRUE(fs::exists(path("out/group.csv")));
  EXPECT_FALSE(fs::exists(path("out/group_image.csv")));
  const Outcome nodes = atlas({ "--images=mri", "--group=arm", "--permutations=9", "--image-sampling=nodes" });
  ASSERT_EQ(nodes.exitCode, 0) << nodes.error;
  EXPECT_NE(nodes.error.find("images: not tested; that needs --image-sampling cells"), std::string::npos);
}

TEST_F(AtlasImages, Refusals)
{
  writeSubjects(3);
  expectErrorCode(atlas({ "--images=ct" }), "E_FORMAT");
  expectErrorCode(atlas({ "--images=mri", path("1.vtu") }, "0.vtu"), "E_FORMAT"); // no table
  expectErrorCode(atlas({ "--images=mri", "--image-sampling=corners" }), "E_USAGE");
  expectErrorCode(atlas({ "--image-sampling=nodes" }), "E_USAGE");
  expectErrorCode(atlas({ "--images=mri", "--project=model.json" }), "E_USAGE");
  writeFieldImage(path("2.nrrd"), imageOf(2, 3));
  expectErrorCode(atlas({ "--images=mri" }), "E_PIXELTYPE");
  writeTextFile(path("table.csv"), "mesh,mri\n0.vtu,0.nrrd\n1.vtu,\n2.vtu,n/a\n");
  expectErrorCode(atlas({ "--images=mri" }), "E_PRECONDITION");
  writeTextFile(path("table.csv"), "mesh,mri\n0.vtu,0.nrrd\n1.vtu,9.nrrd\n");
  expectErrorCode(atlas({ "--images=mri" }), "E_NOINPUT");
  EXPECT_FALSE(fs::exists(path("out/atlas.json")));
}
