// An ellipsoid as template; solids that have grown everywhere, in one place, or not at all.
#include "TemplatePlacement.h"

#include "OrderedEllipsoid.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace moserhex;

namespace
{

const Vector3 semiAxes(15.0, 12.0, 10.0);

class TemplatePlacement : public ::testing::Test
{
protected:
  static SolidMeshingOptions
  aligned(TemplateAlignment alignment)
  {
    SolidMeshingOptions options = withShells(4);
    options.templateMesh = templateMesh();
    options.templateAlignment = alignment;
    return options;
  }

  static const HexMesh &
  templateMesh()
  {
    static const HexMesh mesh = [] {
      const OrderedSolid solid = ellipsoid(semiAxes, 0.75);
      return meshSolid(solid.ordering, solid.phi, solid.volume, withShells(4)).mesh;
    }();
    return mesh;
  }

  /** With a ball of 7 mm about one end of its longest axis. */
  static OrderedSolid
  withABall()
  {
    OrderedSolid solid = ellipsoid(semiAxes + Vector3::Constant(8.0), 0.75); // for its grid
    std::size_t  inside = 0;
    for (std::size_t node = 0; node < solid.phi.values.size(); ++node)
    {
      const Vector3 p = solid.phi.grid.point(node);
      const double  size = p.cwiseQuotient(semiAxes).norm();
      const double  slope = p.cwiseQuotient(semiAxes.cwiseProduct(semiAxes)).norm();
      const double  toEllipsoid = slope > 0.0 ? size * (size - 1.0) / slope : -semiAxes.minCoeff();
      const double  toBall = (p - Vector3(semiAxes.x(), 0.0, 0.0)).norm() - 7.0;
      solid.phi.values[node] = std::min(toEllipsoid, toBall);
      inside += solid.phi.values[node] < 0.0 ? 1 : 0;
    }
    solid.volume = static_cast<double>(inside) * std::pow(solid.phi.grid.spacing, 3);
    return solid;
  }

  /** Of nodes of equal index from scale times the template's [mm]. */
  static double
  largestDistance(const HexMesh & mesh, double scale)
  {
    double largest = 0.0;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      largest = std::max(largest, (mesh.nodes[node] - scale * templateMesh().nodes[node]).norm());
    }
    return largest;
  }

  static double
  volumeOf(const HexMesh & mesh)
  {
    const std::vector<double> cells = cellVolumes(mesh);
    return std::accumulate(cells.begin(), cells.end(), 0.0);
  }
};

} // namespace

TEST_F(TemplatePlacement, ASolidThatHasGrownInOnePlaceDoesNotMoveTheTemplate)
{
  const OrderedSolid solid = withABall();
  const double       scale = std::cbrt(solid.volume / volumeOf(templateMesh()));
  ASSERT_GT(scale, 1.02);
  for (const TemplateAlignment alignment : { TemplateAlignment::Rigid, TemplateAlignment::Affine })
  {
    const PlacedTemplate placed = placeTemplate(aligned(alignment), solid.phi, solid.volume);
    EXPECT_LT(largestDistance(placed.mesh, scale), 0.5 * solid.phi.grid.spacing); // in the solid's size: 0.5, 4.5 mm
    EXPECT_NEAR(volumeOf(placed.mesh), solid.volume, 1e-9 * solid.volume);
    ASSERT_TRUE(placed.alignment);
    EXPECT_LT(placed.alignment->medianAfter, 0.1);
  }
}

TEST_F(TemplatePlacement, ASolidThatHasGrownEverywhereGrowsTheTemplate)
{
  const double         scale = 1.05;
  const OrderedSolid   solid = ellipsoid(scale * semiAxes, 0.75);
  const PlacedTemplate placed = placeTemplate(aligned(TemplateAlignment::Rigid), solid.phi, solid.volume);
  EXPECT_LT(largestDistance(placed.mesh, std::cbrt(solid.volume / volumeOf(templateMesh()))), 0.1);
  ASSERT_TRUE(placed.alignment);
  EXPECT_LT(placed.alignment->medianAfter, 0.1);
}

TEST_F(TemplatePlacement, WithoutAnAlignmentOnlyTheSizeChanges)
{
  const OrderedSolid   solid = ellipsoid(1.05 * semiAxes, 0.75);
  const PlacedTemplate placed = placeTemplate(aligned(TemplateAlignment::None), solid.phi, solid.volume);
  EXPECT_FALSE(placed.alignment);
  EXPECT_EQ(placed.note.rfind("taken as it lies, scaled by 1.0", 0), 0u) << placed.note;
  EXPECT_LT(largestDistance(placed.mesh, std::cbrt(solid.volume / volumeOf(templateMesh()))), 1e-3);
}

TEST_F(TemplatePlacement, IsMeasuredAsItLiesAfterScaling)
{
  const double       scale = 1.2;
  const OrderedSolid solid = ellipsoid(scale * semiAxes, 0.75);
  for (const TemplateAlignment alignment :
       { TemplateAlignment::None, TemplateAlignment::Rigid, TemplateAlignment::Affine })
  {
    const PlacedTemplate placed = placeTemplate(aligned(alignment), solid.phi, solid.volume);
    EXPECT_NEAR(placed.fit.scale, scale, 1e-3);
    EXPECT_LT(placed.fit.rms, 0.2); // phi is a distance to first order only
    EXPECT_LT(placed.fit.median, 0.1);
    EXPECT_FALSE(placed.fit.medianOfInverse);
  }
  SolidMeshingOptions moved = aligned(TemplateAlignment::None);
  for (Vector3 & node : moved.templateMesh->nodes)
  {
    node.x() += 4.0;
  }
  const PlacedTemplate placed = placeTemplate(moved, solid.phi, solid.volume);
  EXPECT_GT(placed.fit.rms, 1.5);
  EXPECT_GT(placed.fit.median, 1.0);
  EXPECT_LT(placed.fit.median, 4.0);
}

TEST_F(TemplatePlacement, TheOtherDirectionOfATransformIsMeasured)
{
  const OrderedSolid  solid = ellipsoid(semiAxes, 0.75);
  SolidMeshingOptions options = aligned(TemplateAlignment::Rigid);
  options.templateNodes = options.templateMesh->nodes;
  for (std::size_t node = 0; node < options.templateNodes->size(); ++node)
  {
    options.templateMesh->nodes[node].x() += 5.0; // the right transform moves by -5 mm, this one by 5 mm
    (*options.templateNodes)[node].x() += 10.0;
  }
  const PlacedTemplate wrong = placeTemplate(options, solid.phi, solid.volume);
  ASSERT_TRUE(wrong.fit.medianOfInverse);
  EXPECT_LT(*wrong.fit.medianOfInverse, 0.1);
  EXPECT_GT(wrong.fit.median, 3.0);
  EXPECT_EQ(wrong.note.rfind("brought by a given transform, scaled by 1", 0), 0u) << wrong.note;
  for (Vector3 & node : *options.templateNodes)
  {
    node.x() += 80.0;
  }
  try
  {
    (void)placeTemplate(options, solid.phi, solid.volume);
    FAIL() << "a template beside the solid was taken";
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Template);
    EXPECT_NE(std::string(error.what()).find("no node lies in the organ"), std::string::npos) << error.what();
  }
}

TEST_F(TemplatePlacement, ATemplateWithoutVolumeIsRefused)
{
  const OrderedSolid  solid = ellipsoid(semiAxes, 0.75);
  SolidMeshingOptions options = aligned(TemplateAlignment::None);
  for (Vector3 & node : options.templateMesh->nodes)
  {
    node = Vector3::Zero();
  }
  EXPECT_THROW((void)placeTemplate(options, solid.phi, solid.volume), InvalidInput);
}
