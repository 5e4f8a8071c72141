// Two roads, one number: our quality measures against vtkMeshQuality (Verdict) on random hexahedra, from slightly
// shaken cubes to folded ones. Same formulas in another order of operations: 1e-12 relative.
#include "moserhex/Common/Random.h"
#include "moserhex/Quality/HexQuality.h"

#include <gtest/gtest.h>

#include <vtkHexahedron.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

using namespace moserhex;

namespace
{
HexCorners
shakenBox(Random & random, double amplitude)
{
  const Vector3 sides(random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0));
  const int     places[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
                                 { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  HexCorners    corners;
  for (std::size_t c = 0; c < 8; ++c)
  {
    const Vector3 shift(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    corners[c] = Vector3(places[c][0], places[c][1], places[c][2]).cwiseProduct(sides) + amplitude * shift;
  }
  return corners;
}

void
expectClose(double ours, double verdict, const char * what)
{
  EXPECT_NEAR(ours, verdict, 1e-12 * std::max(1.0, std::abs(verdict))) << what;
}

void
expectEqualToVerdict(const HexCorners & corners)
{
  vtkNew<vtkHexahedron> cell;
  for (int c = 0; c < 8; ++c)
  {
    cell->GetPoints()->SetPoint(c, corners[static_cast<std::size_t>(c)].data());
    cell->GetPointIds()->SetId(c, c);
  }
  const HexCellQuality quality = hexCellQuality(corners);
  expectClose(quality.minimumJacobian, vtkMeshQuality::HexJacobian(cell), "Jacobian");
  expectClose(quality.scaledJacobian, vtkMeshQuality::HexScaledJacobian(cell), "scaled Jacobian");
  expectClose(quality.aspectRatio, vtkMeshQuality::HexMaxEdgeRatio(cell), "maximum edge ratio");
  expectClose(quality.taper, vtkMeshQuality::HexTaper(cell), "taper");
  expectClose(quality.skew, vtkMeshQuality::HexSkew(cell), "skew");
  expectClose(quality.shape, vtkMeshQuality::HexShape(cell), "shape");
}
} // namespace

TEST(HexQualityAgainstVerdict, AgreesOnBoxes)
{
  Random random(1);
  for (int i = 0; i < 20; ++i)
  {
    expectEqualToVerdict(shakenBox(random, 0.0));
  }
}

TEST(HexQualityAgainstVerdict, AgreesOnShakenHexahedra)
{
  Random random(2);
  for (int i = 0; i < 1000; ++i)
  {
    expectEqualToVerdict(shakenBox(random, 0.2));
  }
}

TEST(HexQualityAgainstVerdict, AgreesOnFoldedHexahedra)
{
  Random random(3);
  int    concave = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const HexCorners corners = shakenBox(random, 0.7);
    concave += hexCellQuality(corners).concave ? 1 : 0;
    expectEqualToVerdict(corners);
  }
  EXPECT_GT(concave, 500);
}
