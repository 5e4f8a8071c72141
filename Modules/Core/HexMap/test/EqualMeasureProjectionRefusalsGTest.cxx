// Refusals: exact.
#include "TestSolids.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/EqualMeasureProjection.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
const SignedDistance unitBox = boxDistance(Vector3::Ones());

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

void
expectRefused(const EqualMeasureOptions & options)
{
  EXPECT_THROW((void)projectOntoEqualMeasure(regularLattice(3), VolumeMeasure(), 0.125, unitBox, options),
               InvalidInput);
}
} // namespace

TEST(EqualMeasureProjection, MeshThatIsNotALatticeIsRefused)
{
  HexMesh mesh = regularLattice(3);
  mesh.nodes.pop_back();
  EXPECT_THROW((void)projectOntoEqualMeasure(mesh, VolumeMeasure(), 0.125, unitBox), InvalidInput);
  EXPECT_THROW((void)projectOntoEqualMeasure({ 1, { Vector3::Zero() } }, VolumeMeasure(), 1.0, unitBox), InvalidInput);
}

TEST(EqualMeasureProjection, NodeThatIsNotFiniteIsRefused)
{
  HexMesh mesh = regularLattice(3);
  mesh.nodes[5].y() = notANumber;
  EXPECT_THROW((void)projectOntoEqualMeasure(mesh, VolumeMeasure(), 0.125, unitBox), InvalidInput);
}

TEST(EqualMeasureProjection, TargetThatIsNotPositiveAndFiniteIsRefused)
{
  for (const double target : { 0.0, -1.0, infinity, notANumber })
  {
    EXPECT_THROW((void)projectOntoEqualMeasure(regularLattice(3), VolumeMeasure(), target, unitBox), InvalidInput)
      << target;
  }
}

TEST(EqualMeasureProjection, NoSurfaceIsRefused)
{
  EXPECT_THROW((void)projectOntoEqualMeasure(regularLattice(3), VolumeMeasure(), 0.125, {}), InvalidInput);
}

TEST(EqualMeasureProjection, ToleranceThatIsNotPositiveAndFiniteIsRefused)
{
  EqualMeasureOptions options;
  for (const double tolerance : { 0.0, infinity })
  {
    options.tolerance = tolerance;
    expectRefused(options);
  }
}

TEST(EqualMeasureProjection, NumbersOfStepsOutOfRangeAreRefused)
{
  EqualMeasureOptions options;
  options.maximumSteps = -1;
  expectRefused(options);
  options = {};
  options.maximumSolverSteps = 0;
  expectRefused(options);
}

TEST(EqualMeasureProjection, NormalMotionOutOfRangeIsRefused)
{
  EqualMeasureOptions options;
  for (const double normalMotion : { 0.0, -0.1, 1.01, notANumber })
  {
    options.normalMotion = normalMotion;
    expectRefused(options);
  }
}

TEST(EqualMeasureProjection, ShiftThatIsNotPositiveAndFiniteIsRefused)
{
  EqualMeasureOptions options;
  for (const double shift : { 0.0, infinity })
  {
    options.shift = shift;
    expectRefused(options);
  }
}
