// Labels whose details are narrower than the lattice's cells. Verdicts and documented bounds.
#include "PipelineRun.h"

#include "moserhex/Common/ErrorCode.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

constexpr int defaultSide = 32;

LabelVolume
cubicLabel(const std::function<bool(const Eigen::Vector3i &)> & isInside, int side = defaultSide)
{
  LabelVolume label;
  label.size = { { side, side, side } };
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        label.inside.push_back(isInside({ i, j, k }) ? 1 : 0);
      }
    }
  }
  return label;
}

bool
isInCube(const Eigen::Vector3i & v, int lower, int upper)
{
  return v.minCoeff() >= lower && v.maxCoeff() <= upper;
}

/** A cube with a blind hole of 2 x 2 x 17 voxels. */
LabelVolume
cubeWithBlindHole()
{
  return cubicLabel([](const Eigen::Vector3i & v) {
    const bool inHole = v[0] >= 15 && v[0] <= 16 && v[1] >= 15 && v[1] <= 16 && v[2] < 20;
    return isInCube(v, 3, 28) && !inHole;
  });
}

/** Two cubes joined by a row of single voxels. */
LabelVolume
dumbbell()
{
  return cubicLabel([](const Eigen::Vector3i & v) {
    const bool inNeck = v[1] == 8 && v[2] == 8 && v[0] >= 3 && v[0] <= 28;
    return isInCube(v - Eigen::Vector3i(0, 3, 3), 2, 10) || isInCube(v - Eigen::Vector3i(19, 3, 3), 2, 10) || inNeck;
  });
}

/** A ball of radius 26 voxels with three oblique slits, 3 voxels wide and 12 deep, which no frame of the cube follows.
 */
LabelVolume
ballWithDeepSlits()
{
  struct Slit
  {
    Vector3 inward;
    Vector3 across;
  };
  std::vector<Slit> slits;
  for (const auto & [outward, along] : { std::pair(Vector3(1.0, 0.2, 0.1), Vector3(0.0, 1.0, 0.1)),
                                         std::pair(Vector3(-0.6, 0.9, 0.2), Vector3(0.0, 0.0, 1.0)),
                                         std::pair(Vector3(-0.5, -0.8, 0.3), Vector3(0.0, 1.0, 0.1)) })
  {
    slits.push_back({ -outward.normalized(), outward.cross(along).normalized() });
  }
  return cubicLabel(
    [slits](const Eigen::Vector3i & v) {
      const Vector3 p = v.cast<double>() - Vector3::Constant(31.5);
      return p.norm() <= 26.0 && std::none_of(slits.begin(), slits.end(), [&p](const Slit & slit) {
               return slit.inward.dot(p) < -14.0 && std::abs(slit.across.dot(p)) <= 1.5;
             });
    },
    64);
}

Pipeline::Pointer
exactMeshOf(const LabelVolume & label)
{
  PipelineOptions options;
  options.lastStage = MeshingStage::Exact;
  return runPipeline(labelImage(label), options);
}

} // namespace

TEST(HardShapes, AHoleNarrowerThanTheCellsIsSmoothedAwayInTheLabelsOwnFrame)
{
  const Pipeline::Pointer    pipeline = exactMeshOf(cubeWithBlindHole());
  const SolidMeshingResult & result = pipeline->GetResult();
  ASSERT_TRUE(result.simplerSolid.has_value());
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_TRUE(result.turnWarning.empty()) << result.turnWarning;
  EXPECT_LE(result.boundary.maximum, 0.5);
  EXPECT_GE(pipeline->GetConditioningReport().dice, 0.98);
  EXPECT_NEAR(qualityAfter(*pipeline, "exact").volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
  EXPECT_NE(pipeline->GetStages().front().note.find("details are narrower than cells"), std::string::npos);
  EXPECT_EQ(result.attempts, (std::vector<std::string>{ "own frame: not exact", "smoother solid: exact" }));
  EXPECT_NE(pipeline->GetStages().back().note.find("own frame: not exact; smoother solid: exact"), std::string::npos);
}

TEST(HardShapes, SlitsThatNoFrameFollowsAreFilledInARounderSolidAsTheLastResort)
{
  const Pipeline::Pointer    pipeline = exactMeshOf(ballWithDeepSlits());
  const SolidMeshingResult & result = pipeline->GetResult();
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_EQ(
    result.attempts,
    (std::vector<std::string>{
      "own frame: not exact", "smoother solid: not exact", "turned frames: not exact", "rounder solid: exact" }));
  EXPECT_GT(pipeline->GetConditioningReport().rounding, 0.0);
  EXPECT_GE(pipeline->GetConditioningReport().dice, 0.95); // what a rounder solid keeps
  EXPECT_LE(result.boundary.maximum, 0.5);
  EXPECT_NEAR(qualityAfter(*pipeline, "exact").volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
}

TEST(HardShapes, ASolidThatIsExactAsItIsIsNotSmoothedMore)
{
  const Pipeline::Pointer pipeline =
    exactMeshOf(cubicLabel([](const Eigen::Vector3i & v) { return isInCube(v, 3, 28); }));
  EXPECT_FALSE(pipeline->GetResult().simplerSolid.has_value());
  EXPECT_EQ(pipeline->GetStages().front().note, "");
  EXPECT_EQ(pipeline->GetResult().attempts, std::vector<std::string>{ "own frame: exact" });
}

TEST(HardShapes, ALesionOnOneSliceIsMeshed)
{
  LabelVolume label = cubicLabel([](const Eigen::Vector3i & v) {
    const double x = (v[0] - 16) / 6.0;
    const double y = (v[1] - 16) / 5.0;
    return v[2] == 16 && x * x + y * y <= 1.0;
  });
  label.spacing = { 0.5, 0.5, 3.0 };
  const Pipeline::Pointer pipeline = exactMeshOf(label);
  EXPECT_TRUE(pipeline->GetResult().equalisation->exact);
  EXPECT_GE(pipeline->GetConditioningReport().dice, 0.8);
  EXPECT_NEAR(qualityAfter(*pipeline, "exact").volume / pipeline->GetLabelVolume(), 1.0, 1e-9);
}

TEST(HardShapes, ADumbbellWithANeckOfOneVoxelIsRefusedWithTheNumbersOfACoarseLattice)
{
  try
  {
    exactMeshOf(dumbbell());
    FAIL() << "a mesh of a dumbbell";
  }
  catch (const itk::NotConvergedError & error)
  {
    EXPECT_EQ(error.GetCode(), ErrorCode::Shape) << error.GetDescription();
    EXPECT_NE(std::string(error.GetDescription()).find("of a coarse one are not positive"), std::string::npos);
  }
}
