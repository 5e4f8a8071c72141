#include "TemplatePlacement.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/RigidAlignment.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
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
    throw InvalidInput(ErrorCode::Template, "template: its cells have no volume");
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
}

/** Of the boundary as it lies. */
TemplateFit
fitOf(const HexMesh & mesh, const LevelSet & phi)
{
  std::vector<double> distances = signedDistancesToSurface(boundaryPoints(mesh), phi);
  TemplateFit         fit;
  for (double & distance : distances)
  {
    fit.rms += distance * distance / static_cast<double>(distances.size());
    distance = std::abs(distance);
  }
  fit.rms = std::sqrt(fit.rms);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  fit.median = *middle;
  return fit;
}

/** The median distance when the motion nearest to the one given is taken the other way round. */
std::optional<double>
medianOfInverse(const HexMesh & templateMesh, const Positions & nodes, const LevelSet & phi, double volume)
{
  HexMesh mesh = templateMesh;
  try
  {
    mesh.nodes = transformed(templateMesh.nodes, similarityAlignment(templateMesh.nodes, nodes).inverse());
  }
  catch (const InvalidInput &)
  {
    return std::nullopt; // no motion is like it
  }
  scaleToVolume(volume, mesh);
  return fitOf(mesh, phi).median;
}

/** A template beside the solid cannot be tied to it. */
void
requireInSolid(const HexMesh & mesh, const LevelSet & phi, const TemplateFit & fit)
{
  const std::vector<double> distances = signedDistancesToSurface(mesh.nodes, phi);
  if (std::any_of(distances.begin(), distances.end(), [](double distance) { return distance < 0.0; }))
  {
    return;
  }
  std::ostringstream message;
  message << std::setprecision(3) << "template: no node lies in the organ; its surface is " << fit.median << " mm away";
  if (fit.medianOfInverse && *fit.medianOfInverse < fit.median)
  {
    message << ", by the inverse transform " << *fit.medianOfInverse << " mm";
  }
  throw InvalidInput(ErrorCode::Template, message.str());
}

std::string
noteOn(const PlacedTemplate & placed, bool isGiven)
{
  std::ostringstream note;
  if (placed.alignment)
  {
    note << "turned by " << placed.alignment->motion.angle() << " degrees";
  }
  else
  {
    note << (isGiven ? "brought by a given transform" : "taken as it lies");
  }
  note << ", scaled by " << placed.fit.scale << ", surface rms ";
  if (placed.alignment)
  {
    note << placed.alignment->rmsBefore << " -> ";
  }
  note << placed.fit.rms << " mm, median " << placed.fit.median << " mm";
  return note.str();
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
  }
  const double scale = std::cbrt(volume / volumeOf(placed.mesh));
  if (!options.templateNodes && options.templateAlignment != TemplateAlignment::None)
  {
    SurfaceAlignmentOptions alignment;
    alignment.kind = options.templateAlignment == TemplateAlignment::Affine ? SurfaceAlignmentKind::Affine
                                                                            : SurfaceAlignmentKind::Rigid;
    align(phi, volume, alignment, placed);
  }
  scaleToVolume(volume, placed.mesh);
  placed.fit = fitOf(placed.mesh, phi);
  placed.fit.scale = scale;
  if (options.templateNodes)
  {
    placed.fit.medianOfInverse = medianOfInverse(*options.templateMesh, *options.templateNodes, phi, volume);
  }
  requireInSolid(placed.mesh, phi, placed.fit);
  placed.note = noteOn(placed, options.templateNodes.has_value());
  return placed;
}

} // namespace moserhex
