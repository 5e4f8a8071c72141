#include "moserhex/ShapeStatistics/MeanMesh.h"

#include "BoundaryDistance.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/EqualMeasureProjection.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

#include <algorithm>
#include <sstream>

namespace moserhex
{
namespace
{

/** Volumes with a smaller variance are equal: 1e-9 relative, as equaliseVolumes promises. */
constexpr double equalVariance = 1e-18;

/** Mesh, volume, certificate and variance of a candidate. */
void
judge(MeanMeshResult & result, unsigned int threads)
{
  const MeasureEquality equality = measureEquality(result.mesh, VolumeMeasure(), threads);
  result.volume = equality.total;
  result.varianceAfter = equality.variance;
  result.certified = certifyCells(result.mesh, {}, threads);
  result.exact = equality.variance <= equalVariance && result.certified.positive == result.mesh.cellCount();
}

void
measureMoves(MeanMeshResult & result, const HexMesh & mean)
{
  double sum = 0.0;
  for (std::size_t node = 0; node < mean.nodes.size(); ++node)
  {
    const double move = (result.mesh.nodes[node] - mean.nodes[node]).norm();
    sum += move;
    result.largestMove = std::max(result.largestMove, move);
  }
  result.meanMove = sum / static_cast<double>(mean.nodes.size());
}

void
nameShortcomings(MeanMeshResult & result)
{
  std::ostringstream text;
  if (result.varianceAfter > equalVariance)
  {
    text << "volume variance of the mean mesh " << result.varianceAfter << ", need " << equalVariance;
    result.shortcomings.push_back(text.str());
  }
  const std::size_t doubtful = result.certified.notPositive + result.certified.undecided;
  if (doubtful > 0)
  {
    result.shortcomings.push_back(std::to_string(doubtful) + " cells of the mean mesh are not certified");
  }
}

} // namespace

MeanMeshResult
equalVolumeMean(const HexMesh & mean, unsigned int threads, const ProgressCallback & progress)
{
  requireValid(mean);
  if (mean.nodesPerSide < 3)
  {
    throw InvalidInput("mean mesh: 2 nodes a side, need at least 3");
  }
  const VolumeMeasure   volume;
  const MeasureEquality before = measureEquality(mean, volume, threads);
  const SignedDistance  phi = boundaryDistance(mean);
  EqualMeasureOptions   projection;
  projection.threads = threads;
  MeanMeshResult result;
  result.varianceBefore = before.variance;
  const double target = before.total / static_cast<double>(mean.cellCount());
  result.mesh =
    projectOntoEqualMeasure(mean, volume, target, phi, projection, progressBetween(progress, 0.0, 0.2)).mesh;
  judge(result, threads);
  if (!result.exact)
  {
    EqualisationOptions options;
    options.threads = threads;
    result.mesh = equaliseVolumes(mean, phi, before.total, options, progressBetween(progress, 0.2, 1.0)).mesh;
    result.reworked = true;
    judge(result, threads);
  }
  measureMoves(result, mean);
  nameShortcomings(result);
  return result;
}

} // namespace moserhex
