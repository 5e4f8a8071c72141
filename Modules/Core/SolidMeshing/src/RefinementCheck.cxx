#include "RefinementCheck.h"

#include "CellShares.h"
#include "TemplateRefiner.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/SolidMeshing/SurfaceAlignment.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace moserhex
{
namespace
{

/** A landmark farther outside than both is not of the organ. */
constexpr double farOutside = 5.0; // [mm]
constexpr double farOutsideInEdges = 2.0;

/** Images are compared inside of cells, deeper than this part of an edge [1]. */
constexpr double depthOfSamples = 0.25;

std::string
nameOf(const CorrespondingPoints & landmark, std::size_t number)
{
  return landmark.name.empty() ? "number " + std::to_string(number + 1) : landmark.name;
}

/** One subject's side of the landmarks. */
struct LandmarkSide
{
  ErrorCode   code;
  std::string organ; ///< as messages call it
};

/** \param outside  distances of the landmarks outside of the organ [mm] \return a warning; empty: none is far away */
std::string
judge(const LandmarkSide &                     side,
      const std::vector<CorrespondingPoints> & landmarks,
      const std::vector<double> &              outside,
      double                                   edge)
{
  const double       farthestAllowed = std::max(farOutside, farOutsideInEdges * edge);
  std::size_t        count = 0;
  std::ostringstream list;
  list << std::fixed << std::setprecision(1);
  for (std::size_t l = 0; l < outside.size(); ++l)
  {
    if (outside[l] > farthestAllowed)
    {
      list << (count++ == 0 ? "" : ", ") << nameOf(landmarks[l], l) << " by " << outside[l] << " mm";
    }
  }
  if (count > 0 && count == outside.size())
  {
    throw InvalidInput(side.code, "all landmarks lie outside of " + side.organ + ": " + list.str());
  }
  return count == 0 ? "" : "landmarks outside of " + side.organ + ": " + list.str();
}

double
edgeOf(const HexMesh & templateMesh, double volume)
{
  return std::cbrt(volume / static_cast<double>(templateMesh.cellCount()));
}

Positions
deepNodes(const LevelSet & phi, double depth)
{
  Positions nodes;
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    if (phi.values[node] < -depth)
    {
      nodes.push_back(phi.grid.point(node));
    }
  }
  return nodes;
}

std::vector<double>
distancesOutside(const std::vector<CorrespondingPoints> & landmarks, const LevelSet & phi)
{
  Positions points;
  for (const CorrespondingPoints & landmark : landmarks)
  {
    points.push_back(landmark.onSolid);
  }
  return signedDistancesToSurface(points, phi); // negative inside: not beyond any bound
}

/** Where cells of the template are uneven, growth would come out as that, turned round.
 * \throws InvalidInput (Template) */
void
requireEqualCells(const HexMesh & templateMesh)
{
  constexpr double equal = 1e-6; // variance of the volumes [1]
  double           squares = 0.0;
  for (const double share : cellShares(templateMesh))
  {
    squares += (share - 1.0) * (share - 1.0);
  }
  const double variance = squares / static_cast<double>(templateMesh.cellCount());
  if (!(variance <= equal))
  {
    std::ostringstream text;
    text << "template: the volumes of its cells differ (variance " << std::setprecision(2) << variance
         << "), so that local growth against it cannot be told; take one of equal cells, without local growth and "
            "density";
    throw InvalidInput(ErrorCode::Template, text.str());
  }
}

} // namespace

std::vector<std::string>
checkRefinement(const HexMesh &            templateMesh,
                const TemplateRefinement & refinement,
                const LevelSet &           phi,
                double                     volume)
{
  std::vector<std::string> warnings;
  if (!refinement.any())
  {
    return warnings;
  }
  if (refinement.localGrowth)
  {
    requireEqualCells(templateMesh);
  }
  const TemplateRefiner refiner(templateMesh, refinement);
  const double          edge = edgeOf(templateMesh, volume);
  if (refinement.images)
  {
    refiner.requireSolidCovered(deepNodes(phi, depthOfSamples * edge));
  }
  for (const std::string & warning : { judge({ ErrorCode::TemplateLandmarks, "the template" },
                                             refinement.landmarks,
                                             refiner.distancesOutside(),
                                             cellEdge(templateMesh)),
                                       judge({ ErrorCode::Landmarks, "the label" },
                                             refinement.landmarks,
                                             distancesOutside(refinement.landmarks, phi),
                                             edge) })
  {
    if (!warning.empty())
    {
      warnings.push_back(warning);
    }
  }
  return warnings;
}

} // namespace moserhex
