// Ellipsoids, one tied to the mesh of another. Exact: what is promised of every mesh, refusals, threads; distances of
// corresponding nodes: bounds above what was measured.
#include "OrderedEllipsoid.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

using namespace moserhex;

namespace
{

const Vector3 semiAxes(15.0, 12.0, 10.0);

/** 1 + x / 50 mm: 0.7 to 1.3 in the ellipsoid. */
class GrowingDensity : public Density
{
public:
  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const override
  {
    return { 1.0 + p.x() / 50.0, Vector3(1.0 / 50.0, 0.0, 0.0) };
  }
};

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
  // Boundary nodes go to the nearest point, which is not quite the stretched one: 0.11 of an edge.
  EXPECT_LT(medianDistance(result.mesh.nodes, expected), 0.15 * edgeOfCell(stretched));
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

TEST(MeshOnTemplate, MassesAreEqualUnderADensity)
{
  const GrowingDensity density;
  SolidMeshingOptions  options = tiedTo(templateMesh(), TemplateAlignment::None);
  options.density = &density;
  const SolidMeshingResult result = meshed(semiAxes, options);
  EXPECT_TRUE(result.equalisation->exact);
  ASSERT_TRUE(result.mass);
  EXPECT_LE(result.mass->variance, 1e-18);
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[2].name, "masses");
  const std::vector<double> volumes = cellVolumes(result.mesh);
  const auto [smallest, largest] = std::minmax_element(volumes.begin(), volumes.end());
  EXPECT_GT(*largest / *smallest, 1.5); // 1.9 from end to end
}

TEST(MeshOnTemplate, TheOwnMeshIsAskedForOnlyWhereTheTemplateDoesNotDo)
{
  SolidMeshingOptions options = tiedTo(templateMesh());
  int                 asked = 0;
  options.ownMesh = [&asked]() -> std::optional<OwnMesh> {
    ++asked;
    return std::nullopt;
  };
  const SolidMeshingResult result = meshed(semiAxes, options);
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_FALSE(result.drawnFromOwnMesh);
  EXPECT_EQ(asked, 0);
  options.allowPartial = true;
  options.equalisation.surfaceTolerance = 1e-9; // no mesh reaches it
  EXPECT_FALSE(meshed(Vector3(14.0, 13.0, 10.0), options).equalisation->exact);
  EXPECT_EQ(asked, 1);
}

TEST(MeshOnTemplate, TheOwnMeshMayBeOfASimplerSolid)
{
  SolidMeshingOptions options = tiedTo(templateMesh());
  options.allowPartial = true;
  const OrderedSolid other = ellipsoid(Vector3(14.0, 13.0, 10.0), 0.75);
  const HexMesh      own = meshSolid(other.ordering, other.phi, other.volume, withShells(5)).mesh;
  LevelSet           hollow = other.phi; // a slit that no lattice follows
  for (std::size_t node = 0; node < hollow.values.size(); ++node)
  {
    const Vector3 p = hollow.grid.point(node);
    hollow.values[node] = std::max(hollow.values[node], std::min(1.5 - std::abs(p.x()), 4.0 + p.z()));
  }
  options.ownMesh = [&] { return OwnMesh{ own, other.phi }; };
  const SolidMeshingResult result = meshOnTemplate(hollow, other.volume, options);
  ASSERT_TRUE(result.equalisation->exact);
  ASSERT_TRUE(result.simplerSolid);
  EXPECT_EQ(result.simplerSolid->values, other.phi.values);
  EXPECT_LE(result.boundary.maximum, 0.5); // of that solid
  EXPECT_EQ(result.stages.back().note.rfind("from the solid's own mesh; ", 0), 0u) << result.stages.back().note;
  EXPECT_TRUE(result.drawnFromOwnMesh);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_NE(result.warnings.front().find("own mesh"), std::string::npos) << result.warnings.front();
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

TEST(MeshOnTemplate, TwoRunsGiveTheSameBytes)
{
  const Vector3 other(14.0, 13.0, 10.0);
  for (const TemplateAlignment alignment : { TemplateAlignment::None, TemplateAlignment::Rigid })
  {
    const Positions once = meshed(other, tiedTo(templateMesh(), alignment)).mesh.nodes;
    const Positions again = meshed(other, tiedTo(templateMesh(), alignment)).mesh.nodes;
    ASSERT_EQ(once.size(), again.size());
    EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(Vector3)), 0);
  }
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
  const GrowingDensity density;
  options.density = &density;
  options.refinement.landmarks.resize(1);
  expectRefused(options);
  options = tiedTo(templateMesh());
  options.lastStage = MeshingStage::Moser;
  expectRefused(options);
  HexMesh mesh = templateMesh();
  mesh.nodes.pop_back();
  expectRefused(tiedTo(mesh));
}

TEST(MeshOnTemplate, ATemplateThatNoTieCanStartFromIsItselfAtFault)
{
  const double  length = 1e4;
  const Vector3 axis = Vector3::Ones().normalized();
  const Vector3 inside = templateMesh().nodes[555];
  HexMesh       needle = templateMesh();
  for (Vector3 & node : needle.nodes)
  {
    const Vector3 from = node - inside; // so that one node lies in the solid
    const double  along = axis.dot(from);
    node = length * along * axis + (from - along * axis) / std::sqrt(length);
  }
  try
  {
    (void)meshed(semiAxes, tiedTo(needle, TemplateAlignment::None));
    FAIL() << "a needle was tied";
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Template);
    EXPECT_NE(std::string(error.what()).find("far larger than the volume"), std::string::npos) << error.what();
  }
}
