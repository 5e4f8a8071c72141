// Concentric shells whose sphere map is known: nodes lie on chords of the triangulation, error O(edge^2), and with the
// projection exactly on the shells (1e-12). Volumes: the cube-to-ball map keeps volumes in the continuum.
#include "moserhex/HexMap/InitialMap.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

struct Organ
{
  std::vector<TriangleMesh> shells;
  std::vector<Positions>    maps;
};

/** Ellipsoid with homothetic shells; the map to the sphere is the affine one. */
Organ
ellipsoid(int shells, const Vector3 & semiAxes, int level)
{
  const CubeLattice lattice(shells);
  Organ             organ;
  for (int k = 1; k <= shells; ++k)
  {
    organ.shells.push_back(analytic::ellipsoidSurface(level, lattice.relativeSize(k) * semiAxes));
    organ.maps.push_back(analytic::icosphere(level).vertices);
  }
  return organ;
}
} // namespace

TEST(InitialMap, NodesOfABallLieWhereTheClosedFormPutsThem)
{
  const int         shells = 4;
  const CubeLattice lattice(shells);
  const Organ       organ = ellipsoid(shells, Vector3::Constant(10.0), 4);
  const HexMesh     mesh = initialMap(organ.shells, organ.maps);
  ASSERT_EQ(mesh.nodesPerSide, 8);
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    const double  radius = 10.0 * lattice.relativeSize(lattice.shellOfNode(node));
    const Vector3 expected = radius * cubeToSphere(lattice.positionOnShell(node));
    EXPECT_LT((mesh.nodes[node] - expected).norm(), 2e-3 * radius);
    EXPECT_LT(mesh.nodes[node].norm(), radius + 1e-12); // chords lie inside
  }
}

TEST(InitialMap, AProjectionPutsNodesOnTheExactShells)
{
  const int         shells = 3;
  const CubeLattice lattice(shells);
  const Organ       organ = ellipsoid(shells, Vector3::Constant(10.0), 2);
  InitialMapOptions options;
  options.projection = [&](int shell, const Vector3 & p) {
    return Vector3(10.0 * lattice.relativeSize(shell) * p.normalized());
  };
  const HexMesh mesh = initialMap(organ.shells, organ.maps, options);
  for (std::size_t node = 0; node < lattice.nodeCount(); ++node)
  {
    EXPECT_NEAR(mesh.nodes[node].norm(), 10.0 * lattice.relativeSize(lattice.shellOfNode(node)), 1e-12);
  }
}

TEST(InitialMap, AnAffineEllipsoidHasNearlyEqualVolumes)
{
  const Organ             organ = ellipsoid(10, Vector3(30, 10, 10), 5);
  const HexQualitySummary quality = summarizeQuality(initialMap(organ.shells, organ.maps));
  EXPECT_LT(quality.volumeVariance, 0.01);
  EXPECT_GT(quality.ratioMin, 0.3);
  EXPECT_NEAR(quality.volume, 4.0 / 3.0 * pi * 3000.0, 0.02 * 4.0 / 3.0 * pi * 3000.0);
}

TEST(InitialMap, IndicesGrowTowardsPlusXYZ)
{
  const Organ   organ = ellipsoid(2, Vector3(3, 2, 1), 3);
  const HexMesh mesh = initialMap(organ.shells, organ.maps);
  EXPECT_GT(mesh.nodes[mesh.nodeNumber(3, 1, 1)][0], mesh.nodes[mesh.nodeNumber(0, 1, 1)][0]);
  EXPECT_GT(mesh.nodes[mesh.nodeNumber(1, 3, 1)][1], mesh.nodes[mesh.nodeNumber(1, 0, 1)][1]);
  EXPECT_GT(mesh.nodes[mesh.nodeNumber(1, 1, 3)][2], mesh.nodes[mesh.nodeNumber(1, 1, 0)][2]);
}

TEST(InitialMap, AnyNumberOfThreadsGivesTheSameBits)
{
  const Organ       organ = ellipsoid(5, Vector3(3, 2, 1), 3);
  InitialMapOptions one;
  one.threads = 1;
  InitialMapOptions three;
  three.threads = 3;
  const HexMesh first = initialMap(organ.shells, organ.maps, one);
  const HexMesh second = initialMap(organ.shells, organ.maps, three);
  for (std::size_t node = 0; node < first.nodes.size(); ++node)
  {
    EXPECT_EQ(first.nodes[node], second.nodes[node]);
  }
}

TEST(InitialMap, NoShellsAreRefused)
{
  EXPECT_THROW(static_cast<void>(initialMap({}, {})), InvalidInput);
}

TEST(InitialMap, AMapOfAnotherSizeIsRefused)
{
  Organ organ = ellipsoid(2, Vector3(1, 1, 1), 1);
  organ.maps[1].pop_back();
  EXPECT_THROW(static_cast<void>(initialMap(organ.shells, organ.maps)), InvalidInput);
  organ.maps.pop_back();
  EXPECT_THROW(static_cast<void>(initialMap(organ.shells, organ.maps)), InvalidInput);
}

TEST(InitialMap, TheCallerCanStopIt)
{
  const Organ organ = ellipsoid(2, Vector3(1, 1, 1), 1);
  EXPECT_THROW(static_cast<void>(initialMap(organ.shells, organ.maps, {}, [](double) { return false; })), Cancelled);
}
