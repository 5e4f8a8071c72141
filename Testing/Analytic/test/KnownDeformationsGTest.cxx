// Round-off of a formula and its inverse, 1e-12 of the size; the bulge's inverse is iterated, to the same. A solid
// keeps within its box: exact, at the border of a fine grid.
#include "moserhex/Analytic/KnownDeformations.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

/** On a box about the pear. */
std::vector<Vector3>
somePoints()
{
  std::vector<Vector3> points;
  for (const double x : { -30.0, -7.0, 0.0, 12.0, 30.0 })
  {
    for (const double y : { -24.0, 0.0, 9.0, 24.0 })
    {
      for (const double z : { -18.0, 0.0, 4.0, 18.0 })
      {
        points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

/** Least value of the function on the surface of the box. */
double
leastOnTheBox(const Solid & solid)
{
  constexpr int steps = 60;
  double        least = 1e9;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int u = 0; u <= steps; ++u)
      {
        for (int v = 0; v <= steps; ++v)
        {
          Vector3 part;
          part[axis] = side;
          part[(axis + 1) % 3] = static_cast<double>(u) / steps;
          part[(axis + 2) % 3] = static_cast<double>(v) / steps;
          const Vector3 p = solid.box.lower + part.cwiseProduct(solid.box.upper - solid.box.lower);
          least = std::min(least, solid.signedFunction(p));
        }
      }
    }
  }
  return least;
}

} // namespace

TEST(KnownDeformations, AreUndoneByTheirInverses)
{
  for (const KnownDeformation & deformation : knownDeformations())
  {
    SCOPED_TRACE(deformation.name);
    for (const Vector3 & p : somePoints())
    {
      EXPECT_LT((deformation.inverse(deformation.forward(p)) - p).norm(), 1e-11);
      EXPECT_LT((deformation.forward(deformation.inverse(p)) - p).norm(), 1e-11);
    }
  }
}

TEST(KnownDeformations, MoveThePointsThatTheyNameAsSaid)
{
  EXPECT_LT((shear().forward(Vector3(1.0, 10.0, 4.0)) - Vector3(2.0, 10.0, 5.0)).norm(), 1e-12);
  const Vector3 onArc = bend().forward(Vector3(30.0, 0.0, 5.0));
  EXPECT_NEAR((onArc - Vector3(0.0, 90.0, 5.0)).norm(), 90.0, 1e-12);
  const Vector3 place(20.0, 9.0, 4.0);
  EXPECT_NEAR((bulge().forward(place) - place).norm(), 4.0, 1e-12);
}

TEST(DeformedSolid, HasItsSurfaceWhereTheDeformationTakesIt)
{
  const Solid solid = pearShapedSolid();
  for (const KnownDeformation & deformation : knownDeformations())
  {
    SCOPED_TRACE(deformation.name);
    const Solid after = deformed(solid, deformation);
    for (const Vector3 & p : somePoints())
    {
      EXPECT_NEAR(after.signedFunction(deformation.forward(p)), solid.signedFunction(p), 1e-10);
    }
    EXPECT_GE(leastOnTheBox(after), 0.0);
  }
  EXPECT_GE(leastOnTheBox(solid), 0.0);
}
