#include "TemplatePlacement.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{

/** Of the two volumes, for a template that is also aligned in its own size [1]. */
constexpr double largestRatio = 1.25;
/** Its own size counts if the median of the surfaces' distances falls below this part [1]. */
constexpr double muchNearer = 0.8;

double
volumeOf(const HexMesh & mesh)
{
  const std::vector<double> cells = cellVolumes(mesh);
  const double              volume = std::accumulate(cells.begin(), cells.end(), 0.0);
  if (!(volume > 0.0))
  {
    throw InvalidInput("template: its cells have no volume");
  }
  return volume;
}

/** About the nodes' middle. */
void
scaleToVolume(double volume, HexMesh & mesh)
{
  Vector3 middle = Vector3::Zero();
  for (const Vector3 & node : mesh.nodes)
  {
    middle += node / static_cast<double>(mesh.nodes.size());
  }
  const double scale = std::cbrt(volume / volumeOf(mesh));
  for (Vector3 & node : mesh.nodes)
  {
    node = middle + scale * (node - middle);
  }
}

SurfaceAlignmentResult
align(const LevelSet & phi, const SurfaceAlignmentOptions & options, HexMesh & mesh)
{
  SurfaceAlignmentResult result = alignToSurface(boundaryPoints(mesh), phi, options);
  for (Vector3 & node : mesh.nodes)
  {
    node = result.motion(node);
  }
  return result;
}

/** In the solid's size or in its own. */
void
align(const LevelSet & phi, double volume, const SurfaceAlignmentOptions & options, PlacedTemplate & placed)
{
  PlacedTemplate inOwnSize = placed;
  const double   ratio = volume / volumeOf(placed.mesh);
  scaleToVolume(volume, placed.mesh);
  placed.alignment = align(phi, options, placed.mesh);
  if (std::max(ratio, 1.0 / ratio) <= largestRatio)
  {
    inOwnSize.alignment = align(phi, options, inOwnSize.mesh);
    if (inOwnSize.alignment->medianAfter < muchNearer * placed.alignment->medianAfter)
    {
      placed = std::move(inOwnSize);
    }
  }
  std::ostringstream note;
  note << "turned by " << placed.alignment->motion.angle() << " degrees, surface rms " << placed.alignment->rmsBefore
       << " -> " << placed.alignment->rmsAfter << " mm";
  placed.note = note.str();
}

} // namespace

PlacedTemplate
placeTemplate(const SolidMeshingOptions & options, const LevelSet & phi, double volume)
{
  PlacedTemplate placed;
  placed.mesh = *options.templateMesh;
  if (options.templateNodes)
  {
    placed.mesh.nodes = *options.templateNodes;
    placed.note = "brought by a given transform";
  }
  else if (options.templateAlignment != TemplateAlignment::None)
  {
    SurfaceAlignmentOptions alignment;
    alignment.kind = options.templateAlignment == TemplateAlignment::Affine ? SurfaceAlignmentKind::Affine
                                                                            : SurfaceAlignmentKind::Rigid;
    align(phi, volume, alignment, placed);
  }
  scaleToVolume(volume, placed.mesh);
  return placed;
}

} // namespace moserhex
