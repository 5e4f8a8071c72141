// Ellipsoids, one tied to the mesh of another. Exact: what is promised of every mesh, refusals, threads; distances of
// corresponding nodes: bounds above what was measured.
#include "OrderedEllipsoid.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>

using namespace moserhex;

namespace
{

const Vector3 semiAxes(15.0, 12.0, 10.0);

const HexMesh &
templateMesh()
{
  static const HexMesh mesh = [] {
    const OrderedSolid solid = ellipsoid(semiAxes, 0.75);
    return meshSolid(solid.ordering, solid.phi, solid.volume, withShells(5)).mesh;
  }();
  return mesh;
}

SolidMeshingOptions
tiedTo(HexMesh mesh, TemplateAlignment alignment = TemplateAlignment::Rigid)
{
  SolidMeshingOptions options = withShells(5);
  options.templateMesh = std::move(mesh);
  options.templateAlignment = alignment;
  return options;
}

SolidMeshingResult
meshed(const Vector3 & axes, const SolidMeshingOptions & options)
{
  const OrderedSolid solid = ellipsoid(axes, 0.75);
  return meshOnTemplate(solid.phi, solid.volume, options);
}

double
medianDistance(const Positions & a, const Positions & b)
{
  std::vector<double> distances;
  for (std::size_t node = 0; node < a.size(); ++node)
  {
    distances.push_back((a[node] - b[node]).norm());
  }
  std::nth_element(
    distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2), distances.end());
  return distances[distances.size() / 2];
}

double
edgeOfCell(const Vector3 & axes)
{
  return std::cbrt(4.0 / 3.0 * pi * axes.prod() / 729.0);
}

} // namespace

TEST(MeshOnTemplate, ASolidOfTheSameShapeKeepsTheTemplatesNodes)
{
  const SolidMeshingResult result = meshed(semiAxes, tiedTo(templateMesh(), TemplateAlignment::None));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LT(medianDistance(result.mesh.nodes, templateMesh().nodes), 1e-6);
  ASSERT_EQ(result.stages.size(), 2u);
  EXPECT_EQ(result.stages[0].name, "template");
  EXPECT_FALSE(result.alignment);
}

TEST(MeshOnTemplate, AStretchedSolidHasTheStretchedNodes)
{
  const Vector3            stretched(16.5, 11.4, 10.5);
  const SolidMeshingResult result = meshed(stretched, tiedTo(templateMesh(), TemplateAlignment::None));
  ASSERT_TRUE(result.equalisation->exact);
  EXPECT_LE(result.equalisation->variance, 1e-18);
  Positions expected = templateMesh().nodes;
  for (Vector3 & node : expected)
  {
    node = node.cwiseProduct(stretched.cwiseQuotient(semiAxes));
  }
  EXPECT_LT(medianDistance(result.mesh.nodes, expected), 0.1 * edgeOfCell(stretched));
}

TEST(MeshOnTemplate, AMovedTemplateIsBroughtBack)
{
  HexMesh       moved = templateMesh();
  const Matrix3 turn = Eigen::AngleAxis<double>(0.25, Vector3(1, 1, 2).normalized()).toRotationMatrix();
  for (Vector3 & node : moved.nodes)
  {
    node = turn * node + Vector3(5.0, -3.0, 60.0);
  }
  const SolidMeshingResult result = meshed(semiAxes, tiedTo(moved));
  EXPECT_TRUE(result.equalisation->exact);
  ASSERT_TRUE(result.alignment);
  EXPECT_NEAR(result.alignment->motion.angle(), 0.25 * 180.0 / pi, 0.5);
  EXPECT_LT(medianDistance(result.mesh.nodes, templateMesh().nodes), 0.1 * edgeOfCell(semiAxes));
}

TEST(MeshOnTemplate, ASmallTemplateIsNotLaidAgainstASideOfTheSolid)
{
  HexMesh       small = templateMesh();
  const Matrix3 turn = Eigen::AngleAxis<double>(0.15, Vector3(1, 2, 1).normalized()).toRotationMatrix();
  for (Vector3 & node : small.nodes)
  {
    node = 0.55 * (turn * node) + Vector3(6.0, 2.0, 0.0);
  }
  const SolidMeshingResult result = meshed(semiAxes, tiedTo(small));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LT(medianDistance(result.mesh.nodes, templateMesh().nodes), 0.1 * edgeOfCell(semiAxes));
}

TEST(MeshOnTemplate, DoesNotDependOnThreads)
{
  SolidMeshingOptions one = tiedTo(templateMesh());
  one.threads = 1;
  SolidMeshingOptions three = one;
  three.threads = 3;
  const Vector3 other(14.0, 13.0, 10.0);
  EXPECT_EQ(meshed(other, one).mesh.nodes, meshed(other, three).mesh.nodes);
}

TEST(MeshOnTemplate, RefusesWhatItCannotTie)
{
  const auto expectRefused = [](const SolidMeshingOptions & options) {
    EXPECT_THROW((void)meshed(semiAxes, options), InvalidInput);
  };
  expectRefused(withShells(5)); // no template
  SolidMeshingOptions options = tiedTo(templateMesh());
  options.shells = 6;
  expectRefused(options);
  options = tiedTo(templateMesh());
  options.paddingLayers = 1;
  expectRefused(options);
  options = tiedTo(templateMesh());
  options.lastStage = MeshingStage::Moser;
  expectRefused(options);
  HexMesh mesh = templateMesh();
  mesh.nodes.pop_back();
  expectRefused(tiedTo(mesh));
}
