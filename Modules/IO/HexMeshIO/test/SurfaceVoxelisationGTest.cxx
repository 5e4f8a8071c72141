// Exact: inside or outside of voxels that lie clear of the surface, and of box faces by the half-open rule. The volume
// of the voxels of a smooth body differs from its volume by much less than surface x voxel size: 2e-3 at 100^3.
#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"

#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

double
volumeOf(const LabelVolume & label)
{
  return static_cast<double>(voxelCount(label)) * label.voxelVolume();
}

/** Voxels whose centre is inside by `function` < -band but not by the grid, or outside by > band but not by the grid.
 */
template <typename TFunction>
std::size_t
wrongVoxels(const LabelVolume & label, double band, const TFunction & function)
{
  std::size_t wrong = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        const double value = function(label.point(i, j, k));
        const bool   inside = label.inside[label.voxelNumber(i, j, k)] != 0;
        wrong += (value < -band && !inside) || (value > band && inside) ? 1 : 0;
      }
    }
  }
  return wrong;
}

} // namespace

TEST(Voxelise, GridHoldsAboutAMillionVoxelsAroundTheBox)
{
  const LabelVolume label = voxelise(icosphere(3, 20.0));
  const double      voxelsInBox = 64000.0 / label.voxelVolume();
  EXPECT_NEAR(voxelsInBox, 1e6, 0.02e6);
  EXPECT_EQ(label.spacing.x(), label.spacing.y());
  EXPECT_EQ(label.spacing.x(), label.spacing.z());
}

TEST(Voxelise, BallFillsItsVolume)
{
  const TriangleMesh mesh = icosphere(4, 20.0);
  EXPECT_LT(relativeError(volumeOf(voxelise(mesh)), enclosedVolume(mesh)), 2e-3);
}

TEST(Voxelise, EveryVoxelOfATorusIsOnTheRightSide)
{
  const TriangleMesh mesh = torusSurface(96, 48, 20.0, 7.0);
  const LabelVolume  label = voxelise(mesh, { 0.5 });
  const auto distance = [](const Vector3 & p) { return std::hypot(std::hypot(p.x(), p.y()) - 20.0, p.z()) - 7.0; };
  EXPECT_EQ(wrongVoxels(label, 0.1, distance), 0u);
}

TEST(Voxelise, RaysThroughVerticesAndEdgesAreCountedOnce)
{
  // The cube's vertices, edges and diagonals lie exactly on grid lines.
  const TriangleMesh mesh = cubeSurface(8, 8.0);
  const LabelVolume  label = voxelise(mesh, { 0.5 });
  EXPECT_NEAR(label.origin.x() / 0.5, std::round(label.origin.x() / 0.5), 1e-12);
  const auto distance = [](const Vector3 & p) { return p.cwiseAbs().maxCoeff() - 4.0; };
  EXPECT_EQ(wrongVoxels(label, 1e-9, distance), 0u);
  // Half-open: of the two layers of voxels on opposite faces exactly one is in.
  EXPECT_EQ(voxelCount(label), 16u * 16u * 16u);
}

TEST(Voxelise, VertexOnAGridLineIsCountedOnce)
{
  // An octahedron with its tips on grid lines along all axes.
  TriangleMesh mesh;
  mesh.vertices = { { 4, 0, 0 }, { -4, 0, 0 }, { 0, 4, 0 }, { 0, -4, 0 }, { 0, 0, 4 }, { 0, 0, -4 } };
  mesh.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
                     { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  const LabelVolume label = voxelise(mesh, { 0.5 });
  const auto        norm = [](const Vector3 & p) { return p.cwiseAbs().sum() - 4.0; };
  EXPECT_EQ(wrongVoxels(label, 1e-9, norm), 0u);
}

TEST(Voxelise, SliversAndTinyTrianglesLeakNowhere)
{
  // Random points pull the vertices of a fine sphere around by a millionth of its radius: every kind of near-degenerate
  // crossing; a leak would fill or empty whole lines.
  Random       random(11);
  TriangleMesh mesh = icosphere(5, 10.0);
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex.z() = std::round(vertex.z() * 4.0) / 4.0 + (random.uniform() < 0.5 ? 0.0 : 1e-12);
  }
  const LabelVolume label = voxelise(mesh, { 0.25 });
  EXPECT_EQ(wrongVoxels(label, 0.5, [](const Vector3 & p) { return p.norm() - 10.0; }), 0u);
}

TEST(Voxelise, BorderOfTheGridIsEmpty)
{
  const LabelVolume label = voxelise(cubeSurface(1, 10.0), { 1.0 });
  std::size_t       onBorder = 0;
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      onBorder += label.inside[label.voxelNumber(0, j, k)] + label.inside[label.voxelNumber(label.size[0] - 1, j, k)];
    }
  }
  EXPECT_EQ(onBorder, 0u);
}

TEST(Voxelise, DoesNotDependOnTheOrderOfTrianglesAndVertices)
{
  const TriangleMesh mesh = ellipsoidSurface(3, Vector3(9, 7, 5));
  EXPECT_EQ(voxelise(mesh).inside, voxelise(renumbered(mesh, 3)).inside);
}

TEST(Voxelise, EmptySurfaceIsRefused)
{
  EXPECT_THROW((void)voxelise({}), InvalidInput);
}

TEST(Voxelise, BadSpacingIsRefused)
{
  EXPECT_THROW((void)voxelise(icosphere(1), { -1.0 }), InvalidInput);
}

TEST(Voxelise, GridThatIsTooLargeIsRefused)
{
  EXPECT_THROW((void)voxelise(icosphere(1, 100.0), { 0.01 }), InvalidInput);
}
