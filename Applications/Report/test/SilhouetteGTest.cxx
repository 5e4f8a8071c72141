// A fiftieth of the larger extent: outlines of solids whose pictures are known.
#include "Silhouette.h"
#include "moserhex/Analytic/Lattices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

std::vector<std::array<double, 2>>
pointsOf(const std::string & text)
{
  std::vector<std::array<double, 2>> points;
  std::istringstream                 stream(text);
  double                             x = 0.0;
  double                             z = 0.0;
  char                               comma = ' ';
  while (stream >> x >> comma >> z)
  {
    points.push_back({ x, z });
  }
  return points;
}

double
areaOf(const std::vector<std::array<double, 2>> & points)
{
  double twice = 0.0;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const auto & a = points[p];
    const auto & b = points[(p + 1) % points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2.0;
}

} // namespace

TEST(Silhouette, OfABoxIsItsRectangle)
{
  const HexMesh mesh =
    analytic::lattice(5, [](const Vector3 & i) { return Vector3(10.0 * i[0] - 7.0, 3.0 * i[1], 5.0 * i[2] + 100.0); });
  const auto points = pointsOf(silhouette(mesh));
  EXPECT_LE(points.size(), 8u);
  EXPECT_NEAR(areaOf(points), 40.0 * 20.0, 2.0 * (40.0 + 20.0) * 40.0 / 50.0);
  for (const auto & point : points)
  {
    EXPECT_GE(point[0], -7.0 - 0.8);
    EXPECT_LE(point[0], 33.0 + 0.8);
    EXPECT_GE(point[1], 100.0 - 0.8);
    EXPECT_LE(point[1], 120.0 + 0.8);
  }
}

TEST(Silhouette, OfABallIsADisc)
{
  const HexMesh mesh = analytic::lattice(9, [](const Vector3 & i) {
    const Vector3 p = i / 4.0 - Vector3::Ones();
    const double  norm = p.norm();
    return Vector3(norm > 0.0 ? Vector3(30.0 * p * p.cwiseAbs().maxCoeff() / norm) : p);
  });
  EXPECT_NEAR(areaOf(pointsOf(silhouette(mesh))), pi * 900.0, 0.05 * pi * 900.0);
}

TEST(Silhouette, OfABentSolidHasItsHollow)
{
  const HexMesh mesh = analytic::lattice(21, [](const Vector3 & i) {
    const double angle = i[0] / 20.0 * pi;
    const double radius = 20.0 + i[2] / 4.0;
    return Vector3(radius * std::cos(angle), i[1] / 4.0, radius * std::sin(angle));
  });
  EXPECT_NEAR(areaOf(pointsOf(silhouette(mesh))), pi / 2.0 * (625.0 - 400.0), 0.25 * pi / 2.0 * 225.0);
}

TEST(Silhouette, OfAFlatMeshIsEmpty)
{
  EXPECT_EQ(silhouette(analytic::lattice(3, [](const Vector3 & i) { return Vector3(i[0], i[1], 0.0); })), "");
}
