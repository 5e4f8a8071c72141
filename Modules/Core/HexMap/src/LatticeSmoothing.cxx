#include "moserhex/HexMap/LatticeSmoothing.h"

#include "EdgeSliding.h"
#include "GuardedSmoothing.h"
#include "HarmonicExtension.h"
#include "LatticeNodes.h"
#include "moserhex/Common/Errors.h"

#include <cmath>

namespace moserhex
{
namespace
{
void
require(bool holds, const std::string & name, double value, const std::string & range)
{
  if (!holds)
  {
    throw InvalidInput(name + " " + std::to_string(value) + ", must be " + range);
  }
}

void
requireOptions(const LatticeSmoothingOptions & options)
{
  const auto isFraction = [](double value) { return value > 0.0 && value <= 1.0; };
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  require(options.edges.slides >= 0, "edge slides", options.edges.slides, "at least 0");
  require(isPositive(options.edges.sufficientCurvature),
          "sufficient curvature",
          options.edges.sufficientCurvature,
          "positive and finite");
  require(isPositive(options.edges.step), "edge step", options.edges.step, "positive and finite");
  require(isPositive(options.edges.gain), "edge gain", options.edges.gain, "positive and finite");
  require(options.edges.window >= 1, "edge window", options.edges.window, "at least 1");
  require(options.boundarySweeps >= 0, "boundary sweeps", options.boundarySweeps, "at least 0");
  require(isFraction(options.boundaryStrength), "boundary strength", options.boundaryStrength, "in (0,1]");
  require(options.interiorTime >= 0.0, "interior diffusion time", options.interiorTime, "at least 0");
  require(options.guarded.sweeps >= 0, "guarded sweeps", options.guarded.sweeps, "at least 0");
  require(isFraction(options.guarded.strength), "guarded strength", options.guarded.strength, "in (0,1]");
  require(options.guarded.threshold >= 0.0 && options.guarded.threshold < 1.0,
          "guarded threshold",
          options.guarded.threshold,
          "in [0,1)");
}

/** Step 2, one sweep. All nodes move at once (Jacobi). */
void
tangentialSweepInPlace(HexMesh & mesh, const SurfaceProjection & projection, double strength)
{
  const HexMesh before = mesh;
  lattice::forEachNode(mesh.nodesPerSide, [&](const lattice::Index3 & at, std::size_t node) {
    if (lattice::isBoundary(mesh.nodesPerSide, at))
    {
      const Vector3 & position = before.nodes[node];
      mesh.nodes[node] = projection(position + strength * (lattice::neighbourMean(before, at) - position));
    }
  });
}
} // namespace

HexMesh
smoothLattice(const HexMesh & mesh, const SurfaceProjection & projection, const LatticeSmoothingOptions & options)
{
  requireOptions(options);
  requireLattice(mesh);

  HexMesh result = mesh;
  if (projection)
  {
    for (int slide = 0; slide < options.edges.slides; ++slide)
    {
      slideCubeEdgesInPlace(result, projection, options.edges);
    }
    for (int sweep = 0; sweep < options.boundarySweeps; ++sweep)
    {
      tangentialSweepInPlace(result, projection, options.boundaryStrength);
    }
  }
  if (options.interiorTime > 0.0)
  {
    diffuseInteriorInPlace(result, options.interiorTime);
  }
  for (int sweep = 0; sweep < options.guarded.sweeps; ++sweep)
  {
    guardedSweepInPlace(result, projection, options.guarded);
  }
  return result;
}

} // namespace moserhex
