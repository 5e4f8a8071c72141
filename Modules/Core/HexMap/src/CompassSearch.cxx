#include "CompassSearch.h"

#include "moserhex/Common/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

using Coordinates = CompassSearch::Coordinates;

constexpr double degree = 0.017453292519943295;

FramePlacement
placementAt(const Coordinates & x, const FramePlacementOptions & options)
{
  const Vector3  turn = options.maximumAngle * degree * x.head<3>();
  const double   angle = turn.norm();
  FramePlacement placement;
  if (angle > 0.0)
  {
    placement.rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }
  placement.boost = options.maximumBoost * x.tail<3>();
  return placement;
}

/** Both parts back into the unit ball, so that the search slides along the bounds. */
Coordinates
withinBounds(Coordinates x)
{
  x.head<3>() /= std::max(1.0, x.head<3>().norm());
  x.tail<3>() /= std::max(1.0, x.tail<3>().norm());
  return x;
}

} // namespace

CompassSearch::CompassSearch(const EdgeJudge & judge, const FramePlacementOptions & options)
  : m_Judge(judge), m_Options(options)
{
  for (Eigen::Index axis = 0; axis < 6; ++axis)
  {
    if ((axis < 3 ? options.maximumAngle : options.maximumBoost) > 0.0)
    {
      m_Axes.push_back(axis);
    }
  }
}

void
CompassSearch::run(const ProgressCallback & progress)
{
  m_Best = evaluate({ Coordinates::Zero() }).front();
  double step = m_Options.firstStep;
  while (!m_Axes.empty() && step >= m_Options.smallestStep && m_Report.steps < m_Options.maximumRounds)
  {
    reportProgress(progress,
                   std::log(step / m_Options.firstStep) / std::log(0.5 * m_Options.smallestStep / m_Options.firstStep));
    step = poll(step) ? step : 0.5 * step;
    ++m_Report.steps;
  }
  m_Report.residual = step;
  m_Report.converged = m_Axes.empty() || step < m_Options.smallestStep;
}

bool
CompassSearch::poll(double step)
{
  std::vector<Coordinates> neighbours;
  for (const Eigen::Index axis : m_Axes)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      neighbours.push_back(withinBounds(m_Best.x + sign * step * Coordinates::Unit(axis)));
    }
  }
  bool moved = false;
  for (const Candidate & candidate : evaluate(neighbours))
  {
    if (candidate.objective < m_Best.objective)
    {
      m_Best = candidate;
      moved = true;
    }
  }
  return moved;
}

std::vector<CompassSearch::Candidate>
CompassSearch::evaluate(const std::vector<Coordinates> & points)
{
  std::vector<Candidate> candidates(points.size());
  parallelFor(points.size(), m_Options.threads, [&](std::size_t i) {
    Candidate & candidate = candidates[i];
    candidate.x = points[i];
    candidate.placement = placementAt(points[i], m_Options);
    candidate.score = m_Judge.judge(candidate.placement);
    candidate.objective = std::log(candidate.score.score) + m_Options.anchor * points[i].squaredNorm();
  });
  m_Evaluations += static_cast<int>(points.size());
  return candidates;
}

} // namespace moserhex
