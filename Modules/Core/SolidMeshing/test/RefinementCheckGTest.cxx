// A cube as template, an ellipsoid as solid. Exact: which landmarks and images are refused or named.
#include "RefinementCheck.h"

#include "OrderedEllipsoid.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

using namespace moserhex;

namespace
{

/** A cube of side 10 mm at the origin: edges of 2 mm. */
HexMesh
cube()
{
  return analytic::lattice(6, [](const Vector3 & index) { return Vector3(2.0 * index); });
}

const OrderedSolid &
solid()
{
  static const OrderedSolid made = ellipsoid(Vector3(15.0, 12.0, 10.0), 0.75);
  return made;
}

std::vector<std::string>
warningsOn(const std::vector<CorrespondingPoints> & landmarks)
{
  TemplateRefinement refinement;
  refinement.landmarks = landmarks;
  return checkRefinement(cube(), refinement, solid().phi, solid().volume);
}

/** Of voxels of 1 mm, from one corner to another. */
ScalarVolume
image(const Vector3 & from, const Vector3 & to)
{
  ScalarVolume made;
  made.origin = from;
  for (int axis = 0; axis < 3; ++axis)
  {
    made.size[static_cast<std::size_t>(axis)] = static_cast<int>(to[axis] - from[axis]) + 1;
  }
  for (std::size_t voxel = 0; voxel < made.gridVoxels(); ++voxel)
  {
    made.values.push_back(static_cast<double>(voxel % 7));
  }
  return made;
}

const Vector3 middle(5.0, 5.0, 5.0);

} // namespace

TEST(RefinementCheck, LandmarksNearTheirOrgansPass)
{
  // 4.9 and 7.5 mm outside: two edges are 4 mm of the template, 7.8 mm of the solid.
  EXPECT_TRUE(
    warningsOn({ { middle, Vector3::Zero(), "apex" }, { Vector3(14.9, 5, 5), Vector3(22.5, 0, 0), "side" } }).empty());
}

TEST(RefinementCheck, LandmarksFarFromTheirOrgansAreNamed)
{
  const std::vector<std::string> warnings = warningsOn({ { middle, Vector3::Zero(), "apex" },
                                                         { Vector3(18.0, 5, 5), Vector3::Zero(), "base" },
                                                         { middle, Vector3(25.0, 0, 0), "" } });
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0], "landmarks outside of the template: base by 8.0 mm");
  EXPECT_EQ(warnings[1].substr(0, 40), "landmarks outside of the label: number 3") << warnings[1];
}

TEST(RefinementCheck, LandmarksThatAreAllElsewhereAreRefused)
{
  const Vector3 elsewhere(-200.0, 30.0, 0.0);
  EXPECT_EQ(analytic::codeThrownBy([&] {
              (void)warningsOn({ { elsewhere, Vector3::Zero(), "a" } });
            }),
            ErrorCode::TemplateLandmarks);
  EXPECT_EQ(analytic::codeThrownBy([&] {
              (void)warningsOn({ { middle, elsewhere, "a" }, { middle, elsewhere, "b" } });
            }),
            ErrorCode::Landmarks);
}

TEST(RefinementCheck, ImagesMustCoverTheirOrgans)
{
  const auto check = [](const ScalarVolume & ofTemplate, const ScalarVolume & ofSolid) {
    TemplateRefinement refinement;
    refinement.images = CorrespondingImages{ ofTemplate, ofSolid };
    (void)checkRefinement(cube(), refinement, solid().phi, solid().volume);
  };
  const ScalarVolume onTemplate = image(Vector3::Zero(), Vector3::Constant(10.0));
  const ScalarVolume onSolid = image(Vector3(-15.0, -12.0, -10.0), Vector3(15.0, 12.0, 10.0));
  EXPECT_NO_THROW(check(onTemplate, onSolid));
  EXPECT_NO_THROW(check(onSolid, onSolid));
  const ScalarVolume small = image(Vector3::Zero(), Vector3::Constant(8.0));
  EXPECT_EQ(analytic::codeThrownBy([&] { check(small, onSolid); }), ErrorCode::TemplateImage);
  EXPECT_EQ(analytic::codeThrownBy([&] { check(onTemplate, onTemplate); }), ErrorCode::Image);
}
