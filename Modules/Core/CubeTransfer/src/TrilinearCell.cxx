#include "TrilinearCell.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace moserhex
{
namespace
{

constexpr int         newtonSteps = 16;
constexpr int         deepest = 30;      ///< halvings one after the other
constexpr std::size_t mostBoxes = 20000; ///< looked at in one cell; a valid cell needs some hundreds at worst

Vector3
blend(const Vector3 & a, const Vector3 & b, double t)
{
  return (1.0 - t) * a + t * b;
}

/** A part of the reference cube. */
struct Box
{
  Vector3 lower{ Vector3::Zero() };
  int     depth{ 0 };

  [[nodiscard]] double
  side() const
  {
    return std::ldexp(1.0, -depth);
  }
  [[nodiscard]] Vector3
  centre() const
  {
    return lower.array() + 0.5 * side();
  }
};

HexCorners
imageOf(const Box & box, const HexCorners & corners)
{
  const double  h = box.side();
  const Vector3 o = box.lower;
  const double  reach[8][3] = { { 0, 0, 0 }, { h, 0, 0 }, { h, h, 0 }, { 0, h, 0 },
                                { 0, 0, h }, { h, 0, h }, { h, h, h }, { 0, h, h } };
  HexCorners    image;
  for (int c = 0; c < 8; ++c)
  {
    image[c] = trilinear(corners, o + Vector3(reach[c][0], reach[c][1], reach[c][2]));
  }
  return image;
}

/** Whether 0 can lie in the convex hull of the corners: seen along the axes and in those of the centre's tangents. */
bool
mayHoldZero(const HexCorners & corners, double tolerance)
{
  const auto between = [&](const Vector3 & normal) {
    double lowest = normal.dot(corners[0]);
    double highest = lowest;
    for (int c = 1; c < 8; ++c)
    {
      const double height = normal.dot(corners[c]);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    const double slack = tolerance * normal.norm();
    return lowest <= slack && highest >= -slack;
  };
  const Matrix3 tangents = trilinearTangents(corners, Vector3::Constant(0.5));
  return between(Vector3::UnitX()) && between(Vector3::UnitY()) && between(Vector3::UnitZ()) &&
         between(tangents.col(1).cross(tangents.col(2))) && between(tangents.col(2).cross(tangents.col(0))) &&
         between(tangents.col(0).cross(tangents.col(1)));
}

/** The root of x(xi) = 0 that Newton's method finds, moved into the reference cube; nothing when it leads far away or
 * the cell does not come near 0 there. */
std::optional<Vector3>
rootFrom(Vector3 xi, const HexCorners & corners, double tolerance)
{
  constexpr double farAway = 2.0;
  constexpr double rounding = 1e-15;
  for (int step = 0; step < newtonSteps; ++step)
  {
    const Matrix3 tangents = trilinearTangents(corners, xi);
    const double  determinant = tangents.determinant();
    if (!(std::abs(determinant) > 0.0))
    {
      return std::nullopt;
    }
    const Vector3 change = tangents.inverse() * trilinear(corners, xi);
    xi -= change;
    if (!((xi.array() - 0.5).abs().maxCoeff() < farAway))
    {
      return std::nullopt;
    }
    if (change.cwiseAbs().maxCoeff() < rounding)
    {
      break;
    }
  }
  const Vector3 inside = xi.cwiseMax(0.0).cwiseMin(1.0);
  if (trilinear(corners, inside).norm() <= tolerance)
  {
    return inside;
  }
  return std::nullopt;
}

} // namespace

Vector3
trilinear(const HexCorners & x, const Vector3 & xi)
{
  const Vector3 bottom = blend(blend(x[0], x[1], xi[0]), blend(x[3], x[2], xi[0]), xi[1]);
  const Vector3 top = blend(blend(x[4], x[5], xi[0]), blend(x[7], x[6], xi[0]), xi[1]);
  return blend(bottom, top, xi[2]);
}

Matrix3
trilinearTangents(const HexCorners & x, const Vector3 & xi)
{
  const Vector3 low = blend(x[0], x[1], xi[0]);  // the four edges along xi
  const Vector3 back = blend(x[3], x[2], xi[0]); // eta = 1
  const Vector3 high = blend(x[4], x[5], xi[0]); // zeta = 1
  const Vector3 far = blend(x[7], x[6], xi[0]);
  Matrix3       tangents;
  tangents.col(0) = blend(blend(x[1] - x[0], x[2] - x[3], xi[1]), blend(x[5] - x[4], x[6] - x[7], xi[1]), xi[2]);
  tangents.col(1) = blend(back - low, far - high, xi[2]);
  tangents.col(2) = blend(high - low, far - back, xi[1]);
  return tangents;
}

std::optional<Vector3>
trilinearInverse(const HexCorners & corners, const Vector3 & p, double tolerance)
{
  HexCorners fromPoint;
  for (int c = 0; c < 8; ++c)
  {
    fromPoint[c] = corners[c] - p;
  }
  if (!mayHoldZero(fromPoint, tolerance))
  {
    return std::nullopt;
  }
  std::vector<Box> boxes{ Box{} };
  for (std::size_t seen = 0; !boxes.empty() && seen < mostBoxes; ++seen)
  {
    const Box box = boxes.back();
    boxes.pop_back();
    if (box.depth > 0 && !mayHoldZero(imageOf(box, fromPoint), tolerance))
    {
      continue;
    }
    if (const auto root = rootFrom(box.centre(), fromPoint, tolerance))
    {
      return root;
    }
    for (int part = 7; part >= 0 && box.depth < deepest; --part)
    {
      const Vector3 step = Vector3(part & 1, part >> 1 & 1, part >> 2 & 1);
      boxes.push_back({ box.lower + 0.5 * box.side() * step, box.depth + 1 });
    }
  }
  return std::nullopt;
}

} // namespace moserhex
