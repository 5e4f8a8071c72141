// The mesh belongs to the organ, not to its voxels. Two samplings of one solid differ by a fraction of a voxel, and
// smoothing decides for whole nodes at the cube's edges, so meshes are compared against lengths of the problem: a voxel
// (1 mm) for the same samples in another order, half a cell (1.35 mm) for rotated samples, a slice for thick slices.
#include "PipelineRun.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

/** Root mean square and largest distance between nodes of equal lattice index. */
struct NodeDistance
{
  double rms{ 0.0 };
  double maximum{ 0.0 };
};

NodeDistance
nodeDistance(const HexMesh & a, const HexMesh & b)
{
  NodeDistance distance;
  for (std::size_t node = 0; node < a.nodes.size(); ++node)
  {
    const double squared = (a.nodes[node] - b.nodes[node]).squaredNorm();
    distance.rms += squared;
    distance.maximum = std::max(distance.maximum, std::sqrt(squared));
  }
  distance.rms = std::sqrt(distance.rms / static_cast<double>(a.nodes.size()));
  return distance;
}

/** A solid without symmetry, so that the frame is well defined. */
analytic::Solid
unevenEllipsoid()
{
  return analytic::ellipsoid({ 24.0, 18.0, 14.0 });
}

HexMesh
meshOf(const analytic::GridPlacement & placement)
{
  PipelineOptions options;
  options.shells = 6;
  return runPipeline(labelImage(analytic::labelVolume(unevenEllipsoid(), placement)), options)->GetHexMesh();
}

} // namespace

TEST(PhysicalSpace, AnotherOrderOfTheImageAxesGivesTheSameMesh)
{
  analytic::GridPlacement permuted;
  permuted.direction << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const NodeDistance distance = nodeDistance(meshOf({}), meshOf(permuted));
  EXPECT_LE(distance.rms, 0.3);
  EXPECT_LE(distance.maximum, 1.0);
}

TEST(PhysicalSpace, ALeftHandedImageGivesTheSameMesh)
{
  analytic::GridPlacement mirrored;
  mirrored.direction << -1, 0, 0, 0, 1, 0, 0, 0, 1;
  const NodeDistance distance = nodeDistance(meshOf({}), meshOf(mirrored));
  EXPECT_LE(distance.rms, 0.3);
  EXPECT_LE(distance.maximum, 1.0);
}

TEST(PhysicalSpace, ObliqueVoxelsGiveTheSameMesh)
{
  analytic::GridPlacement oblique;
  oblique.direction = analytic::obliqueDirection();
  const NodeDistance distance = nodeDistance(meshOf({}), meshOf(oblique));
  EXPECT_LE(distance.rms, 0.3);
  EXPECT_LE(distance.maximum, 1.35);
}

TEST(PhysicalSpace, ThickObliqueSlicesGiveTheSameMeshWithinASlice)
{
  analytic::GridPlacement thick;
  thick.spacing = { 0.5, 0.5, 3.0 };
  thick.direction = analytic::obliqueDirection();
  thick.margin = 7.0;
  const NodeDistance distance = nodeDistance(meshOf({}), meshOf(thick));
  EXPECT_LE(distance.rms, 0.5);
  EXPECT_LE(distance.maximum, 3.0);
}

TEST(PhysicalSpace, LatticeAxesGrowTowardsLeftPosteriorSuperior)
{
  analytic::GridPlacement oblique;
  oblique.direction = analytic::obliqueDirection();
  const HexMesh mesh = meshOf(oblique);
  const int     n = mesh.nodesPerSide;
  const auto    faceCentre = [&](int axis, int side) {
    Vector3 sum = Vector3::Zero();
    for (int a = 0; a < n; ++a)
    {
      for (int b = 0; b < n; ++b)
      {
        int index[3];
        index[axis] = side;
        index[(axis + 1) % 3] = a;
        index[(axis + 2) % 3] = b;
        sum += mesh.nodes[mesh.nodeNumber(index[0], index[1], index[2])];
      }
    }
    return Vector3(sum / (n * n));
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 direction = (faceCentre(axis, n - 1) - faceCentre(axis, 0)).normalized();
    EXPECT_GT(direction[axis], 0.95) << "axis " << axis;
  }
}
