#include "TemplateRefiner.h"

#include "SmoothedImage.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Geometry/QuadFans.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>

namespace moserhex
{
namespace
{

/** An image draws over about the width it was smoothed with: the widest scale decides how far off a start may be, and
 * what each leaves is within reach of the next. The sharpest is as wide as samples are apart, two along a cell: finer
 * detail would fall between them. */
const std::vector<double> imageScales{ 2.0, 1.0, 0.5 };

/** An image that varies less than this part of its mean does not vary [1]. */
constexpr double roundingOfValues = 1e-9;

LatticeLandmark
inside(const HexMesh & mesh, const CubePlace & place)
{
  // VTK order: the two upper corners of each face are swapped against the bits (i, j, k).
  static constexpr std::array<std::array<int, 3>, 8> corners{
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } }
  };
  LatticeLandmark landmark;
  landmark.nodes = mesh.cellNodes(place.cell);
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = place.local[axis];
      weight *= corners[corner][static_cast<std::size_t>(axis)] == 1 ? at : 1.0 - at;
    }
    landmark.weights[corner] = weight;
  }
  return landmark;
}

/** Where it is in a mesh [mm]. */
Vector3
placeOf(const LatticeLandmark & landmark, const HexMesh & mesh)
{
  Vector3 place = Vector3::Zero();
  for (std::size_t a = 0; a < landmark.nodes.size(); ++a)
  {
    place += landmark.weights[a] * mesh.nodes[landmark.nodes[a]];
  }
  return place;
}

/** The boundary as four triangles around the centre of every quadrilateral. */
class BoundaryPlaces
{
public:
  explicit BoundaryPlaces(const HexMesh & mesh)
    : m_Quads(boundaryQuads(mesh)), m_Search(quadFans(m_Quads, [&mesh](std::size_t node) { return mesh.nodes[node]; }))
  {}

  [[nodiscard]] LatticeLandmark
  nearest(const Vector3 & p) const
  {
    const ClosestPointOnSurface found = m_Search.closest(p);
    const auto                  triangle = static_cast<std::size_t>(found.triangle);
    const Quadrilateral &       quad = m_Quads[triangle / 4];
    LatticeLandmark             landmark;
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      landmark.nodes[corner] = quad[corner];
      landmark.weights[corner] = 0.25 * found.barycentric[2];
    }
    landmark.weights[triangle % 4] += found.barycentric[0];
    landmark.weights[(triangle + 1) % 4] += found.barycentric[1];
    return landmark;
  }

private:
  std::vector<Quadrilateral> m_Quads;
  ClosestPointSearch         m_Search;
};

/** One subject's image. */
struct ImageSide
{
  ErrorCode    code;
  const char * name; ///< as messages call it
};

constexpr ImageSide templateSide{ ErrorCode::TemplateImage, "image of the template" };
constexpr ImageSide solidSide{ ErrorCode::Image, "image" };

void
requireCovered(const ScalarVolume & image, const Positions & points, const ImageSide & side)
{
  const Vector3 last(image.size[0] - 0.5, image.size[1] - 0.5, image.size[2] - 0.5);
  std::size_t   outside = 0;
  for (const Vector3 & point : points)
  {
    const Vector3 index = image.continuousIndex(point);
    outside += (index.array() < -0.5).any() || (index.array() > last.array()).any() ? 1 : 0;
  }
  if (outside > 0)
  {
    throw InvalidInput(side.code,
                       std::string(side.name) + ": " + std::to_string(outside) + " of " +
                         std::to_string(points.size()) + " places of the organ lie outside of it");
  }
}

/** The levels of an image's darkest and brightest tissues: unlike mean and deviation they do not depend on how much of
 * the organ these fill, so that what has grown or shrunk keeps its grey value. */
struct GreyLevels
{
  double dark{ 0.0 };
  double bright{ 0.0 };

  [[nodiscard]] double
  middle() const
  {
    return 0.5 * (dark + bright);
  }

  [[nodiscard]] double
  range() const
  {
    return bright - dark;
  }
};

/** Quantiles at both ends. \param values  of the samples, as many as there are */
GreyLevels
greyLevelsOf(std::vector<double> values)
{
  constexpr double share = 0.005; // of the samples that may lie beyond either level: noise, vessels
  const auto       at = [&values](double part) {
    const auto nth = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  const double dark = at(share);
  return { dark, at(1.0 - share) };
}

/** An image at the samples, its levels there and its standard deviation. */
struct SampledImage
{
  std::shared_ptr<const SmoothedImage> image;
  std::vector<double>                  values;
  GreyLevels                           levels;
  double                               deviation{ 0.0 };
};

SampledImage
sampled(const ScalarVolume & image, const HexMesh & mesh, double scale, const ImageSide & side)
{
  const Positions points = latticeSamples(mesh);
  requireCovered(image, points, side);
  SampledImage result;
  result.image = std::make_shared<const SmoothedImage>(image, points, scale * cellEdge(mesh));
  double mean = 0.0;
  for (const Vector3 & point : points)
  {
    result.values.push_back(result.image->at(point).value);
    mean += result.values.back() / static_cast<double>(points.size());
  }
  for (const double value : result.values)
  {
    result.deviation += std::pow(value - mean, 2) / static_cast<double>(points.size());
  }
  result.deviation = std::sqrt(result.deviation);
  result.levels = greyLevelsOf(result.values);
  if (!(result.deviation > roundingOfValues * std::abs(mean) && result.levels.range() > 0.0))
  {
    throw InvalidInput(side.code, std::string(side.name) + ": it is the same everywhere in the organ");
  }
  return result;
}

} // namespace

TemplateRefiner::TemplateRefiner(const HexMesh & templateMesh, const TemplateRefinement & refinement)
  : m_Template(templateMesh), m_Refinement(refinement)
{
  const CubeMap        map(templateMesh);
  const BoundaryPlaces boundary(templateMesh);
  for (const CorrespondingPoints & points : refinement.landmarks)
  {
    if (!points.onTemplate.allFinite() || !points.onSolid.allFinite())
    {
      throw InvalidInput("landmarks: a point is not finite");
    }
    const std::optional<CubePlace> place = map.find(points.onTemplate);
    m_Landmarks.push_back(place ? inside(templateMesh, *place) : boundary.nearest(points.onTemplate));
    m_DistancesOutside.push_back(place ? 0.0 : (placeOf(m_Landmarks.back(), templateMesh) - points.onTemplate).norm());
    m_Landmarks.back().position = points.onSolid;
  }
  if (refinement.images)
  {
    requireCovered(refinement.images->ofTemplate, latticeSamples(templateMesh), templateSide); // a scan may end at it
  }
}

void
TemplateRefiner::requireSolidCovered(const Positions & points) const
{
  requireCovered(m_Refinement.images->ofSolid, points, solidSide);
}

std::vector<double>
TemplateRefiner::scales() const
{
  return m_Refinement.images ? imageScales : std::vector<double>{ 0.0 };
}

LatticeImage
TemplateRefiner::image(const HexMesh & mesh, double scale) const
{
  const SampledImage ofTemplate = sampled(m_Refinement.images->ofTemplate, m_Template, scale, templateSide);
  const SampledImage ofSolid = sampled(m_Refinement.images->ofSolid, mesh, scale, solidSide);
  const double       unit = ofTemplate.deviation;
  LatticeImage       result;
  for (const double value : ofTemplate.values)
  {
    result.values.push_back((value - ofTemplate.levels.middle()) / unit);
  }
  const double gain = ofTemplate.levels.range() / (ofSolid.levels.range() * unit);
  result.image = [ofSolid, gain](const Vector3 & p) {
    ValueAndGradient found = ofSolid.image->at(p);
    found.value = (found.value - ofSolid.levels.middle()) * gain;
    found.gradient *= gain;
    return found;
  };
  return result;
}

double
cellEdge(const HexMesh & mesh)
{
  const std::vector<double> volumes = cellVolumes(mesh);
  const double              sum = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  return std::cbrt(std::abs(sum) / static_cast<double>(volumes.size()));
}

double
landmarkError(const HexMesh & mesh, const std::vector<LatticeLandmark> & landmarks)
{
  double sum = 0.0;
  for (const LatticeLandmark & landmark : landmarks)
  {
    sum += (placeOf(landmark, mesh) - landmark.position).squaredNorm();
  }
  return landmarks.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(landmarks.size()));
}

double
imageDifference(const HexMesh & mesh, const LatticeImage & image)
{
  const Positions samples = latticeSamples(mesh);
  double          sum = 0.0;
  for (std::size_t q = 0; q < samples.size(); ++q)
  {
    sum += std::pow(image.image(samples[q]).value - image.values[q], 2);
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

} // namespace moserhex
