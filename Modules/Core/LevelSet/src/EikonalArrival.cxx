#include "moserhex/LevelSet/EikonalArrival.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

void
requireUsable(const LevelSet & phi, const LevelSet & weight, std::size_t seed, const EikonalArrivalOptions & options)
{
  requireValid(phi, "eikonal arrival, phi");
  requireValid(weight, "eikonal arrival, weight");
  std::ostringstream message;
  if (phi.grid.size != weight.grid.size)
  {
    message << "eikonal arrival: phi and weight have different grids";
  }
  else if (seed >= phi.values.size() || !(phi.values[seed] < 0.0))
  {
    message << "eikonal arrival: seed " << seed << " is not a node inside the organ";
  }
  else if (!(options.sourceRadius >= 0.0) || !(options.relativeTolerance > 0.0) || options.maximumSweeps < 8)
  {
    message << "eikonal arrival: sourceRadius = " << options.sourceRadius
            << " (need >= 0), relativeTolerance = " << options.relativeTolerance
            << " (need > 0), maximumSweeps = " << options.maximumSweeps << " (need >= 8)";
  }
  else
  {
    for (std::size_t node = 0; node < phi.values.size(); ++node)
    {
      if (phi.values[node] < 0.0 && !(weight.values[node] > 0.0 && weight.values[node] < infinity))
      {
        message << "eikonal arrival: speed " << weight.values[node] << " at node " << node << ", need > 0 and finite";
        break;
      }
      if (phi.values[node] < 0.0 && phi.grid.isBorder(node))
      {
        message << "eikonal arrival: border node " << node << " lies inside the organ";
        break;
      }
    }
  }
  if (!message.str().empty())
  {
    throw InvalidInput(message.str());
  }
}

/** Godunov's upwind solution T of sum_a max(T - m_a, 0)^2 = slowness^2, m_a the smaller neighbour along axis a. */
double
upwindTime(std::array<double, 3> m, double slowness)
{
  std::sort(m.begin(), m.end());
  double t = m[0] + slowness;
  if (t > m[1])
  {
    const double difference = m[0] - m[1];
    t = 0.5 * (m[0] + m[1] + std::sqrt(std::max(0.0, 2 * slowness * slowness - difference * difference)));
    if (t > m[2])
    {
      const double sum = m[0] + m[1] + m[2];
      const double squares = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
      t = (sum + std::sqrt(std::max(0.0, sum * sum - 3 * (squares - slowness * slowness)))) / 3;
    }
  }
  return t;
}

class FastSweeping
{
public:
  FastSweeping(const LevelSet & phi, const LevelSet & weight, std::size_t seed, double sourceRadius)
    : m_Grid(phi.grid), m_Time(phi.values.size(), infinity), m_Slowness(phi.values.size(), 0.0)
  {
    for (std::size_t node = 0; node < phi.values.size(); ++node)
    {
      if (phi.values[node] < 0.0)
      {
        m_Slowness[node] = 1.0 / weight.values[node];
      }
    }
    fixSource(seed, sourceRadius);
  }

  /** One Gauss-Seidel pass; bit a of `direction`: backwards along axis a. Returns the largest relative change. */
  double
  sweep(unsigned int direction)
  {
    double     largestChange = 0.0;
    const auto index = [&](int axis, int step) {
      return (direction >> axis & 1u) != 0 ? m_Grid.size[axis] - 1 - step : step;
    };
    for (int kk = 1; kk < m_Grid.size[2] - 1; ++kk)
    {
      for (int jj = 1; jj < m_Grid.size[1] - 1; ++jj)
      {
        const std::size_t row = m_Grid.nodeNumber(0, index(1, jj), index(2, kk));
        for (int ii = 1; ii < m_Grid.size[0] - 1; ++ii)
        {
          const std::size_t node = row + static_cast<std::size_t>(index(0, ii));
          if (m_Slowness[node] > 0.0)
          {
            largestChange = std::max(largestChange, update(node));
          }
        }
      }
    }
    return largestChange;
  }

  [[nodiscard]] const std::vector<double> &
  times() const
  {
    return m_Time;
  }

private:
  /** The upwind scheme is inaccurate at the seed, where T has a kink: the nodes around it get distance / w(seed). */
  void
  fixSource(std::size_t seed, double radius)
  {
    const RegularGrid::Index centre = m_Grid.indexOf(seed);
    const double             slowness = m_Slowness[seed];
    const int                reach = static_cast<int>(radius);
    for (int k = std::max(0, centre[2] - reach); k <= std::min(m_Grid.size[2] - 1, centre[2] + reach); ++k)
    {
      for (int j = std::max(0, centre[1] - reach); j <= std::min(m_Grid.size[1] - 1, centre[1] + reach); ++j)
      {
        for (int i = std::max(0, centre[0] - reach); i <= std::min(m_Grid.size[0] - 1, centre[0] + reach); ++i)
        {
          const double      distance = Vector3(i - centre[0], j - centre[1], k - centre[2]).norm();
          const std::size_t node = m_Grid.nodeNumber(i, j, k);
          if (distance <= radius && m_Slowness[node] > 0.0)
          {
            m_Time[node] = distance * slowness;
            m_Slowness[node] = 0.0; // fixed
          }
        }
      }
    }
  }

  double
  update(std::size_t node)
  {
    const auto            sx = std::size_t{ 1 };
    const auto            sy = static_cast<std::size_t>(m_Grid.size[0]);
    const auto            sz = sy * static_cast<std::size_t>(m_Grid.size[1]);
    std::array<double, 3> smaller{ std::min(m_Time[node - sx], m_Time[node + sx]),
                                   std::min(m_Time[node - sy], m_Time[node + sy]),
                                   std::min(m_Time[node - sz], m_Time[node + sz]) };
    if (std::min(smaller[0], std::min(smaller[1], smaller[2])) == infinity)
    {
      return 0.0;
    }
    const double time = upwindTime(smaller, m_Slowness[node]);
    const double old = m_Time[node];
    if (!(time < old))
    {
      return 0.0;
    }
    m_Time[node] = time;
    return old == infinity ? 1.0 : (old - time) / old;
  }

  const RegularGrid & m_Grid;
  std::vector<double> m_Time;
  std::vector<double> m_Slowness; ///< 1/w at nodes to be computed, else 0
};

} // namespace

EikonalArrivalResult
eikonalArrival(const LevelSet & phi, const LevelSet & weight, std::size_t seed, const EikonalArrivalOptions & options)
{
  requireUsable(phi, weight, seed, options);
  const Stopwatch      watch;
  FastSweeping         solver(phi, weight, seed, options.sourceRadius);
  EikonalArrivalResult result;
  StepReport &         report = result.report;
  while (!report.converged && report.steps + 8 <= options.maximumSweeps)
  {
    report.residual = 0.0;
    for (unsigned int direction = 0; direction < 8; ++direction)
    {
      report.residual = std::max(report.residual, solver.sweep(direction));
      ++report.steps;
    }
    report.converged = report.residual <= options.relativeTolerance;
  }
  report.seconds = watch.seconds();
  if (!report.converged)
  {
    std::ostringstream message;
    message << "eikonal arrival: relative change " << report.residual << " in the last 8 of " << report.steps
            << " sweeps, need " << options.relativeTolerance;
    throw NotConverged(message.str(), report);
  }
  result.levelSet = { phi.grid, solver.times() };
  return result;
}

} // namespace moserhex
