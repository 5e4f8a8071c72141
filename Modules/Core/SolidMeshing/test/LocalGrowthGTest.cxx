// An organ of unchanged outline in which a ball has doubled its volume, seen in an image of each visit. Exact: what is
// promised of every mesh. Growth: closed form for the ball and its surroundings; bounds above what was measured.
#include "OrderedEllipsoid.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Random.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace moserhex;

namespace
{

constexpr int    shells = 6;
constexpr double radiusBefore = 5.0;
const double     radiusAfter = radiusBefore * std::cbrt(2.0);
const Vector3    middle(2.0, -1.0, 3.0);

const OrderedSolid &
organ()
{
  static const OrderedSolid solid = ellipsoid(Vector3(14.0, 13.0, 16.0), 0.75);
  return solid;
}

const HexMesh &
baseline()
{
  static const HexMesh mesh = meshSolid(organ().ordering, organ().phi, organ().volume, withShells(shells)).mesh;
  return mesh;
}

/** Bright ball in a dark organ, with an edge of half a millimetre. \param noise  uniform, over the ball's contrast */
ScalarVolume
imageOfBall(double radius, double gain, double noise = 0.0)
{
  Random       random(static_cast<std::uint64_t>(100.0 * radius));
  ScalarVolume image;
  image.size = { { 43, 43, 49 } };
  image.origin = Vector3(-21.0, -21.0, -24.0);
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        const double inside = radius - (image.point(i, j, k) - middle).norm();
        const double shown = 0.5 * (1.0 + std::tanh(2.0 * inside)) + noise * (random.uniform() - 0.5);
        image.values.push_back(100.0 + gain * shown);
      }
    }
  }
  return image;
}

SolidMeshingOptions
tied(bool localGrowth, double radius = radiusAfter)
{
  SolidMeshingOptions options = withShells(shells);
  options.templateMesh = baseline();
  options.templateAlignment = TemplateAlignment::None;
  options.refinement.images = CorrespondingImages{ imageOfBall(radiusBefore, 50.0), imageOfBall(radius, 80.0) };
  options.refinement.localGrowth = localGrowth;
  return options;
}

SolidMeshingResult
meshed(const SolidMeshingOptions & options)
{
  return meshOnTemplate(organ().phi, organ().volume, options);
}

/** Mean growth of the cells whose centre at the baseline is nearer to the ball's middle than `to` and not nearer than
 * `from` [mm]. */
double
growthBetween(const HexMesh & followUp, double from, double to)
{
  const std::vector<double> before = cellVolumes(baseline());
  const std::vector<double> after = cellVolumes(followUp);
  double                    volumeBefore = 0.0;
  double                    volumeAfter = 0.0;
  for (std::size_t cell = 0; cell < before.size(); ++cell)
  {
    Vector3 centre = Vector3::Zero();
    for (const Vector3 & corner : cellCorners(baseline(), cell))
    {
      centre += corner / 8.0;
    }
    const double distance = (centre - middle).norm();
    if (distance >= from && distance < to)
    {
      volumeBefore += before[cell];
      volumeAfter += after[cell];
    }
  }
  return volumeAfter / volumeBefore;
}

/** Growth inside of the ball, printed for Documentation/Longitudinal.md. */
double
growthOfBall(const std::string & name, const SolidMeshingResult & result)
{
  const double      growth = growthBetween(result.mesh, 0.0, radiusBefore);
  const LocalGrowth cells = *result.refinement->growth;
  std::cout << name << ": growth of the ball " << growth << ", of its middle " << growthBetween(result.mesh, 0.0, 3.5)
            << ", of all cells " << cells.smallest << " to " << cells.largest << '\n';
  return growth;
}

/** Growth of all but the ball. */
double
around()
{
  const double ball = 4.0 / 3.0 * pi * std::pow(radiusBefore, 3.0);
  return (organ().volume - 2.0 * ball) / (organ().volume - ball);
}

} // namespace

TEST(LocalGrowth, OfABallThatDoublesIsFound)
{
  const SolidMeshingResult result = meshed(tied(true));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LE(result.equalisation->variance, 1e-18);
  EXPECT_EQ(result.equalisation->uncertifiedCells, 0u);
  ASSERT_TRUE(result.refinement && result.refinement->growth);
  EXPECT_TRUE(result.refinement->complete);
  EXPECT_LT(result.refinement->imageDifference->after, 0.3 * result.refinement->imageDifference->before);

  EXPECT_NEAR(growthOfBall("image", result), 2.0, 0.15);
  EXPECT_NEAR(growthBetween(result.mesh, 7.0, 100.0), around(), 0.03);
}

TEST(LocalGrowth, IsNotSeenByEqualCells)
{
  const SolidMeshingResult result = meshed(tied(false));
  EXPECT_FALSE(result.refinement->growth);
  EXPECT_NEAR(growthBetween(result.mesh, 0.0, 3.5), 1.0, 1e-6);
}

TEST(LocalGrowth, IsOneWhereNothingGrew)
{
  const SolidMeshingResult result = meshed(tied(true, radiusBefore));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_NEAR(growthOfBall("nothing grew", result), 1.0, 0.01);
  if (result.refinement->growth) // else the refinement was left out, as it brought nothing nearer
  {
    EXPECT_GT(result.refinement->growth->smallest, 0.94);
    EXPECT_LT(result.refinement->growth->largest, 1.03);
  }
}

TEST(LocalGrowth, WhatBringsNothingNearerIsLeftOut)
{
  SolidMeshingOptions options = tied(true);
  options.refinement.images.reset();
  for (const double x : { -4.0, 1.0, 5.0 })
  {
    const Vector3 place(x, 2.0, -x);
    options.refinement.landmarks.push_back({ place, place }); // where they are already
  }
  const SolidMeshingResult result = meshed(options);
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_FALSE(result.refinement->growth);
  EXPECT_EQ(result.refinement->landmarkError->after, result.refinement->landmarkError->before);
  EXPECT_LE(volumeQuality(result.mesh).volumeVariance, 1e-12);
  EXPECT_NE(std::find_if(result.warnings.begin(),
                         result.warnings.end(),
                         [](const std::string & warning) { return warning.find("was left out") != std::string::npos; }),
            result.warnings.end());
}

TEST(LocalGrowth, ATemplateOfUnevenCellsIsRefused)
{
  HexMesh uneven = baseline();
  for (Vector3 & node : uneven.nodes)
  {
    node += 0.01 * node[0] * node[0] * Vector3::UnitX();
  }
  SolidMeshingOptions options = tied(true, radiusBefore);
  options.templateMesh = uneven;
  EXPECT_EQ(analytic::codeThrownBy([&] { (void)meshed(options); }), ErrorCode::Template);
}

TEST(LocalGrowth, OfWhatHasShrunkIsBelowOne)
{
  SolidMeshingOptions options = tied(true);
  options.refinement.images = CorrespondingImages{ imageOfBall(radiusAfter, 50.0), imageOfBall(radiusBefore, 80.0) };
  const SolidMeshingResult result = meshed(options);
  EXPECT_TRUE(result.equalisation->exact);
  const double ofBall = growthBetween(result.mesh, 0.0, radiusAfter);
  const double ofMiddle = growthBetween(result.mesh, 0.0, 3.5);
  std::cout << "shrunk to a half: growth of the ball " << ofBall << ", of its middle " << ofMiddle << ", of all cells "
            << result.refinement->growth->smallest << " to " << result.refinement->growth->largest << std::endl;
  EXPECT_NEAR(ofBall, 0.5, 0.1);
  EXPECT_NEAR(ofMiddle, 0.5, 0.25);
  EXPECT_LT(result.refinement->growth->largest, 1.5);
}

TEST(LocalGrowth, IsFoundInNoise)
{
  SolidMeshingOptions options = tied(true);
  options.refinement.images =
    CorrespondingImages{ imageOfBall(radiusBefore, 50.0, 0.5), imageOfBall(radiusAfter, 80.0, 0.5) };
  const SolidMeshingResult result = meshed(options);
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_NEAR(growthOfBall("noise", result), 2.0, 0.25);
  EXPECT_NEAR(growthBetween(result.mesh, 7.0, 100.0), around(), 0.04);
}

TEST(LocalGrowth, IsHiddenInPartByOtherContrast)
{
  const auto withTexture = [](double radius, double amplitude) { // unchanged, beyond 9 mm from the ball's middle
    ScalarVolume image = imageOfBall(radius, 50.0);
    for (int k = 0; k < image.size[2]; ++k)
    {
      for (int j = 0; j < image.size[1]; ++j)
      {
        for (int i = 0; i < image.size[0]; ++i)
        {
          const Vector3 p = image.point(i, j, k);
          const double  faded = std::clamp(0.5 * ((p - middle).norm() - 9.0), 0.0, 1.0);
          const double  waves = std::sin(0.8 * p[0]) + std::cos(0.7 * p[1]) + std::sin(0.6 * p[2]);
          image.values[image.voxelNumber(i, j, k)] += amplitude * faded * waves;
        }
      }
    }
    return image;
  };
  for (const double amplitude : { 30.0, 60.0 })
  {
    for (const bool shrinks : { false, true })
    {
      const double        before = shrinks ? radiusAfter : radiusBefore;
      const double        after = shrinks ? radiusBefore : radiusAfter;
      SolidMeshingOptions options = tied(true);
      options.refinement.images = CorrespondingImages{ withTexture(before, amplitude), withTexture(after, amplitude) };
      const SolidMeshingResult result = meshed(options);
      const double             found = growthBetween(result.mesh, 0.0, before);
      std::cout << "waves of " << amplitude << ", contrast of the ball 50, true growth " << (shrinks ? 0.5 : 2.0)
                << ": found " << found << std::endl;
      EXPECT_GT(shrinks ? 1.0 / found : found, 1.35); // the right way, and a good part
      EXPECT_LT(shrinks ? 1.0 / found : found, 2.2);
    }
  }
}

TEST(LocalGrowth, ShowsByLandmarksToo)
{
  SolidMeshingOptions options = tied(true);
  options.refinement.images.reset();
  for (int pole = 0; pole < 14; ++pole) // of the ball: along the axes and the diagonals
  {
    const Vector3 direction =
      pole < 6 ? Vector3(Vector3::Unit(pole / 2) * (pole % 2 == 0 ? 1.0 : -1.0))
               : Vector3(pole & 1 ? 1.0 : -1.0, pole & 2 ? 1.0 : -1.0, pole < 10 ? 1.0 : -1.0).normalized();
    options.refinement.landmarks.push_back({ middle + radiusBefore * direction, middle + radiusAfter * direction });
  }
  const SolidMeshingResult result = meshed(options);
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LT(result.refinement->landmarkError->after, 0.3 * result.refinement->landmarkError->before);
  (void)growthOfBall("landmarks", result);
  EXPECT_NEAR(growthBetween(result.mesh, 0.0, 3.5), 2.0, 0.4); // what lies between landmarks is the springs' guess
}

TEST(LocalGrowth, DoesNotDependOnThreads)
{
  SolidMeshingOptions one = tied(true);
  one.threads = 1;
  SolidMeshingOptions three = one;
  three.threads = 3;
  EXPECT_EQ(meshed(one).mesh.nodes, meshed(three).mesh.nodes);
}

TEST(LocalGrowth, NeedsImagesOrLandmarks)
{
  SolidMeshingOptions options = tied(true);
  options.refinement.images.reset();
  EXPECT_THROW((void)meshed(options), InvalidInput);
}
