#include "moserhex/SphericalMap/AreaBarrier.h"

#include "AreaBarrierSystem.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace moserhex
{
namespace
{

using Hessian = AreaBarrierSystem::Hessian;

/** Longest move of a vertex in one step [rad]: the tangent plane is a model of the sphere for short moves only. */
constexpr double longestMove = 0.5;

/** A step of at least this part of its full length counts as full. */
constexpr double fullStep = 0.9;

/** Factor of eps from one stage of the continuation to the next. */
constexpr double continuationFactor = 0.1;

/** Gauss-Newton creeps once a full step gains less than this part of the energy at the final eps: second derivatives of
 * the solid angles are then as large as eps L, and exact Newton steps take over. */
constexpr double creepingDecrease = 2e-3;

/** Damping of the exact steps in units of eps: the first, the least when it has to grow, the most before giving up. */
constexpr double firstDamping = 0.2;
constexpr double leastRaisedDamping = 0.1;
constexpr double mostDamping = 1e6;

/** One minimisation: where it stands, and how the next step is made. */
class Descent
{
public:
  Descent(AreaBarrierSystem & system, const Positions & start, const AreaBarrierOptions & options)
    : m_System(system)
    , m_Options(options)
    , m_Sphere(start)
    , m_ShapeWeight(std::max(options.startShapeWeight, options.shapeWeight))
  {
    m_Energy = m_System.energy(m_Sphere, m_ShapeWeight);
  }

  AreaBarrierResult
  run(const ProgressCallback & progress)
  {
    while (!m_Report.converged && !m_Stopped && m_Report.steps < m_Options.maximumSteps)
    {
      reportProgress(progress, static_cast<double>(m_Report.steps) / m_Options.maximumSteps);
      ++m_Report.steps;
      const std::optional<Eigen::VectorXd> step = newtonStep();
      if (!step)
      {
        continue;
      }
      const double before = m_Energy.value;
      const double length = search(*step);
      if (m_Options.stopAtRms > 0.0 && m_Energy.areaRatioRms < m_Options.stopAtRms &&
          m_ShapeWeight <= m_Options.shapeWeight)
      {
        m_Report.converged = true;
      }
      else if (m_Kind == Hessian::Exact)
      {
        afterExactStep(length);
      }
      else
      {
        afterGaussNewtonStep(length, (before - m_Energy.value) / before);
      }
    }
    AreaBarrierResult result;
    result.positions = std::move(m_Sphere);
    result.areaRatioRms = m_Energy.areaRatioRms;
    result.report = m_Report;
    return result;
  }

private:
  /** Nothing when the Hessian is not positive definite here; with an exact one more damping is tried next. */
  std::optional<Eigen::VectorXd>
  newtonStep()
  {
    m_System.assemble(m_Sphere, m_ShapeWeight, m_Kind, m_Damping);
    try
    {
      return m_System.newtonStep();
    }
    catch (const NotConverged &)
    {
      if (m_Kind == Hessian::GaussNewton)
      {
        stop("the Gauss-Newton matrix could not be factorised");
      }
      else
      {
        raiseDamping();
      }
      return std::nullopt;
    }
  }

  /** Moves to the first of length, length/2, ... with no flipped triangle and enough descent; 0 when there is none. */
  double
  search(const Eigen::VectorXd & step)
  {
    constexpr int    halvings = 30;
    constexpr double sufficient = 1e-4;
    constexpr double roundOff = 1e-14; // of the sum over triangles
    const double     slope = m_System.gradient().dot(step);
    double           longest = 0.0;
    for (Eigen::Index v = 0; v < step.size(); v += 2)
    {
      longest = std::max(longest, step.segment<2>(v).norm());
    }
    m_Report.residual = step.norm() / std::sqrt(0.5 * static_cast<double>(step.size()));
    double length = longest > longestMove ? longestMove / longest : 1.0;
    for (int k = 0; k < halvings; ++k, length *= 0.5)
    {
      Positions                       candidate = m_System.moved(m_Sphere, step, length);
      const AreaBarrierSystem::Energy energy = m_System.energy(candidate, m_ShapeWeight);
      if (energy.value <= m_Energy.value * (1.0 + roundOff) + sufficient * length * slope)
      {
        m_Sphere.swap(candidate);
        m_Energy = energy;
        return length;
      }
    }
    return 0.0;
  }

  void
  afterGaussNewtonStep(double length, double relativeDecrease)
  {
    const bool full = length > fullStep;
    const bool last = m_ShapeWeight <= m_Options.shapeWeight;
    if (last && ((full && relativeDecrease < creepingDecrease) || !(length > 0.0)))
    {
      m_Kind = Hessian::Exact;
      m_Damping = firstDamping * m_ShapeWeight;
      return;
    }
    // A refused full step raises the damping: soft directions are shortened, the stiff ones of area still solved.
    m_Damping = full ? 0.3 * m_Damping : std::max(m_Damping, m_ShapeWeight) * (length > 0.4 ? 3.0 : 9.0);
    if (!last && (full || relativeDecrease < 0.1))
    {
      m_ShapeWeight = std::max(continuationFactor * m_ShapeWeight, m_Options.shapeWeight);
      m_Energy = m_System.energy(m_Sphere, m_ShapeWeight);
    }
  }

  void
  afterExactStep(double length)
  {
    const bool full = length > fullStep;
    if (full && m_Report.residual < m_Options.stepTolerance && m_Damping <= leastRaisedDamping * m_ShapeWeight)
    {
      m_Report.converged = true;
    }
    else if (full)
    {
      m_Damping *= 0.3;
    }
    else
    {
      raiseDamping();
    }
  }

  void
  raiseDamping()
  {
    m_Damping = std::max(leastRaisedDamping * m_ShapeWeight, 4.0 * m_Damping);
    if (m_Damping > mostDamping * m_ShapeWeight)
    {
      stop("no descent");
    }
  }

  void
  stop(const std::string & note)
  {
    m_Stopped = true;
    m_Report.note = note;
  }

  AreaBarrierSystem &        m_System;
  const AreaBarrierOptions & m_Options;
  Positions                  m_Sphere;
  double                     m_ShapeWeight;
  AreaBarrierSystem::Energy  m_Energy;
  double                     m_Damping{ 0.0 };
  Hessian                    m_Kind{ Hessian::GaussNewton };
  bool                       m_Stopped{ false };
  StepReport                 m_Report;
};

void
requireProblem(const std::vector<Triangle> & triangles,
               const TriangleTopology &      topology,
               const std::vector<double> &   targets,
               const std::vector<double> &   edgeWeights)
{
  if (targets.size() != triangles.size() || topology.triangleEdges.size() != triangles.size() ||
      edgeWeights.size() != topology.edges.size())
  {
    std::ostringstream message;
    message << targets.size() << " targets and " << edgeWeights.size() << " weights for " << triangles.size()
            << " triangles and " << topology.edges.size() << " edges";
    throw InvalidInput(message.str());
  }
  const auto isPositive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!std::all_of(targets.begin(), targets.end(), isPositive) ||
      !std::all_of(edgeWeights.begin(), edgeWeights.end(), isPositive))
  {
    throw InvalidInput("a target solid angle or an edge weight is not positive and finite");
  }
}

void
requirePositions(const AreaBarrierSystem & system, const Positions & sphere)
{
  if (sphere.size() != system.bases().size())
  {
    std::ostringstream message;
    message << sphere.size() << " positions on the sphere for " << system.bases().size() << " vertices";
    throw InvalidInput(message.str());
  }
}

} // namespace

struct AreaBarrier::Implementation
{
  AreaBarrierSystem system;
};

AreaBarrier::AreaBarrier(const std::vector<Triangle> & triangles,
                         const TriangleTopology &      topology,
                         const std::vector<double> &   targets,
                         const std::vector<double> &   edgeWeights)
{
  requireProblem(triangles, topology, targets, edgeWeights);
  m_Implementation.reset(new Implementation{ AreaBarrierSystem(triangles, topology, targets, edgeWeights) });
}

AreaBarrier::~AreaBarrier() = default;

double
AreaBarrier::energy(const Positions & sphere, double shapeWeight) const
{
  requirePositions(m_Implementation->system, sphere);
  return m_Implementation->system.energy(sphere, shapeWeight).value;
}

AreaBarrierResult
AreaBarrier::minimise(const Positions & start, const AreaBarrierOptions & options, const ProgressCallback & progress)
{
  const Stopwatch     watch;
  AreaBarrierSystem & system = m_Implementation->system;
  requirePositions(system, start);
  if (!std::isfinite(system.energy(start, 1.0).value))
  {
    std::ostringstream message;
    message << "area barrier: the start has " << countFlippedTriangles(system.triangles(), start)
            << " flipped triangles, need 0";
    throw InvalidInput(message.str());
  }
  AreaBarrierResult result = Descent(system, start, options).run(progress);
  result.report.seconds = watch.seconds();
  return result;
}

} // namespace moserhex
