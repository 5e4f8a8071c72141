#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"
#include "moserhex/SphericalMap/AreaBarrier.h"
#include "moserhex/SphericalMap/ConformalMap.h"
#include "moserhex/SphericalMap/FrameAlignment.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"
#include "moserhex/SphericalMap/MoserAreaFlow.h"
#include "moserhex/SphericalMap/SphereHierarchy.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

// The shape energy sees the surface's own cotangents, except where slivers make them huge or negative.
constexpr double smallestShapeWeight = 0.02;
constexpr double largestShapeWeight = 10.0;

/** Volume over area^1.5 (0.094 for a ball) beyond which a negative volume means inward orientation, not noise. */
constexpr double clearlyInwards = 1e-3;

/** Above this area ratio rms a pass of Moser's flow saves up to half of the Newton steps. */
constexpr double longShapeRms = 0.3;

/** Start energy of AreaBarrier (4 pi / 10 on a perfect sphere) above which the hierarchy is the better start. */
constexpr double largestStartEnergy = 10.0;

/** Smallest eps tried for the area tolerance: below it angles pay more than areas gain. */
constexpr double smallestContinuationWeight = 1e-8;

/** The next smaller eps when the areas miss their tolerance. The rms goes with about the square root of eps; small
 * steps matter, since far from the old minimiser the energy has several minima, and the map would depend on the way
 * there. */
double
nextShapeWeight(double shapeWeight, double rms, double tolerance)
{
  const double predicted = 0.9 * (tolerance / rms) * (tolerance / rms);
  return shapeWeight * std::min(std::max(predicted, 0.2), 0.7);
}

void
requireInput(const TriangleMesh & surface, const AreaPreservingMapOptions & options)
{
  requireSphere(surface, "sphere map");
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
  {
    if (!surface.vertices[v].allFinite())
    {
      std::ostringstream message;
      message << "sphere map: position of vertex " << v << " is not finite";
      throw InvalidInput(message.str());
    }
  }
  const double area = surfaceArea(surface);
  if (!(area > 0.0))
  {
    throw InvalidInput("sphere map: area of the surface is 0, need positive");
  }
  const double volume = enclosedVolume(surface);
  if (volume < -clearlyInwards * area * std::sqrt(area))
  {
    std::ostringstream message;
    message << "sphere map: enclosed volume = " << volume << " mm^3, need positive (triangles oriented outwards)";
    throw InvalidInput(message.str());
  }
  if (!(options.shapeWeight > 0.0) || !(options.areaTolerance > 0.0) || !(options.relativeFloor > 0.0))
  {
    std::ostringstream message;
    message << "sphere map: shapeWeight " << options.shapeWeight << ", areaTolerance " << options.areaTolerance
            << ", relativeFloor " << options.relativeFloor << ", need all positive";
    throw InvalidInput(message.str());
  }
}

/** The cascade of starts and what follows them, with its records. */
class Cascade
{
public:
  Cascade(const TriangleMesh & surface, const AreaPreservingMapOptions & options, const ProgressCallback & progress)
    : m_Surface(surface), m_Options(options), m_Progress(progress)
  {
    m_Result.shapeWeight = options.shapeWeight;
  }

  AreaPreservingMapResult
  run()
  {
    if (m_Options.lastStage == SphereMapStage::Conformal || m_Options.lastStage == SphereMapStage::Centred)
    {
      conformalStart(LaplacianWeights::Cotangent, m_Options.lastStage == SphereMapStage::Centred);
    }
    else
    {
      startWithoutFlips();
      reportProgress(m_Progress, 0.2);
      if (m_Options.lastStage == SphereMapStage::MoserFlow)
      {
        moserFlow(MoserAreaFlowOptions{}.maximumPasses);
      }
      else
      {
        minimise();
      }
    }
    m_Result.positions = rotated(m_Result.positions, bodyFrameRotation(m_Surface, m_Result.positions));
    m_Result.quality = sphereMapQuality(m_Surface, m_Result.positions, m_Options.relativeFloor);
    if (m_Options.lastStage == SphereMapStage::AreaPreserving)
    {
      requireGuarantee();
    }
    reportProgress(m_Progress, 1.0);
    return std::move(m_Result);
  }

private:
  void
  conformalStart(LaplacianWeights weights, bool centred)
  {
    ConformalMapOptions conformal;
    conformal.removedDirection = m_Options.removedDirection;
    conformal.removedNearPoint = m_Options.removedNearPoint;
    conformal.weights = weights;
    ConformalMapResult map = conformalSphereMap(m_Surface, conformal);
    m_Result.path = weights == LaplacianWeights::Cotangent ? "conformal" : "clamped";
    m_Result.positions = std::move(map.positions);
    m_Result.reports.push_back(map.report);
    if (centred)
    {
      MoebiusCentringResult centring = moebiusCentring(m_Surface, m_Result.positions);
      m_Result.positions = std::move(centring.positions);
      m_Result.reports.push_back(centring.report);
    }
  }

  /** True when the conformal map with these weights is a usable start; failures of its numerics only mean it is not. */
  bool
  tryConformalStart(LaplacianWeights weights)
  {
    try
    {
      conformalStart(weights, true);
    }
    catch (const NotConverged & failure)
    {
      m_Result.reports.push_back(failure.report);
      return false;
    }
    catch (const InvalidInput &)
    {
      // The input was checked before: only the triangle to remove can be degenerate here.
      return false;
    }
    return countFlippedTriangles(m_Surface.triangles, m_Result.positions) == 0;
  }

  void
  hierarchyStart()
  {
    SphereHierarchyResult map = sphereMapByHierarchy(m_Surface, {}, progressBetween(m_Progress, 0.0, 0.2));
    m_Result.path = "hierarchy";
    m_Result.positions = std::move(map.positions);
    m_Result.reports.push_back(map.report);
  }

  void
  startWithoutFlips()
  {
    if (!tryConformalStart(LaplacianWeights::Cotangent) && !tryConformalStart(LaplacianWeights::ClampedCotangent))
    {
      hierarchyStart();
    }
  }

  void
  moserFlow(int passes)
  {
    MoserAreaFlowOptions flow;
    flow.maximumPasses = passes;
    flow.relativeFloor = m_Options.relativeFloor;
    MoserAreaFlowResult moved = moserAreaFlow(m_Surface, m_Result.positions, flow);
    m_Result.positions = std::move(moved.positions);
    m_Result.reports.push_back(moved.report);
    m_Result.path += " + moser";
  }

  void
  tryMoserPass()
  {
    try
    {
      moserFlow(1);
    }
    catch (const NotConverged & failure)
    {
      // The Laplacian of a nearly degenerate map cannot be factorised; the start stays as it was.
      m_Result.reports.push_back(failure.report);
    }
  }

  /** A conformal start can press limbs into so little of the sphere that descent takes for ever. */
  void
  improveStart(const AreaBarrier & barrier)
  {
    if (m_Result.path == "conformal" && sphereMapQuality(m_Surface, m_Result.positions).areaRatioRms > longShapeRms)
    {
      tryMoserPass();
    }
    const double energy = barrier.energy(m_Result.positions, AreaBarrierOptions{}.startShapeWeight);
    if (m_Result.path != "hierarchy" && energy > largestStartEnergy)
    {
      hierarchyStart();
    }
  }

  void
  minimise()
  {
    const TriangleTopology topology = triangleTopology(m_Surface);
    AreaBarrier            barrier(m_Surface.triangles,
                        topology,
                        targetSolidAngles(m_Surface, m_Options.relativeFloor),
                        clampedCotanWeights(m_Surface, topology, smallestShapeWeight, largestShapeWeight));
    improveStart(barrier);

    AreaBarrierOptions options;
    options.shapeWeight = m_Options.shapeWeight;
    options.maximumSteps = m_Options.maximumSteps;
    AreaBarrierResult minimised = barrier.minimise(m_Result.positions, options, progressBetween(m_Progress, 0.2, 0.8));
    record(minimised, options.shapeWeight);
    while (minimised.areaRatioRms > m_Options.areaTolerance && options.shapeWeight > smallestContinuationWeight)
    {
      options.shapeWeight = nextShapeWeight(options.shapeWeight, minimised.areaRatioRms, m_Options.areaTolerance);
      options.startShapeWeight = options.shapeWeight;
      minimised = barrier.minimise(minimised.positions, options, progressBetween(m_Progress, 0.8, 1.0));
      record(minimised, options.shapeWeight);
    }
    if (options.shapeWeight < m_Options.shapeWeight)
    {
      std::ostringstream weight;
      weight << " + eps " << options.shapeWeight;
      m_Result.path += weight.str();
    }
    m_Result.positions = std::move(minimised.positions);
  }

  void
  record(const AreaBarrierResult & minimised, double shapeWeight)
  {
    std::ostringstream note;
    note << "barrier at eps " << shapeWeight;
    if (!minimised.report.note.empty())
    {
      note << ": " << minimised.report.note;
    }
    m_Result.reports.push_back(minimised.report);
    m_Result.reports.back().note = note.str();
    m_Result.shapeWeight = shapeWeight;
  }

  void
  requireGuarantee() const
  {
    const SphereMapQuality & quality = m_Result.quality;
    const double             limit = std::max(m_Options.areaTolerance, m_Options.areaLimit);
    if (isBijective(quality) && quality.areaRatioRms <= limit)
    {
      return;
    }
    std::ostringstream message;
    message << "sphere map";
    if (!isBijective(quality))
    {
      message << ": " << quality.flippedTriangles << " triangles flipped, need 0, solid angles sum to "
              << quality.solidAngleSum << ", need 4 pi";
    }
    if (!(quality.areaRatioRms <= limit))
    {
      message << ": area ratio rms " << quality.areaRatioRms << ", need " << limit;
    }
    message << "; way: " << m_Result.path;
    throw NotConverged(message.str(), m_Result.reports.empty() ? StepReport{} : m_Result.reports.back());
  }

  const TriangleMesh &             m_Surface;
  const AreaPreservingMapOptions & m_Options;
  const ProgressCallback &         m_Progress;
  AreaPreservingMapResult          m_Result;
};

} // namespace

AreaPreservingMapResult
areaPreservingSphereMap(const TriangleMesh &             surface,
                        const AreaPreservingMapOptions & options,
                        const ProgressCallback &         progress)
{
  requireInput(surface, options);
  return Cascade(surface, options, progress).run();
}

} // namespace moserhex
