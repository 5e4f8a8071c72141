// Spheres with a known twist between them: 2e-3, what closest points on the outer shell's chords leave.
#include "moserhex/SolidMeshing/ShellFrames.h"

#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

using namespace moserhex;

TEST(AlignShellFrames, UndoesATwistBetweenShells)
{
  const TriangleMesh              outer = analytic::icosphere(4, 2.0);
  const TriangleMesh              inner = analytic::icosphere(3, 1.0);
  const std::vector<TriangleMesh> shells{ inner, outer };
  const Matrix3                   twist = analytic::rotation(Vector3(1, 2, -1), 0.4);
  const Positions                 aligned = analytic::icosphere(3).vertices;
  std::vector<Positions>          maps{ aligned, analytic::icosphere(4).vertices };
  for (Vector3 & s : maps[0])
  {
    s = twist * s;
  }
  alignShellFramesInPlace(shells, maps);
  for (std::size_t v = 0; v < aligned.size(); ++v)
  {
    EXPECT_LE((maps[0][v] - aligned[v]).norm(), 2e-3);
  }
}

TEST(AlignShellFrames, AnotherNumberOfMapsIsRefused)
{
  std::vector<Positions> maps(1);
  EXPECT_THROW(alignShellFramesInPlace({ analytic::icosphere(1), analytic::icosphere(1) }, maps), InvalidInput);
}
