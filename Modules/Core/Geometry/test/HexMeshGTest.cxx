// Round-off class (1e-12 relative): the volume is a polynomial of the corners and every check has a closed form.
#include "moserhex/Geometry/HexMesh.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>
#include <string>

using namespace moserhex;

namespace
{

/** Over [0,1]^3. */
HexMesh
unitLattice(int n)
{
  return analytic::lattice(n, [n](const Vector3 & index) { return Vector3(index / (n - 1)); });
}

HexCorners
perturbedCube(std::uint64_t seed, double amplitude)
{
  HexCorners x = cellCorners(unitLattice(2), 0);
  Random     random(seed);
  for (Vector3 & p : x)
  {
    p += amplitude * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  }
  return x;
}

Vector3
trilinear(const HexCorners & x, double u, double v, double w)
{
  const Vector3 bottom = (1 - v) * ((1 - u) * x[0] + u * x[1]) + v * ((1 - u) * x[3] + u * x[2]);
  const Vector3 top = (1 - v) * ((1 - u) * x[4] + u * x[5]) + v * ((1 - u) * x[7] + u * x[6]);
  return (1 - w) * bottom + w * top;
}

} // namespace

TEST(HexVolume, IsTheDeterminantForAParallelepiped)
{
  Matrix3 map;
  map << 2, 0.3, -0.1, 0.2, 1.5, 0.4, 0, -0.2, 3;
  HexCorners x = cellCorners(unitLattice(2), 0);
  for (Vector3 & p : x)
  {
    p = map * p + Vector3(5, 6, 7);
  }
  EXPECT_NEAR(hexVolume(x), map.determinant(), 1e-12);
  for (const double jacobian : cornerJacobians(x))
  {
    EXPECT_NEAR(jacobian, map.determinant(), 1e-12);
  }
}

TEST(HexVolume, IsNegativeForAnInvertedCube)
{
  HexCorners x = cellCorners(unitLattice(2), 0);
  for (int c = 0; c < 4; ++c)
  {
    std::swap(x[c], x[c + 4]);
  }
  EXPECT_NEAR(hexVolume(x), -1.0, 1e-12);
}

TEST(HexVolume, EqualsTheSumOfItsEightTrilinearParts)
{
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const HexCorners x = perturbedCube(seed, 0.3);
    double           sum = 0.0;
    for (int part = 0; part < 8; ++part)
    {
      const double     u = 0.5 * (part & 1), v = 0.5 * (part >> 1 & 1), w = 0.5 * (part >> 2);
      HexCorners       y;
      const HexCorners unit = cellCorners(unitLattice(2), 0);
      for (int c = 0; c < 8; ++c)
      {
        y[c] = trilinear(x, u + 0.5 * unit[c][0], v + 0.5 * unit[c][1], w + 0.5 * unit[c][2]);
      }
      sum += hexVolume(y);
    }
    EXPECT_NEAR(sum, hexVolume(x), 1e-12) << "seed " << seed;
  }
}

TEST(HexVolume, OfALatticeAddsUpToTheVolumeItsBoundaryEncloses)
{
  // Interior nodes move, boundary nodes stay: the sum over cells is the cube's volume whatever the interior does.
  HexMesh mesh = unitLattice(6);
  Random  random(3);
  for (int k = 1; k < 5; ++k)
  {
    for (int j = 1; j < 5; ++j)
    {
      for (int i = 1; i < 5; ++i)
      {
        mesh.nodes[mesh.nodeNumber(i, j, k)] +=
          0.3 * Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      }
    }
  }
  double sum = 0.0;
  for (const double volume : cellVolumes(mesh))
  {
    sum += volume;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(HexMesh, CellNodesFollowTheLatticeOrder)
{
  const HexMesh mesh = unitLattice(4);
  ASSERT_EQ(mesh.cellCount(), 27u);
  const std::array<std::size_t, 8> expected{ 42, 43, 47, 46, 58, 59, 63, 62 };
  EXPECT_EQ(mesh.cellNodes(26), expected);
  EXPECT_EQ(mesh.cellNodes(0)[6], mesh.nodeNumber(1, 1, 1));
}

TEST(HexMesh, LatticeOfAnotherNumberOfNodesIsRefused)
{
  EXPECT_NO_THROW(requireValid(unitLattice(2)));
  HexMesh mesh = unitLattice(3);
  mesh.nodes.pop_back();
  EXPECT_THROW(requireValid(mesh), InvalidInput);
  EXPECT_THROW(requireValid(HexMesh{ 1, { Vector3::Zero() } }), InvalidInput);
  EXPECT_THROW(requireValid(HexMesh{ -2, unitLattice(2).nodes }), InvalidInput);
}

TEST(HexMesh, NodeThatIsNotFiniteIsRefusedByItsNumber)
{
  for (const double value : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    HexMesh mesh = unitLattice(3);
    mesh.nodes[17].y() = value;
    const std::string message = analytic::messageOf([&] { requireValid(mesh); });
    EXPECT_NE(message.find("node 17 "), std::string::npos) << message;
  }
}
