#include "moserhex/ShapeStatistics/EqualVolumeShape.h"

#include "BoundaryDistance.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMap/EqualMeasureProjection.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

namespace moserhex
{
namespace
{

/** Volumes with a smaller variance are equal: 1e-9 relative, as equaliseVolumes promises. */
constexpr double equalVariance = 1e-18;
/** Of the mesh given, from one that hardly lets it bend to one that hardly holds it [1]. */
constexpr std::array<double, 2> referenceWeights{ { 2.0, 0.5 } };

/** Of boundary nodes, as equaliseVolumes has it [mm]. */
double
surfaceTolerance()
{
  return EqualisationOptions{}.surfaceTolerance;
}

/** By cells that are certified, then by how far the outline is beyond what is allowed, then by the variance. */
bool
isNearerToExact(const EqualVolumeShape & a, const EqualVolumeShape & b)
{
  const auto beyond = [](const EqualVolumeShape & shape) {
    return std::max(0.0, shape.boundaryDistance - surfaceTolerance());
  };
  return std::make_tuple(b.certified.positive, beyond(a), a.varianceAfter) <
         std::make_tuple(a.certified.positive, beyond(b), b.varianceAfter);
}

/** One run: what a way leaves for those after it. */
class Run
{
public:
  Run(const HexMesh & shape, const EqualVolumeOptions & options)
    : m_Shape(shape)
    , m_Options(options)
    , m_Phi(boundaryDistance(shape))
    , m_Before(measureEquality(shape, VolumeMeasure(), options.threads))
  {}

  [[nodiscard]] EqualVolumeShape
  run(const ProgressCallback & progress)
  {
    project(progressBetween(progress, 0.0, 0.1));
    if (!m_Result.exact && m_Options.lastWay != EqualVolumeWay::Projection && m_Shape.paddingLayers == 0)
    {
      tie(progressBetween(progress, 0.1, 0.5));
    }
    if (!m_Result.exact && m_Options.lastWay == EqualVolumeWay::Free)
    {
      EqualisationOptions options;
      options.threads = m_Options.threads;
      equalise(options, EqualVolumeWay::Free, progressBetween(progress, 0.5, 1.0));
    }
    measureMoves();
    nameShortcomings();
    return std::move(m_Result);
  }

private:
  void
  project(const ProgressCallback & progress)
  {
    EqualMeasureOptions options;
    options.threads = m_Options.threads;
    const double target = m_Before.total / static_cast<double>(m_Shape.cellCount());
    take(projectOntoEqualMeasure(m_Shape, VolumeMeasure(), target, m_Phi, options, progress).mesh,
         EqualVolumeWay::Projection);
  }

  void
  tie(const ProgressCallback & progress)
  {
    EqualisationOptions options;
    options.threads = m_Options.threads;
    options.ties.reference = m_Shape.nodes;
    options.hopelessCells = tangledCells(m_Shape.nodesPerSide);
    for (std::size_t w = 0; w < referenceWeights.size() && !m_Result.exact; ++w)
    {
      options.ties.referenceWeight = referenceWeights[w];
      equalise(options, EqualVolumeWay::Tied, progressOfPart(progress, w, referenceWeights.size()));
    }
  }

  void
  equalise(const EqualisationOptions & options, EqualVolumeWay way, const ProgressCallback & progress)
  {
    take(equaliseVolumes(m_Shape, m_Phi, m_Before.total, options, progress).mesh, way);
  }

  /** Volume, certificate, variance and outline of a mesh. */
  [[nodiscard]] EqualVolumeShape
  judged(HexMesh && mesh, EqualVolumeWay way) const
  {
    const MeasureEquality equality = measureEquality(mesh, VolumeMeasure(), m_Options.threads);
    EqualVolumeShape      made;
    made.mesh = std::move(mesh);
    made.way = way;
    made.volume = equality.total;
    made.varianceBefore = m_Before.variance;
    made.varianceAfter = equality.variance;
    made.certified = certifyCells(made.mesh, {}, m_Options.threads);
    made.boundaryDistance = boundaryDistanceOf(made.mesh);
    made.exact = equality.variance <= equalVariance && made.certified.positive == made.mesh.cellCount() &&
                 made.boundaryDistance <= surfaceTolerance();
    return made;
  }

  /** Keeps a mesh that is the first, or nearer to exact than the one before. */
  void
  take(HexMesh && mesh, EqualVolumeWay way)
  {
    EqualVolumeShape made = judged(std::move(mesh), way);
    if (m_Result.mesh.nodes.empty() || isNearerToExact(made, m_Result))
    {
      m_Result = std::move(made);
    }
  }

  void
  measureMoves()
  {
    double sum = 0.0;
    for (std::size_t node = 0; node < m_Shape.nodes.size(); ++node)
    {
      const double move = (m_Result.mesh.nodes[node] - m_Shape.nodes[node]).norm();
      sum += move;
      m_Result.largestMove = std::max(m_Result.largestMove, move);
    }
    m_Result.meanMove = sum / static_cast<double>(m_Shape.nodes.size());
  }

  [[nodiscard]] double
  boundaryDistanceOf(const HexMesh & mesh) const
  {
    double  largest = 0.0;
    Vector3 gradient;
    for (const std::size_t node : boundaryNodes(mesh))
    {
      largest = std::max(largest, std::abs(m_Phi(mesh.nodes[node], gradient)));
    }
    return largest;
  }

  void
  nameShortcomings()
  {
    if (m_Result.varianceAfter > equalVariance)
    {
      std::ostringstream text;
      text << "volume variance " << m_Result.varianceAfter << ", need " << equalVariance;
      m_Result.shortcomings.push_back(text.str());
    }
    const std::size_t doubtful = m_Result.certified.notPositive + m_Result.certified.undecided;
    if (doubtful > 0)
    {
      m_Result.shortcomings.push_back(std::to_string(doubtful) + " cells are not certified");
    }
    if (m_Result.boundaryDistance > surfaceTolerance())
    {
      std::ostringstream text;
      text << "the boundary is " << m_Result.boundaryDistance << " mm off, need " << surfaceTolerance();
      m_Result.shortcomings.push_back(text.str());
    }
  }

  const HexMesh &            m_Shape;
  const EqualVolumeOptions & m_Options;
  SignedDistance             m_Phi;
  MeasureEquality            m_Before;
  EqualVolumeShape           m_Result;
};

} // namespace

EqualVolumeShape
equalVolumeShape(const HexMesh & shape, const EqualVolumeOptions & options, const ProgressCallback & progress)
{
  requireValid(shape);
  if (shape.nodesPerSide < 3)
  {
    throw InvalidInput("equal volumes: 2 nodes a side, need at least 3");
  }
  return Run(shape, options).run(progress);
}

} // namespace moserhex
