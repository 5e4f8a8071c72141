// Refusals: exact.
#include "TestEqualisation.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/CellMeasure.h"

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex;
using namespace moserhex::testing;

namespace
{
void
expectRefused(const EqualisationOptions & options)
{
  EXPECT_THROW((void)equaliseVolumes(ball.lattice(2), ball.distance(), ball.volume(), options), InvalidInput);
}

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
} // namespace

TEST(VolumeEqualisation, MeshThatIsNotALatticeIsRefused)
{
  HexMesh mesh = ball.lattice(2);
  mesh.nodes.pop_back();
  EXPECT_THROW((void)equaliseVolumes(mesh, ball.distance(), ball.volume()), InvalidInput);
  EXPECT_THROW((void)equaliseVolumes({ 1, { Vector3::Zero() } }, ball.distance(), ball.volume()), InvalidInput);
}

TEST(VolumeEqualisation, NodeThatIsNotFiniteIsRefused)
{
  HexMesh mesh = ball.lattice(2);
  mesh.nodes[5].z() = infinity;
  EXPECT_THROW((void)equaliseVolumes(mesh, ball.distance(), ball.volume()), InvalidInput);
}

TEST(VolumeEqualisation, VolumeThatIsNotPositiveAndFiniteIsRefused)
{
  for (const double volume : { 0.0, -1.0, infinity, notANumber })
  {
    EXPECT_THROW((void)equaliseMeasures(ball.lattice(2), ball.distance(), volume, VolumeMeasure(), 1.0), InvalidInput)
      << volume;
  }
}

TEST(VolumeEqualisation, TotalThatIsNotPositiveAndFiniteIsRefused)
{
  for (const double total : { 0.0, -1.0, infinity, notANumber })
  {
    EXPECT_THROW((void)equaliseMeasures(ball.lattice(2), ball.distance(), ball.volume(), VolumeMeasure(), total),
                 InvalidInput)
      << total;
  }
}

TEST(VolumeEqualisation, NoSurfaceIsRefused)
{
  EXPECT_THROW((void)equaliseVolumes(ball.lattice(2), {}, ball.volume()), InvalidInput);
}

TEST(VolumeEqualisation, SurfaceFarFromTheStartIsRefused)
{
  BentEllipsoid away = ball;
  away.shift = Vector3(500.0, 0.0, 0.0);
  EXPECT_THROW((void)equaliseVolumes(ball.lattice(2), away.distance(), ball.volume()), InvalidInput);
}

TEST(VolumeEqualisation, LatticeAtRestOfAnotherSizeIsRefused)
{
  EqualisationOptions options;
  options.ties.rest = ball.lattice(3).nodes;
  EXPECT_THROW((void)equaliseVolumes(ball.lattice(4), ball.distance(), ball.volume(), options), InvalidInput);
}

TEST(VolumeEqualisation, CoarserLatticeThanGivenIsRefused)
{
  expectRefused(nodes(3));
  expectRefused(nodes(-1));
}

TEST(VolumeEqualisation, StageOutOfRangeIsRefused)
{
  for (const EqualisationStage & stage : { EqualisationStage{ 0.0, 50.0, 80.0, 60, 1 },
                                           EqualisationStage{ infinity, 50.0, 80.0, 60, 1 },
                                           EqualisationStage{ 0.1, -1.0, 80.0, 60, 1 },
                                           EqualisationStage{ 0.1, notANumber, 80.0, 60, 1 },
                                           EqualisationStage{ 0.1, infinity, 80.0, 60, 1 },
                                           EqualisationStage{ 0.1, 50.0, infinity, 60, 1 },
                                           EqualisationStage{ 0.1, 50.0, -1.0, 60, 1 },
                                           EqualisationStage{ 0.1, 50.0, 80.0, -1, 1 },
                                           EqualisationStage{ 0.1, 50.0, 80.0, 60, 0 },
                                           EqualisationStage{ 0.1, 50.0, 80.0, 60, 9 } })
  {
    EqualisationOptions options;
    options.coarseStages = { stage };
    expectRefused(options);
    options = {};
    options.finestStages = { stage };
    expectRefused(options);
    options = {};
    options.directStages = { stage };
    expectRefused(options);
  }
}

TEST(VolumeEqualisation, ListWithoutAStageIsRefused)
{
  EqualisationOptions options;
  options.coarseStages.clear();
  expectRefused(options);
  options = {};
  options.finestStages.clear();
  expectRefused(options);
  options = {};
  options.directStages.clear();
  expectRefused(options);
}

TEST(VolumeEqualisation, RepairOptionsOutOfRangeAreRefused)
{
  EqualisationOptions options;
  options.repairRounds = -1;
  expectRefused(options);
  for (const double margin : { 0.0, -0.1, notANumber })
  {
    options = {};
    options.repairMargin = margin;
    expectRefused(options);
  }
}

TEST(VolumeEqualisation, NegativeNumberOfPolishRoundsIsRefused)
{
  EqualisationOptions options;
  options.polishRounds = -1;
  expectRefused(options);
}

TEST(VolumeEqualisation, SurfaceToleranceThatIsNotPositiveIsRefused)
{
  EqualisationOptions options;
  for (const double tolerance : { 0.0, -0.1, notANumber })
  {
    options.surfaceTolerance = tolerance;
    expectRefused(options);
  }
}

TEST(VolumeEqualisation, ProjectionOptionOutOfRangeIsRefused)
{
  EqualisationOptions options;
  options.projection.normalMotion = 0.0;
  expectRefused(options);
}
