// Equal volumes to 1e-9 (variance 1e-18), as the header promises; volumes against those enclosed, to 1e-9.
#include "moserhex/ShapeStatistics/ModeMesh.h"

#include "TestShapes.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{

const ModeMeshOptions oneThread{ ModeMeshOptions{}.deviations, 1 };

template <typename TFunction>
Positions
displacements(const HexMesh & mesh, const TFunction & f)
{
  Positions result;
  for (const Vector3 & node : mesh.nodes)
  {
    result.push_back(f(node));
  }
  return result;
}

/** The last planes of a cube of side 7 are pushed inwards, by `part` of the side at one deviation. */
Positions
pushedIn(const HexMesh & cube, double part)
{
  return displacements(cube,
                       [part](const Vector3 & p) { return Vector3(-7.0 * part * std::pow(p[0] / 7.0, 4), 0.0, 0.0); });
}

} // namespace

TEST(ModeMesh, ThreeDeviationsBecomeAnExactMeshOfTheDisplacedOutline)
{
  const HexMesh mean = softCube(8);
  const auto    bend =
    displacements(mean, [](const Vector3 & p) { return Vector3(0.03 * p[0], 0.0, 0.002 * p[0] * p[0]); });
  const ModeMesh made = exactModeMesh(mean, bend, oneThread);
  ASSERT_EQ(made.deviations, 3.0);
  EXPECT_TRUE(made.attempts.empty());
  EXPECT_TRUE(made.shape.exact);
  EXPECT_LT(made.shape.varianceAfter, 1e-18);
  EXPECT_EQ(made.shape.certified.positive, 343u);
  HexMesh displaced = mean;
  for (std::size_t node = 0; node < displaced.nodes.size(); ++node)
  {
    displaced.nodes[node] += 3.0 * bend[node];
  }
  const auto   volumes = cellVolumes(displaced);
  const double enclosed = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  EXPECT_NEAR(made.shape.volume, enclosed, 1e-9 * enclosed);
  EXPECT_LE(made.shape.boundaryDistance, 0.5);
}

TEST(ModeMesh, ASurfaceThatCutsItselfIsShownByLess)
{
  const HexMesh  cube = analytic::cubeLattice(8); // [0,7]^3
  const ModeMesh made = exactModeMesh(cube, pushedIn(cube, 0.2), oneThread);
  // At 2 the last plane lies before the one next to it, at 1.5 behind it.
  ASSERT_EQ(made.deviations, 1.5);
  EXPECT_EQ(made.attempts,
            (std::vector<std::string>{ "3 standard deviations: the surface cuts itself",
                                       "2.5 standard deviations: the surface cuts itself",
                                       "2 standard deviations: the surface cuts itself" }));
  EXPECT_TRUE(made.shape.exact);
  EXPECT_NEAR(made.shape.volume, 49.0 * 7.0 * 0.7, 1e-9);
}

TEST(ModeMesh, WhereNoNumberOfDeviationsIsAShapeThereIsNone)
{
  const HexMesh  cube = analytic::cubeLattice(8);
  const ModeMesh made = exactModeMesh(cube, pushedIn(cube, 0.6), oneThread);
  EXPECT_EQ(made.deviations, 0.0);
  EXPECT_EQ(made.attempts.size(), 5u);
  EXPECT_TRUE(made.shape.mesh.nodes.empty());
}

TEST(ModeMesh, AShapeTurnedInsideOutIsNone)
{
  const HexMesh  mean = softCube(6);
  const auto     flip = displacements(mean, [](const Vector3 & p) { return Vector3(-0.8 * p[0], 0.0, 0.0); });
  const ModeMesh made = exactModeMesh(mean, flip, { { 3.0, 1.0 }, 1 });
  ASSERT_EQ(made.attempts.size(), 1u);
  EXPECT_EQ(made.deviations, 1.0);
}

TEST(ModeMesh, Refusals)
{
  const HexMesh cube = analytic::cubeLattice(4);
  EXPECT_EQ(analytic::messageOf([&] { (void)exactModeMesh(cube, Positions(5)); }),
            "mode mesh: 5 displacements for 64 nodes, need as many, and at least 3 nodes a side");
  EXPECT_EQ(analytic::messageOf([&] {
              (void)exactModeMesh(cube, Positions(64, Vector3::Zero()), { { 0.0 }, 1 });
            }),
            "mode mesh: a number of deviations is not positive");
}
