#include "moserhex/HexMap/FramePlacement.h"

#include "CompassSearch.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/SphericalMap/MoebiusCentring.h"

#include <cmath>
#include <sstream>
#include <string>

namespace moserhex
{
namespace
{

void
require(bool holds, const std::string & quantity, double value, const std::string & range)
{
  if (!holds)
  {
    std::ostringstream message;
    message << quantity << " is " << value << ", need " << range;
    throw InvalidInput(message.str());
  }
}

void
requireOptions(const FramePlacementOptions & o)
{
  require(o.nodesPerSide >= 4 && o.nodesPerSide <= 1000 && o.nodesPerSide % 2 == 0,
          "nodesPerSide",
          o.nodesPerSide,
          "an even number from 4 to 1000");
  require(o.maximumAngle >= 0.0 && o.maximumAngle <= 180.0, "maximumAngle", o.maximumAngle, "0 to 180 degrees");
  require(o.maximumBoost >= 0.0 && o.maximumBoost < 0.5, "maximumBoost", o.maximumBoost, "0 <= boost < 0.5");
  require(o.sharpness > 0.0 && o.sharpness <= 100.0, "sharpness", o.sharpness, "above 0, at most 100");
  require(o.anchor >= 0.0 && std::isfinite(o.anchor), "anchor", o.anchor, "a finite number >= 0");
  require(o.firstStep > 0.0 && o.firstStep <= 1.0, "firstStep", o.firstStep, "above 0, at most 1");
  require(o.smallestStep > 0.0 && o.smallestStep <= o.firstStep, "smallestStep", o.smallestStep, "0 to firstStep");
  require(o.maximumRounds >= 1, "maximumRounds", o.maximumRounds, "at least 1");
}

void
requireInput(const TriangleMesh & surface, const Positions & sphereMap, const FramePlacementOptions & options)
{
  if (surface.vertices.size() != sphereMap.size())
  {
    throw InvalidInput("surface has " + std::to_string(surface.vertices.size()) + " vertices, its sphere map " +
                       std::to_string(sphereMap.size()));
  }
  requireOptions(options);
}

} // namespace

Vector3
placed(const Vector3 & direction, const FramePlacement & placement)
{
  return moebiusBoost((placement.rotation * direction).normalized(), placement.boost).normalized();
}

Vector3
unplaced(const Vector3 & direction, const FramePlacement & placement)
{
  return placement.rotation.transpose() * moebiusBoost(direction.normalized(), -placement.boost).normalized();
}

std::vector<Positions>
placed(const std::vector<Positions> & sphereMaps, const FramePlacement & placement)
{
  std::vector<Positions> result = sphereMaps;
  for (Positions & map : result)
  {
    for (Vector3 & direction : map)
    {
      direction = placed(direction, placement);
    }
  }
  return result;
}

EdgeScore
edgeScore(const TriangleMesh &          surface,
          const Positions &             sphereMap,
          const FramePlacement &        placement,
          const FramePlacementOptions & options)
{
  return edgeScores(surface, sphereMap, { placement }, options).front();
}

std::vector<EdgeScore>
edgeScores(const TriangleMesh &                surface,
           const Positions &                   sphereMap,
           const std::vector<FramePlacement> & placements,
           const FramePlacementOptions &       options)
{
  requireInput(surface, sphereMap, options);
  const EdgeJudge        judge(surface, sphereMap, options);
  std::vector<EdgeScore> scores(placements.size());
  parallelFor(placements.size(), options.threads, [&](std::size_t p) { scores[p] = judge.judge(placements[p]); });
  return scores;
}

FramePlacementResult
placeFrame(const TriangleMesh &          surface,
           const Positions &             sphereMap,
           const FramePlacementOptions & options,
           const ProgressCallback &      progress)
{
  requireInput(surface, sphereMap, options);
  const Stopwatch watch;
  const EdgeJudge judge(surface, sphereMap, options);
  CompassSearch   search(judge, options);
  search.run(progress);

  FramePlacementResult result;
  result.placement = search.best().placement;
  result.before = judge.judge({});
  result.after = search.best().score;
  result.angle = options.maximumAngle * search.best().x.head<3>().norm();
  result.evaluations = search.evaluations();
  result.report = search.report();
  result.report.seconds = watch.seconds();
  result.report.note = result.report.converged ? "" : "the rounds ran out";
  reportProgress(progress, 1.0);
  return result;
}

} // namespace moserhex
