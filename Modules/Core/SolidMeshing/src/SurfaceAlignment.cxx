#include "moserhex/SolidMeshing/SurfaceAlignment.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{

/** Of a point that goes to grid coordinates and back [grid edges]. */
constexpr double roundingOfGrid = 1e-6;

constexpr double firstDamping = 1e-3;
constexpr double smallestDamping = 1e-9;
constexpr double largestDamping = 1e6;
constexpr double dampingFactor = 5.0;
/** Part of the largest stiffness below which a direction is not determined [1]. */
constexpr double undetermined = 1e-3;

/** An end must be better by this factor to count for more than one that is nearer to the start [1]. */
constexpr double muchBetter = 0.99;

/** Of Cauchy's loss. */
constexpr double scalePerMedian = 1.5;
constexpr double smallestScale = 0.05; // [mm]
constexpr int    lossRounds = 4;

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

/** How a motion is changed: what a small step does to a point, and the step itself. */
class RigidSteps
{
public:
  static constexpr int size = 6; ///< rotation vector, translation

  using Step = Eigen::Matrix<double, size, 1>;

  /** Derivative of the distance. \param arm  of the moved point from the moved middle */
  static Step
  derivative(const Vector3 & arm, const Vector3 & gradient)
  {
    return (Step() << arm.cross(gradient), gradient).finished();
  }

  /** 1 + ... of a step without its translation. */
  static Matrix3
  factor(const Step & step)
  {
    const Vector3 turn = step.head<3>();
    const double  angle = turn.norm();
    return angle > 0.0 ? Eigen::AngleAxis<double>(angle, turn / angle).toRotationMatrix() : Matrix3::Identity();
  }
};

/** Those that keep volumes: without that, robust points may do best all on one side of the surface. */
class AffineSteps
{
public:
  static constexpr int size = 12; ///< rows of dA without its trace, translation

  using Step = Eigen::Matrix<double, size, 1>;

  static Step
  derivative(const Vector3 & arm, const Vector3 & gradient)
  {
    Matrix3 change = gradient * arm.transpose();
    change.diagonal().array() -= change.trace() / 3.0;
    return (Step() << change.row(0).transpose(), change.row(1).transpose(), change.row(2).transpose(), gradient)
      .finished();
  }

  static Matrix3
  factor(const Step & step)
  {
    Matrix3 factor = Matrix3::Identity();
    for (int row = 0; row < 3; ++row)
    {
      factor.row(row) += step.segment<3>(3 * row).transpose();
    }
    const double volume = factor.determinant();
    return volume > 0.0 ? Matrix3(factor / std::cbrt(volume)) : factor; // a step that turns over is not taken
  }
};

/** What a distance counts for: d^2, or with a scale s, Cauchy's s^2 log(1 + d^2 / s^2). */
class Loss
{
public:
  Loss() = default;

  explicit Loss(double scale) : m_Scale(scale)
  {}

  [[nodiscard]] double
  value(double distance) const
  {
    return m_Scale > 0.0 ? m_Scale * m_Scale * std::log1p(distance * distance / (m_Scale * m_Scale))
                         : distance * distance;
  }

  /** Of the square that has the same slope at the distance. */
  [[nodiscard]] double
  weight(double distance) const
  {
    return m_Scale > 0.0 ? 1.0 / (1.0 + distance * distance / (m_Scale * m_Scale)) : 1.0;
  }

private:
  double m_Scale{ 0.0 };
};

double
rmsAt(const Distance & distance, const Positions & points, const AffineTransform & motion)
{
  double sum = 0.0;
  for (const Vector3 & point : points)
  {
    sum += std::pow(distance.at(motion(point)).value, 2);
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/** One search, by steps of a kind and under a loss. */
template <typename TSteps>
class Descent
{
public:
  using Step = typename TSteps::Step;

  Descent(const Distance & distance, const Positions & points, const Loss & loss)
    : m_Distance(distance), m_Points(points), m_Loss(loss), m_Middle(middleOf(points))
  {
    for (const Vector3 & point : points)
    {
      m_Radius = std::max(m_Radius, (point - m_Middle).norm());
    }
  }

  SurfaceAlignmentResult
  run(AffineTransform motion, const SurfaceAlignmentOptions & options) const
  {
    SurfaceAlignmentResult result;
    double                 loss = lossAt(motion);
    double                 damping = firstDamping;
    while (result.report.steps < options.maximumSteps && !result.report.converged && damping <= largestDamping)
    {
      Normal normal = Normal::Zero();
      Step   slope = Step::Zero();
      linearise(motion, normal, slope);
      ++result.report.steps;
      for (bool isBetter = false; !isBetter && damping <= largestDamping;)
      {
        const Step            step = stepOf(normal, slope, damping);
        const AffineTransform next = stepped(motion, step);
        const double          after = next.matrix.determinant() > 0.0 ? lossAt(next) : loss;
        isBetter = after < loss;
        damping = isBetter ? std::max(damping / dampingFactor, smallestDamping) : damping * dampingFactor;
        if (isBetter)
        {
          result.report.converged = farthestMotion(step) < options.smallestMotion;
          motion = next;
          loss = after;
        }
      }
    }
    result.report.converged = result.report.converged || damping > largestDamping; // no step is better
    result.motion = motion;
    result.rmsAfter = rmsAt(m_Distance, m_Points, motion);
    result.report.residual = result.rmsAfter;
    return result;
  }

  [[nodiscard]] double
  lossAt(const AffineTransform & motion) const
  {
    double sum = 0.0;
    for (const Vector3 & point : m_Points)
    {
      sum += m_Loss.value(m_Distance.at(motion(point)).value);
    }
    return sum;
  }

private:
  using Normal = Eigen::Matrix<double, TSteps::size, TSteps::size>;

  /** The normal equations of a step. */
  void
  linearise(const AffineTransform & motion, Normal & normal, Step & slope) const
  {
    const Vector3 centre = motion(m_Middle);
    for (const Vector3 & point : m_Points)
    {
      const Vector3          moved = motion(point);
      const ValueAndGradient found = m_Distance.at(moved);
      const Step             row = TSteps::derivative(moved - centre, found.gradient);
      const double           weight = m_Loss.weight(found.value);
      normal += weight * row * row.transpose();
      slope += weight * found.value * row;
    }
  }

  /** The damped Gauss-Newton step, without directions that the surface does not determine: those in which it hardly
   * leaves itself. All but translations in units of the translation that they cause at the farthest point. */
  [[nodiscard]] Step
  stepOf(const Normal & normal, const Step & slope, double damping) const
  {
    Step unit = Step::Ones();
    unit.template head<TSteps::size - 3>() /= m_Radius;
    const Normal                                scaled = unit.asDiagonal() * normal * unit.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Normal> modes(scaled);
    const double                                largest = modes.eigenvalues().maxCoeff();
    Step amplitudes = modes.eigenvectors().transpose() * unit.cwiseProduct(slope);
    for (int mode = 0; mode < TSteps::size; ++mode)
    {
      const double stiffness = modes.eigenvalues()[mode];
      amplitudes[mode] *=
        stiffness > undetermined * largest ? -1.0 / (stiffness + damping * static_cast<double>(m_Points.size())) : 0.0;
    }
    return unit.cwiseProduct(modes.eigenvectors() * amplitudes);
  }

  /** A step about the moved middle, after the motion. */
  [[nodiscard]] AffineTransform
  stepped(const AffineTransform & motion, const Step & step) const
  {
    AffineTransform next;
    next.matrix = TSteps::factor(step) * motion.matrix;
    next.translation = motion(m_Middle) + step.template tail<3>() - next.matrix * m_Middle;
    return next;
  }

  [[nodiscard]] double
  farthestMotion(const Step & step) const
  {
    return step.template head<TSteps::size - 3>().norm() * m_Radius + step.template tail<3>().norm();
  }

  const Distance &  m_Distance;
  const Positions & m_Points;
  Loss              m_Loss;
  Vector3           m_Middle;
  double            m_Radius{ 0.0 };
};

double
medianDistance(const Distance & distance, const Positions & points, const AffineTransform & motion)
{
  std::vector<double> distances;
  for (const Vector3 & point : points)
  {
    distances.push_back(std::abs(distance.at(motion(point)).value));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/** An end of the search. */
struct End
{
  SurfaceAlignmentResult result;
  double                 scale{ 0.0 }; ///< of the last loss [mm]
};

/** Under Cauchy's loss, whose scale is found anew as the points come nearer. */
template <typename TSteps>
End
robustlyFrom(const Distance &                distance,
             const Positions &               points,
             const AffineTransform &         start,
             const SurfaceAlignmentOptions & options)
{
  End end;
  end.result.motion = start;
  end.scale = std::numeric_limits<double>::max();
  for (int round = 0; round < lossRounds; ++round)
  {
    const double median = medianDistance(distance, points, end.result.motion);
    end.scale = std::min(end.scale, std::max(smallestScale, scalePerMedian * median));
    const int steps = end.result.report.steps;
    end.result = Descent<TSteps>(distance, points, Loss(end.scale)).run(end.result.motion, options);
    end.result.report.steps += steps;
  }
  return end;
}

/** The best end from several starts; of ends that are as good, the first one's. */
template <typename TSteps>
SurfaceAlignmentResult
robustlyFromAny(const Distance &                     distance,
                const Positions &                    points,
                const std::vector<AffineTransform> & starts,
                const SurfaceAlignmentOptions &      options)
{
  End best = robustlyFrom<TSteps>(distance, points, starts.front(), options);
  for (std::size_t s = 1; s < starts.size(); ++s)
  {
    End                   other = robustlyFrom<TSteps>(distance, points, starts[s], options);
    const Descent<TSteps> judge(distance, points, Loss(std::min(best.scale, other.scale)));
    if (judge.lossAt(other.result.motion) < muchBetter * judge.lossAt(best.result.motion))
    {
      best = std::move(other);
    }
  }
  return best.result;
}

/** As the points are, their middle on the solid's, and the ends of least squares from these. */
std::vector<AffineTransform>
startsOf(const Distance &                distance,
         const Positions &               points,
         const Vector3 &                 middleOfSolid,
         const SurfaceAlignmentOptions & options)
{
  AffineTransform shifted;
  shifted.translation = middleOfSolid - middleOf(points);
  const Descent<RigidSteps> squares(distance, points, Loss());
  return { {}, shifted, squares.run({}, options).motion, squares.run(shifted, options).motion };
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
  const Distance         distance(phi);
  const Vector3          middle = middleOf(points);
  const auto             starts = startsOf(distance, points, middleOf(phi), options);
  SurfaceAlignmentResult best = options.kind == SurfaceAlignmentKind::Affine
                                  ? robustlyFromAny<AffineSteps>(distance, points, starts, options)
                                  : robustlyFromAny<RigidSteps>(distance, points, starts, options);
  best.shift = (best.motion(middle) - middle).norm();
  best.rmsBefore = rmsAt(distance, points, {});
  best.medianAfter = medianDistance(distance, points, best.motion);
  return best;
}

std::vector<double>
signedDistancesToSurface(const Positions & points, const LevelSet & phi)
{
  const Distance      distance(phi);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Vector3 & point : points)
  {
    if (!point.allFinite())
    {
      throw InvalidInput("signedDistancesToSurface: a point is not finite");
    }
    distances.push_back(distance.at(point).value);
  }
  return distances;
}

} // namespace moserhex
