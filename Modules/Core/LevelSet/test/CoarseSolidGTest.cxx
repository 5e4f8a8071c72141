// Closed form: the distance to a ball; topology by the Euler characteristic of the node set and of the level sets.
#include "TestShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CoarseSolid.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

constexpr double radius = 0.75;
const double     ballVolume = 4.0 / 3.0 * pi * std::pow(radius, 3);

double
toBall(const Vector3 & p)
{
  return (p - Vector3(0.01, -0.02, 0.015)).norm() - radius;
}

/** Two balls of radius 0.35 and a rod between them. */
double
toDumbbell(const Vector3 & p, double rodRadius)
{
  const double left = (p - Vector3(-0.5, 0.0, 0.0)).norm() - 0.35;
  const double right = (p - Vector3(0.5, 0.0, 0.0)).norm() - 0.35;
  const double along = std::max(0.0, std::abs(p.x()) - 0.5);
  const double rod = std::sqrt(along * along + p.y() * p.y() + p.z() * p.z()) - rodRadius;
  return std::min(rod, std::min(left, right));
}

/** V - E + F of the surface around the nodes below a level. */
long
eulerCharacteristic(const LevelSet & phi, double level)
{
  std::vector<std::uint8_t> below;
  for (const double value : phi.values)
  {
    below.push_back(value < level ? 1 : 0);
  }
  return 2 * kuhnEulerCharacteristic(phi.grid, below);
}

} // namespace

TEST(CoarseSolid, ABallKeepsItsDistanceAndVolume)
{
  const LevelSet    phi = test::sample(test::unitGrid(97), toBall);
  const CoarseSolid coarse = coarseSolid(phi, ballVolume);
  const double      spacing = coarse.levelSet.grid.spacing;
  EXPECT_EQ(coarse.refinements, 0);
  EXPECT_NEAR(spacing, std::cbrt(ballVolume) / 24.0, 1e-12);
  EXPECT_NEAR(VolumeBelowLevel(coarse.levelSet).volume(0.0) / ballVolume, 1.0, 0.01);
  for (std::size_t node = 0; node < coarse.levelSet.values.size(); ++node)
  {
    const double exact = toBall(coarse.levelSet.grid.point(node));
    if (exact > -0.7 && exact < 2.0 * spacing) // without the kink in the middle
    {
      EXPECT_NEAR(coarse.levelSet.values[node], exact, 0.01 * spacing);
    }
  }
}

TEST(CoarseSolid, TheGridDoesNotDependOnTheFineOne)
{
  const CoarseSolid a = coarseSolid(test::sample(test::unitGrid(65), toBall), ballVolume);
  const CoarseSolid b = coarseSolid(test::sample(test::unitGrid(129), toBall), ballVolume);
  EXPECT_EQ(a.levelSet.grid.spacing, b.levelSet.grid.spacing);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(a.levelSet.grid.size[axis], b.levelSet.grid.size[axis], 1);
  }
}

TEST(CoarseSolid, BeyondTheFineGridTheDistanceGoesOn)
{
  LevelSet tight = test::sample(test::unitGrid(97), toBall);
  tight.grid.spacing *= 0.78; // the ball nearly fills the box
  for (std::size_t node = 0; node < tight.values.size(); ++node)
  {
    tight.values[node] = toBall(tight.grid.point(node) + Vector3::Constant(0.22));
  }
  const CoarseSolid coarse = coarseSolid(tight, ballVolume);
  for (std::size_t node = 0; node < coarse.levelSet.values.size(); ++node)
  {
    if (coarse.levelSet.grid.isBorder(node))
    {
      EXPECT_GT(coarse.levelSet.values[node], 2.0 * coarse.levelSet.grid.spacing);
    }
  }
}

TEST(CoarseSolid, ARodThinnerThanTheSpacingRefinesTheGridUntilItHolds)
{
  const LevelSet     phi = test::sample(test::unitGrid(161), [](const Vector3 & p) { return toDumbbell(p, 0.02); });
  const double       volume = VolumeBelowLevel(phi).volume(0.0);
  CoarseSolidOptions options;
  options.nodesPerSide = 12.0;
  options.nodesAcrossThickness = 1.0;
  const CoarseSolid coarse = coarseSolid(phi, volume, options);
  EXPECT_GT(coarse.refinements, 0);
  EXPECT_LT(coarse.levelSet.grid.spacing, 0.04);
  EXPECT_NE(describe(coarse).find("refined"), std::string::npos);
  EXPECT_EQ(eulerCharacteristic(coarse.levelSet, 0.0), 2);
  EXPECT_NEAR(VolumeBelowLevel(coarse.levelSet).volume(0.0) / volume, 1.0, 0.02);
}

TEST(CoarseSolid, LevelsAroundZeroAreSpheres)
{
  for (const double rodRadius : { 0.05, 0.08, 0.12 })
  {
    const LevelSet phi = test::sample(test::unitGrid(129), [&](const Vector3 & p) { return toDumbbell(p, rodRadius); });
    const LevelSet coarse = coarseSolid(phi, VolumeBelowLevel(phi).volume(0.0)).levelSet;
    for (const double level : { -0.4, -0.2, 0.0, 0.2, 0.4 })
    {
      EXPECT_EQ(eulerCharacteristic(coarse, level * coarse.grid.spacing), 2) << rodRadius << " at " << level;
    }
  }
}

TEST(CoarseSolid, ASheetGetsFourNodesAcrossItsThickness)
{
  const double   thickness = 0.12;
  const LevelSet phi = test::sample(test::unitGrid(161), [&](const Vector3 & p) {
    const double beyond = std::max(0.0, std::hypot(p.x(), p.y()) - 0.8);
    return std::hypot(beyond, p.z()) - 0.5 * thickness;
  });
  const LevelSet coarse = coarseSolid(phi, VolumeBelowLevel(phi).volume(0.0)).levelSet;
  EXPECT_LT(coarse.grid.spacing, thickness / 3.5);
  EXPECT_GT(coarse.grid.spacing, thickness / 6.0);
}

TEST(CoarseSolid, AGridThatIsCoarseAlreadyIsReturnedAsItIs)
{
  const LevelSet    phi = test::sample(test::unitGrid(37), toBall);
  const CoarseSolid coarse = coarseSolid(phi, ballVolume);
  EXPECT_EQ(coarse.levelSet.grid.size, phi.grid.size);
  EXPECT_EQ(coarse.levelSet.values, phi.values);
}

TEST(CoarseSolid, WhatIsNotASolidIsRefused)
{
  const LevelSet phi = test::sample(test::unitGrid(21), toBall);
  EXPECT_THROW((void)coarseSolid(phi, 0.0), InvalidInput);
  EXPECT_THROW((void)coarseSolid(test::sample(test::unitGrid(21), [](const Vector3 &) { return 1.0; }), 1.0),
               InvalidInput);
  CoarseSolidOptions options;
  options.refinement = 1.0;
  EXPECT_THROW((void)coarseSolid(phi, ballVolume, options), InvalidInput);
}

TEST(CoarseSolid, NumbersThatAreNotFiniteAreRefused)
{
  const LevelSet phi = test::sample(test::unitGrid(21), toBall);
  for (const double number : { std::numeric_limits<double>::infinity(), std::nan("") })
  {
    EXPECT_THROW((void)coarseSolid(phi, number), InvalidInput) << number;
    for (double CoarseSolidOptions::*const option : { &CoarseSolidOptions::nodesPerSide,
                                                      &CoarseSolidOptions::nodesAcrossThickness,
                                                      &CoarseSolidOptions::refinement,
                                                      &CoarseSolidOptions::acceptedVolumeChange })
    {
      CoarseSolidOptions options;
      options.*option = number;
      EXPECT_THROW((void)coarseSolid(phi, ballVolume, options), InvalidInput) << number;
    }
  }
}

TEST(CoarseSolid, AVolumeThatCannotBeTheSolidsGivesTheLevelSetAsItIs)
{
  const LevelSet phi = test::sample(test::unitGrid(37), toBall);
  for (const double volume : { 1e-300, 1e10, 1e308 })
  {
    EXPECT_EQ(coarseSolid(phi, volume).levelSet.values, phi.values) << volume;
  }
}
