#include "moserhex/ShapeStatistics/ModeMesh.h"

#include "BoundaryDistance.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/SelfIntersection.h"

#include <algorithm>
#include <sstream>

namespace moserhex
{
namespace
{

HexMesh
displaced(const HexMesh & mean, const Positions & displacement, double deviations)
{
  HexMesh shape = mean;
  for (std::size_t node = 0; node < shape.nodes.size(); ++node)
  {
    shape.nodes[node] += deviations * displacement[node];
  }
  return shape;
}

/** Makes the shape exact. \return why it is no shape; empty when it is exact */
std::string
makeExact(const HexMesh & shape, unsigned int threads, const ProgressCallback & progress, EqualVolumeShape & result)
{
  if (!findSelfIntersections(boundaryTriangles(shape), 1).empty())
  {
    return "the surface cuts itself";
  }
  try
  {
    result = equalVolumeShape(shape, { EqualVolumeWay::Tied, threads }, progress);
  }
  catch (const InvalidInput & error)
  {
    return error.what();
  }
  return result.exact ? "" : result.shortcomings.front();
}

} // namespace

ModeMesh
exactModeMesh(const HexMesh &          mean,
              const Positions &        displacement,
              const ModeMeshOptions &  options,
              const ProgressCallback & progress)
{
  requireValid(mean);
  if (mean.nodesPerSide < 3 || displacement.size() != mean.nodes.size())
  {
    throw InvalidInput("mode mesh: " + std::to_string(displacement.size()) + " displacements for " +
                       std::to_string(mean.nodes.size()) + " nodes, need as many, and at least 3 nodes a side");
  }
  if (!std::all_of(options.deviations.begin(), options.deviations.end(), [](double d) { return d > 0.0; }))
  {
    throw InvalidInput("mode mesh: a number of deviations is not positive");
  }
  ModeMesh result;
  for (std::size_t i = 0; i < options.deviations.size() && result.deviations == 0.0; ++i)
  {
    const double      deviations = options.deviations[i];
    const std::string flaw = makeExact(displaced(mean, displacement, deviations),
                                       options.threads,
                                       progressOfPart(progress, i, options.deviations.size()),
                                       result.shape);
    if (flaw.empty())
    {
      result.deviations = deviations;
      continue;
    }
    std::ostringstream attempt;
    attempt << deviations << " standard deviations: " << flaw;
    result.attempts.push_back(attempt.str());
  }
  if (result.deviations == 0.0)
  {
    result.shape = {};
  }
  return result;
}

} // namespace moserhex
