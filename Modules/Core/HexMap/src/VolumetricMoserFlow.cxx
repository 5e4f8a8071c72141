#include "moserhex/HexMap/VolumetricMoserFlow.h"

#include "LatticeNodes.h"
#include "MoserVelocity.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace moserhex
{
namespace
{
/** Longest way of a node in one Runge-Kutta step [cells], and the number of steps that is never exceeded. */
constexpr double longestTimeStep = 0.5;
constexpr int    fewestSteps = 2;
constexpr int    mostSteps = 8;

void
requireOptions(const VolumetricMoserFlowOptions & options)
{
  const auto fail = [](const std::string & name, double value, const std::string & range) {
    throw InvalidInput(name + " " + std::to_string(value) + ", must be " + range);
  };
  if (options.maximumPasses < 1)
  {
    fail("flow passes", options.maximumPasses, "at least 1");
  }
  if (options.smoothedPasses < 0)
  {
    fail("smoothed passes", options.smoothedPasses, "at least 0");
  }
  if (!(options.targetVariance >= 0.0))
  {
    fail("target variance", options.targetVariance, "at least 0");
  }
  if (!(options.minimumGain >= 0.0 && options.minimumGain < 1.0))
  {
    fail("minimum gain", options.minimumGain, "in [0,1)");
  }
  if (!(options.concaveWeight >= 0.0 && std::isfinite(options.concaveWeight)))
  {
    fail("weight of concave cells", options.concaveWeight, "at least 0 and finite");
  }
}

/** f at a point of the lattice, trilinear between the nodes. */
Vector3
trilinear(const HexMesh & mesh, const Vector3 & point)
{
  const int              n = mesh.nodesPerSide;
  std::array<int, 3>     below{};
  std::array<Vector3, 4> rows;
  Vector3                weight;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const int base = std::min(static_cast<int>(point[axis]), n - 2);
    below[static_cast<std::size_t>(axis)] = base;
    weight[axis] = point[axis] - base;
  }
  for (int r = 0; r < 4; ++r)
  {
    const std::size_t node = mesh.nodeNumber(below[0], below[1] + (r & 1), below[2] + (r >> 1));
    rows[static_cast<std::size_t>(r)] = mesh.nodes[node] + weight[0] * (mesh.nodes[node + 1] - mesh.nodes[node]);
  }
  const Vector3 lower = rows[0] + weight[1] * (rows[1] - rows[0]);
  const Vector3 upper = rows[2] + weight[1] * (rows[3] - rows[2]);
  return lower + weight[2] * (upper - lower);
}

/** One pass: the mesh f o g_1^-1. */
HexMesh
flowOnce(const HexMesh &             mesh,
         const std::vector<double> & volumes,
         const MoserFlowOperators &  operators,
         const SurfaceProjection &   projection,
         BoundaryMotion              boundary,
         double &                    largestStep)
{
  const int           n = mesh.nodesPerSide;
  const MoserVelocity velocity(n, volumes, operators);
  const int           steps =
    std::clamp(static_cast<int>(std::ceil(velocity.largestSpeed() / longestTimeStep)), fewestSteps, mostSteps);

  HexMesh result{ n, Positions(mesh.nodes.size()) };
  largestStep = 0.0;
  lattice::forEachNode(n, [&](const lattice::Index3 & at, std::size_t node) {
    const bool onBoundary = lattice::isBoundary(n, at);
    if (onBoundary && boundary == BoundaryMotion::held)
    {
      result.nodes[node] = mesh.nodes[node];
      return;
    }
    const Vector3 point(at[0], at[1], at[2]);
    const Vector3 origin = velocity.originOf(point, steps);
    largestStep = std::max(largestStep, (origin - point).norm());
    const Vector3 position = trilinear(mesh, origin);
    result.nodes[node] = onBoundary && projection ? projection(position) : position;
  });
  return result;
}

MoserPass
assess(const HexMesh & mesh, double concaveWeight)
{
  const VolumeQuality quality = volumeQuality(mesh);
  MoserPass           pass;
  pass.volumeVariance = quality.volumeVariance;
  pass.concavePercent = quality.concavePercent;
  pass.score = quality.volumeVariance + concaveWeight * 0.01 * quality.concavePercent;
  return pass;
}
} // namespace

VolumetricMoserFlowResult
volumetricMoserFlow(const HexMesh &                    mesh,
                    const SurfaceProjection &          projection,
                    const VolumetricMoserFlowOptions & options,
                    const ProgressCallback &           progress)
{
  requireOptions(options);
  requireLattice(mesh);
  const std::vector<double> startVolumes = cellVolumes(mesh);
  const double              volume = std::accumulate(startVolumes.begin(), startVolumes.end(), 0.0);
  if (!(volume > 0.0))
  {
    throw InvalidInput("volume of the mesh " + std::to_string(volume) + " mm^3, must be positive");
  }

  const Stopwatch           stopwatch;
  VolumetricMoserFlowResult result;
  result.mesh = mesh;
  result.passes.push_back(assess(mesh, options.concaveWeight));
  const auto isDone = [&](const MoserPass & pass) {
    return pass.volumeVariance <= options.targetVariance && pass.concavePercent == 0.0;
  };

  const MoserFlowOperators operators(mesh.nodesPerSide);
  HexMesh                  current = mesh;
  for (int number = 1; number <= options.maximumPasses && !isDone(result.passes.back()); ++number)
  {
    reportProgress(progress, (number - 1.0) / options.maximumPasses);
    const bool   smoothed = number <= options.smoothedPasses;
    const double scoreBefore = result.passes.back().score;
    if (smoothed)
    {
      current = smoothLattice(current, projection, options.smoothingBetweenPasses);
    }
    const std::vector<double> volumes = cellVolumes(current);
    if (!(std::accumulate(volumes.begin(), volumes.end(), 0.0) > 0.0))
    {
      result.report.note = "stopped: smoothing turned the mesh inside out";
      break;
    }
    double largestStep = 0.0;
    current = flowOnce(current, volumes, operators, projection, options.boundary, largestStep);

    MoserPass pass = assess(current, options.concaveWeight);
    pass.largestStep = largestStep;
    pass.smoothed = smoothed;
    result.passes.push_back(pass);
    if (pass.score < result.passes[static_cast<std::size_t>(result.bestPass)].score)
    {
      result.bestPass = number;
      result.mesh = current;
    }
    if (!smoothed && !(pass.score <= (1.0 - options.minimumGain) * scoreBefore))
    {
      break;
    }
  }

  result.report.steps = static_cast<int>(result.passes.size()) - 1;
  result.report.residual = result.passes[static_cast<std::size_t>(result.bestPass)].volumeVariance;
  result.report.converged = result.bestPass > 0 || isDone(result.passes.front());
  if (result.report.note.empty() && !result.report.converged)
  {
    result.report.note = "no pass improved the mesh; it is returned as it was";
  }
  result.report.seconds = stopwatch.seconds();
  reportProgress(progress, 1.0);
  return result;
}

} // namespace moserhex
