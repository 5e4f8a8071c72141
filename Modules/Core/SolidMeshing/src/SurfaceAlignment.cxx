#include "moserhex/SolidMeshing/SurfaceAlignment.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/** Of a point that goes to grid coordinates and back [grid edges]. */
constexpr double roundingOfGrid = 1e-6;

constexpr double firstDamping = 1e-3;
constexpr double smallestDamping = 1e-9;
constexpr double largestDamping = 1e6;
constexpr double dampingFactor = 5.0;

Vector3
middleOf(const Positions & points)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & point : points)
  {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}

/** Of the grid's nodes inside. */
Vector3
middleOf(const LevelSet & phi)
{
  Vector3     sum = Vector3::Zero();
  std::size_t count = 0;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < 0.0)
    {
      sum += phi.grid.point(node);
      ++count;
    }
  }
  if (count == 0)
  {
    throw InvalidInput("alignToSurface: the level set has no inside");
  }
  return sum / static_cast<double>(count);
}

/** The distance to the surface, continued beyond the grid. */
class Distance
{
public:
  explicit Distance(const LevelSet & phi) : m_Phi(phi), m_At(phi)
  {}

  [[nodiscard]] ValueAndGradient
  at(const Vector3 & p) const
  {
    const Vector3    inGrid = nearestInGrid(p);
    ValueAndGradient found = m_At.at(inGrid);
    const Vector3    beyond = p - inGrid;
    const double     way = beyond.norm();
    if (way > roundingOfGrid * m_Phi.grid.spacing)
    {
      found.value += way;
      found.gradient = beyond / way;
    }
    return found;
  }

private:
  /** Of the box in which the interpolator knows phi. */
  [[nodiscard]] Vector3
  nearestInGrid(const Vector3 & p) const
  {
    const RegularGrid & grid = m_Phi.grid;
    const Vector3       last(grid.size[0] - 2, grid.size[1] - 2, grid.size[2] - 2);
    const Vector3       index = grid.continuousIndex(p).cwiseMax(1.0).cwiseMin(last);
    return grid.origin + grid.direction * (grid.spacing * index);
  }

  const LevelSet &  m_Phi;
  CubicInterpolator m_At;
};

/** Sum of squares at a motion, and the normal equations of a step from there when wanted. */
double
squaresAt(const Distance &            distance,
          const Positions &           points,
          const Vector3 &             middle,
          const SimilarityTransform & motion,
          Matrix6 *                   normal,
          Vector6 *                   slope)
{
  double sum = 0.0;
  for (const Vector3 & point : points)
  {
    const Vector3          moved = motion(point);
    const ValueAndGradient found = distance.at(moved);
    sum += found.value * found.value;
    if (normal != nullptr)
    {
      Vector6 row;
      row << (moved - motion(middle)).cross(found.gradient), found.gradient;
      *normal += row * row.transpose();
      *slope += found.value * row;
    }
  }
  return sum;
}

/** A step about the moved middle, after the motion. */
SimilarityTransform
stepped(const SimilarityTransform & motion, const Vector3 & middle, const Vector6 & step)
{
  const Vector3 turn = step.head<3>();
  const double  angle = turn.norm();
  const Matrix3 rotation =
    angle > 0.0 ? Eigen::AngleAxis<double>(angle, turn / angle).toRotationMatrix() : Matrix3::Identity();
  const Vector3       centre = motion(middle);
  SimilarityTransform next;
  next.rotation = rotation * motion.rotation;
  next.translation = centre + step.tail<3>() - next.rotation * middle;
  return next;
}

SurfaceAlignmentResult
descend(const Distance &                distance,
        const Positions &               points,
        SimilarityTransform             motion,
        const SurfaceAlignmentOptions & options)
{
  const Vector3 middle = middleOf(points);
  double        radius = 0.0;
  for (const Vector3 & point : points)
  {
    radius = std::max(radius, (point - middle).norm());
  }
  SurfaceAlignmentResult result;
  double                 squares = squaresAt(distance, points, middle, motion, nullptr, nullptr);
  double                 damping = firstDamping;
  while (result.report.steps < options.maximumSteps && !result.report.converged && damping <= largestDamping)
  {
    Matrix6 normal = Matrix6::Zero();
    Vector6 slope = Vector6::Zero();
    (void)squaresAt(distance, points, middle, motion, &normal, &slope);
    ++result.report.steps;
    for (bool isBetter = false; !isBetter && damping <= largestDamping;)
    {
      // Turns in units of the translation that they cause at the farthest point.
      Vector6 scale = Vector6::Constant(static_cast<double>(points.size()));
      scale.head<3>() *= radius * radius;
      const Matrix6             damped = normal + damping * Matrix6(scale.asDiagonal());
      const Vector6             step = -damped.ldlt().solve(slope);
      const SimilarityTransform next = stepped(motion, middle, step);
      const double              after = squaresAt(distance, points, middle, next, nullptr, nullptr);
      isBetter = after < squares;
      damping = isBetter ? std::max(damping / dampingFactor, smallestDamping) : damping * dampingFactor;
      if (isBetter)
      {
        const double farthest = step.head<3>().norm() * radius + step.tail<3>().norm();
        result.report.converged = farthest < options.smallestMotion;
        motion = next;
        squares = after;
      }
    }
  }
  result.report.converged = result.report.converged || damping > largestDamping; // no step is better
  result.motion = motion;
  result.rmsAfter = std::sqrt(squares / static_cast<double>(points.size()));
  result.report.residual = result.rmsAfter;
  return result;
}

} // namespace

SurfaceAlignmentResult
alignToSurface(const Positions & points, const LevelSet & phi, const SurfaceAlignmentOptions & options)
{
  if (points.size() < 3 ||
      std::any_of(points.begin(), points.end(), [](const Vector3 & point) { return !point.allFinite(); }))
  {
    throw InvalidInput("alignToSurface: need three finite points or more");
  }
  const Distance      distance(phi);
  const Vector3       middle = middleOf(points);
  SimilarityTransform shifted;
  shifted.translation = middleOf(phi) - middle;
  SurfaceAlignmentResult fromHere = descend(distance, points, {}, options);
  SurfaceAlignmentResult fromMiddle = descend(distance, points, shifted, options);
  const bool             isShiftBetter = fromMiddle.rmsAfter < 0.99 * fromHere.rmsAfter;
  SurfaceAlignmentResult best = isShiftBetter ? fromMiddle : fromHere;
  best.shift = (best.motion(middle) - middle).norm();
  best.rmsBefore =
    std::sqrt(squaresAt(distance, points, middle, {}, nullptr, nullptr) / static_cast<double>(points.size()));
  return best;
}

} // namespace moserhex
