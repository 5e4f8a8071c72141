// Spheres of radius 8 to 12 mm as shapes: one mode, and every distance is a difference of radii, within the height of a
// triangle, 0.1 mm at level 3. Determinism: bit for bit.
#include "moserhex/Correspondence/SurfaceModelQuality.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

constexpr int level = 3;

/** Points on spheres, which are that much smaller than the surfaces. */
std::vector<SubjectSurface>
spheres(double missing)
{
  std::vector<SubjectSurface> subjects;
  for (const double radius : { 8.0, 9.0, 10.0, 11.0, 12.0 })
  {
    subjects.push_back({ icosphere(level, radius - missing).vertices, icosphere(level, radius) });
  }
  return subjects;
}

TriangleMesh
span(const Positions & points)
{
  return { points, icosphere(level).triangles };
}

SurfaceModelQuality
qualityOf(const std::vector<SubjectSurface> & subjects, unsigned int threads = 0)
{
  SurfaceModelQualityOptions options;
  options.pairs = 10;
  options.threads = threads;
  return surfaceModelQuality(subjects, span, { 1, 7 }, options);
}

} // namespace

TEST(SurfaceModelQuality, AFamilyOfOneModeIsReconstructed)
{
  const SurfaceModelQuality quality = qualityOf(spheres(0.0));
  ASSERT_EQ(quality.generalisation.size(), 2u);
  EXPECT_LT(quality.generalisation[0], 1e-6);
  EXPECT_LT(quality.generalisation[1], 1e-6);
  EXPECT_GT(quality.specificity[0], 0.1); // radii between the subjects' and beyond
  EXPECT_LT(quality.specificity[0], 1.0);
}

TEST(SurfaceModelQuality, CountsWhatThePointsOfAllSubjectsLeaveOut)
{
  const SurfaceModelQuality quality = qualityOf(spheres(1.5));
  EXPECT_NEAR(quality.generalisation[0], 1.5, 0.1);
  EXPECT_LT(quality.generalisationError[0], 0.05);
  EXPECT_GT(quality.specificity[0], qualityOf(spheres(0.0)).specificity[0] + 0.5);
}

TEST(SurfaceModelQuality, DoesNotDependOnThreads)
{
  const SurfaceModelQuality one = qualityOf(spheres(0.5), 1);
  const SurfaceModelQuality three = qualityOf(spheres(0.5), 3);
  EXPECT_EQ(one.generalisation, three.generalisation);
  EXPECT_EQ(one.specificity, three.specificity);
}

TEST(SurfaceModelQuality, RefusesTooFewSubjectsAndOtherNumbersOfPoints)
{
  std::vector<SubjectSurface> subjects = spheres(0.0);
  subjects.back().points.pop_back();
  EXPECT_THROW((void)qualityOf(subjects), InvalidInput);
  subjects.resize(2);
  EXPECT_THROW((void)qualityOf(subjects), InvalidInput);
}
