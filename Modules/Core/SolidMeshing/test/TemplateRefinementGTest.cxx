// An ellipsoid of revolution and itself turned about its axis: its shape does not show the turn; landmarks and images
// do. Exact: what is promised of every mesh, refusals, threads. Distances: bounds above what was measured.
#include "OrderedEllipsoid.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{

const Vector3 semiAxes(12.0, 12.0, 15.0);
constexpr int shells = 5;

const OrderedSolid &
solid()
{
  static const OrderedSolid spheroid = ellipsoid(semiAxes, 0.75);
  return spheroid;
}

const HexMesh &
templateMesh()
{
  static const HexMesh mesh = meshSolid(solid().ordering, solid().phi, solid().volume, withShells(shells)).mesh;
  return mesh;
}

/** 12 degrees about the axis of revolution. */
Vector3
turned(const Vector3 & p)
{
  return Eigen::AngleAxis<double>(12.0 / 180.0 * pi, Vector3::UnitZ()) * p;
}

Vector3
turnedBack(const Vector3 & p)
{
  return Eigen::AngleAxis<double>(-12.0 / 180.0 * pi, Vector3::UnitZ()) * p;
}

SolidMeshingOptions
tied(TemplateRefinement refinement)
{
  SolidMeshingOptions options = withShells(shells);
  options.templateMesh = templateMesh();
  options.templateAlignment = TemplateAlignment::None;
  options.refinement = std::move(refinement);
  return options;
}

TemplateRefinement
landmarks()
{
  TemplateRefinement             refinement;
  const std::vector<std::size_t> nodes = boundaryNodes(templateMesh());
  for (std::size_t b = 5; b < nodes.size(); b += 20)
  {
    const Vector3 & place = templateMesh().nodes[nodes[b]];
    refinement.landmarks.push_back({ place, turned(place) });
  }
  return refinement;
}

double
pattern(const Vector3 & p)
{
  return std::sin(0.4 * p.x()) + std::cos(0.5 * p.y() + 0.1 * p.z()) + 0.05 * p.x();
}

template <typename TFunction>
ScalarVolume
imageOf(const TFunction & function)
{
  ScalarVolume image;
  image.size = { { 37, 37, 43 } };
  image.origin = Vector3(-18.0, -18.0, -21.0);
  for (int k = 0; k < image.size[2]; ++k)
  {
    for (int j = 0; j < image.size[1]; ++j)
    {
      for (int i = 0; i < image.size[0]; ++i)
      {
        image.values.push_back(function(image.point(i, j, k)));
      }
    }
  }
  return image;
}

TemplateRefinement
images()
{
  TemplateRefinement refinement;
  refinement.images =
    CorrespondingImages{ imageOf(pattern),
                         imageOf([](const Vector3 & p) { return 100.0 + 20.0 * pattern(turnedBack(p)); }) };
  return refinement;
}

SolidMeshingResult
meshed(const SolidMeshingOptions & options)
{
  return meshOnTemplate(solid().phi, solid().volume, options);
}

/** Root mean square distance of the nodes to where the turn takes the template's, in cell edges. */
double
errorOf(const HexMesh & mesh)
{
  double sum = 0.0;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    sum += (mesh.nodes[node] - turned(templateMesh().nodes[node])).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(mesh.nodes.size())) / std::cbrt(solid().volume / 729.0);
}

} // namespace

TEST(TemplateRefinement, WithoutItTheTurnIsNotSeen)
{
  EXPECT_GT(errorOf(meshed(tied({})).mesh), 0.5);
}

TEST(TemplateRefinement, LandmarksShowTheTurn)
{
  const SolidMeshingResult result = meshed(tied(landmarks()));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LE(result.equalisation->variance, 1e-18);
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[2].name, "refined");
  ASSERT_TRUE(result.refinement);
  EXPECT_GT(result.refinement->landmarkError->before, 1.5);
  EXPECT_LT(result.refinement->landmarkError->after, 0.1 * result.refinement->landmarkError->before);
  EXPECT_LT(errorOf(result.mesh), 0.15);
}

TEST(TemplateRefinement, ImagesShowTheTurn)
{
  const SolidMeshingResult result = meshed(tied(images()));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_LE(result.equalisation->variance, 1e-18);
  ASSERT_TRUE(result.refinement);
  EXPECT_LT(result.refinement->imageDifference->after, 0.2 * result.refinement->imageDifference->before);
  EXPECT_LT(errorOf(result.mesh), 0.15);
}

TEST(TemplateRefinement, DoesNotDependOnThreads)
{
  SolidMeshingOptions one = tied(images());
  one.refinement.landmarks = landmarks().landmarks;
  one.threads = 1;
  SolidMeshingOptions three = one;
  three.threads = 3;
  EXPECT_EQ(meshed(one).mesh.nodes, meshed(three).mesh.nodes);
}

TEST(TemplateRefinement, LandmarksThatContradictEachOtherLeaveAnExactMesh)
{
  TemplateRefinement refinement = landmarks();
  const std::size_t  count = refinement.landmarks.size();
  for (std::size_t l = 0; l < count; ++l)
  {
    refinement.landmarks[l].onSolid = refinement.landmarks[(l + count / 2) % count].onTemplate; // inside out
  }
  const SolidMeshingResult result = meshed(tied(std::move(refinement)));
  EXPECT_TRUE(result.equalisation->exact);
  EXPECT_GT(result.refinement->landmarkError->after, 3.0);
  EXPECT_FALSE(result.refinement->complete);
  EXPECT_EQ(result.warnings.size(), 2u); // stopped early, and nothing came nearer
}

TEST(TemplateRefinement, LandmarksThatFitHardlyMoveNodes)
{
  TemplateRefinement refinement = landmarks();
  const HexMesh      before = meshed(tied({})).mesh;
  for (CorrespondingPoints & points : refinement.landmarks)
  {
    points.onSolid = points.onTemplate; // the template lies where it belongs
  }
  const SolidMeshingResult result = meshed(tied(std::move(refinement)));
  double                   farthest = 0.0;
  for (std::size_t node = 0; node < before.nodes.size(); ++node)
  {
    farthest = std::max(farthest, (result.mesh.nodes[node] - before.nodes[node]).norm());
  }
  EXPECT_LT(farthest, 0.1);
}

TEST(TemplateRefinement, NeedsATemplate)
{
  SolidMeshingOptions options = withShells(shells);
  options.refinement = landmarks();
  EXPECT_THROW((void)meshSolid(solid().ordering, solid().phi, solid().volume, options), InvalidInput);
}
