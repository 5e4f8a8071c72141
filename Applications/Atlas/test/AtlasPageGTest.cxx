// Exact: what the page of a made-up analysis says, and what colours its cells may have.
#include "AtlasCellFields.h"
#include "AtlasPage.h"
#include "PageName.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/CubeTransfer/CubeImage.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

constexpr int nodesPerSide = 4;
constexpr int nodeCount = nodesPerSide * nodesPerSide * nodesPerSide;

/** Three subjects, a mode of which one mesh shows less, and the mean: a box of 30 mm. */
AtlasResult
smallResult()
{
  AtlasResult result;
  for (const char * name : { "a", "b<i>", "c" })
  {
    result.subjects.subjects.push_back({ name, std::string(name) + ".vtu" });
    result.figures.push_back({ 27000.0, 20.0, "0,0 1,0 1,1" });
    result.distances.push_back(1.5);
  }
  result.alignment.deviation = 1.25;
  result.model.nodesPerSide = nodesPerSide;
  result.model.shape.variances = Eigen::Vector2d(3.0, 1.0);
  result.model.shape.totalVariance = 5.0;
  result.scores = Eigen::MatrixXd::Constant(3, 2, 0.5);
  result.covariances.assign(nodeCount, Matrix3::Identity() * 3.0);
  result.mean.mesh = analytic::lattice(nodesPerSide, [](const Vector3 & i) { return Vector3(10.0 * i); });
  result.mean.volume = 27000.0;
  result.mean.exact = true;
  result.modeMeshes = { { "mode-01-plus3.vtu", 2.5, 27000.0, 0.0, 0.1, { "at 3: cells are concave" } },
                        { "mode-01-minus3.vtu", -3.0, 27000.0, 0.0, 0.1, {} } };
  return result;
}

/** Node 0 of group 1 moved by 5 mm, p 0.01 there and 0.5 elsewhere. */
AtlasTest
testOf(const std::vector<std::string> & groups)
{
  AtlasTest test;
  test.name = groups.empty() ? "regression" : "group";
  test.column = "arm<b>";
  test.covariates = { "age" };
  test.groups = groups;
  test.groupSizes.assign(groups.size(), 2);
  test.subjects = { 0, 1, 2 };
  const auto columns = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(groups.size()) - 1);
  test.result.slope = Eigen::MatrixXd::Zero(3 * columns, nodeCount);
  test.result.slope.col(0).head<3>() = Vector3(3.0, 0.0, 4.0);
  test.result.p = test.result.pFamilyWise = test.result.qFalseDiscovery = Eigen::VectorXd::Constant(nodeCount, 0.5);
  test.result.pFamilyWise[0] = 0.01;
  test.result.partialCorrelation = test.result.standardisedDifference = Eigen::VectorXd::Constant(nodeCount, 0.5);
  test.result.permutations = 720;
  test.result.areAllOrders = true;
  test.result.smallestPossibleP = 0.002;
  return test;
}

/** Mean images i + 10 j + 100 k in the cells. */
MeanImage
smallImage()
{
  MeanImage         images;
  const VoxelGrid & grid = images.mean;
  static_cast<VoxelGrid &>(images.mean) = cubeGrid(CubeSampling::Cells, nodesPerSide - 1);
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        images.mean.values.push_back(i + 10.0 * j + 100.0 * k);
      }
    }
  }
  images.deviation = images.mean;
  images.subjects = 2;
  images.leftOut = { "c&" };
  return images;
}

const CellField &
fieldNamed(const std::vector<CellField> & fields, const std::string & id)
{
  return *std::find_if(fields.begin(), fields.end(), [&id](const CellField & field) { return field.id == id; });
}

AtlasOptions
someOptions()
{
  AtlasOptions options;
  options.images = "mri<u>";
  options.normaliseImages = true;
  options.threads = 1;
  return options;
}

class AtlasPage : public testing::Test
{
protected:
  void
  SetUp() override
  {
    if (!pagesAreBuilt())
    {
      GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
    }
  }
};

void
expectParts(const std::string & page, const std::vector<std::string> & parts)
{
  for (const std::string & part : parts)
  {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

} // namespace

TEST_F(AtlasPage, SaysHowFarTheMeshesOfModesGo)
{
  AtlasResult       result = smallResult();
  const std::string page = atlasPage(result, someOptions());
  expectParts(page,
              { "<td>60.0</td><td>60.0</td>", "<td>80.0</td>", "<td>&minus;3 to +2.5</td>", "<td>&ndash;</td></tr>" });
  EXPECT_EQ(page.find("<section id=\"tests\""), std::string::npos);
  EXPECT_EQ(page.find("<section id=\"images\""), std::string::npos);
  EXPECT_EQ(page, atlasPage(result, someOptions()));
  result.modeMeshes[1].deviations = 0.0;
  EXPECT_NE(atlasPage(result, someOptions()).find("none to +2.5"), std::string::npos);
}

TEST_F(AtlasPage, SaysOfEveryTestWhatWasFound)
{
  AtlasResult result = smallResult();
  result.tests = { testOf({ "control", "treated" }), testOf({}) };
  expectParts(
    atlasPage(result, someOptions()),
    { "arm&lt;b&gt;, treated (2) against control (2)",
      "<td>age</td><td>720, all orders</td><td>0.01</td><td>0.002</td><td>1</td><td>0</td><td>0.5</td><td>5 mm</td>",
      "<td>5 mm per unit</td>" });
}

TEST_F(AtlasPage, ShowsEachOfManyGroups)
{
  AtlasResult result = smallResult();
  result.tests = { testOf({ "a", "b<s>", "c" }) };
  // Of three groups of two, b moved by 5 mm: it is 2/3 of that from the mean of all, the others a third.
  expectParts(atlasPage(result, someOptions()), { "<td>a 1.67, b&lt;s&gt; 3.33, c 1.67 mm</td>", "b\\u003cs\\u003e" });
}

TEST_F(AtlasPage, ShowsTheMeanImageInSlices)
{
  AtlasResult result = smallResult();
  result.images = smallImage();
  const std::string page = atlasPage(result, someOptions());
  expectParts(page,
              { "<section id=\"images\"",
                "Mean of 2 images (column mri&lt;u&gt;, each made mean 0",
                "Left out, for the reasons above: c&amp;.",
                "<h3>Mean, 0 (black) to 222 (white)</h3>",
                "<image href=\"data:image/bmp;base64," });
  EXPECT_EQ(page.find("<i>"), std::string::npos);
}

TEST(AtlasCellFields, AreThoseOfTheMeanAndOfWhatWasAskedFor)
{
  AtlasResult result = smallResult();
  EXPECT_EQ(atlasCellFields(result).back().id, "deviation");
  EXPECT_EQ(atlasCellFields(result).back().values, std::vector<double>(27, 3.0));
  result.images = smallImage();
  result.tests = { testOf({ "control", "treated" }) };
  const std::vector<CellField> fields = atlasCellFields(result);
  const std::vector<double> &  image = fieldNamed(fields, "image-mean").values;
  EXPECT_NEAR(image.front(), 0.0, 1e-9);
  EXPECT_NEAR(image.back(), 222.0, 1e-9);
  EXPECT_NEAR(image[1 + 3 * 2 + 9 * 0], 21.0, 1e-9);
  EXPECT_EQ(fieldNamed(fields, "group-change-0").values.front(), 5.0 / 8.0); // one of eight nodes
  EXPECT_EQ(fieldNamed(fields, "group-effect").values.back(), 0.5);
  EXPECT_EQ(fieldNamed(fields, "group-p").values.front(), 0.01);
  EXPECT_EQ(fieldNamed(fields, "group-p").values.back(), 0.5);
}
