#include "Facets.h"

#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace moserhex::app
{
namespace
{

/** The edges of a VTK_HEXAHEDRON: the four along each axis together, in the order in which they stand around it. */
constexpr std::size_t edgeCorners[12][2] = { { 0, 1 }, { 3, 2 }, { 7, 6 }, { 4, 5 }, { 0, 3 }, { 1, 2 },
                                             { 5, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };

constexpr double lightAtRightAngles = 0.7;

double
lightOn(const Vector3 & normal, const Camera & camera)
{
  const Vector3 lamp = (camera.towards + 0.5 * camera.up - 0.4 * camera.right).normalized();
  return lightAtRightAngles + (1.0 - lightAtRightAngles) * std::max(0.0, normal.normalized().dot(lamp));
}

/** Twice the area of a polygon, negative when it is clockwise. */
double
doubleArea(const std::vector<Point2> & outline)
{
  double area = 0.0;
  for (std::size_t corner = 0; corner < outline.size(); ++corner)
  {
    const Point2 & a = outline[corner];
    const Point2 & b = outline[(corner + 1) % outline.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

template <typename TCorners>
SeenFacet
seen(const TCorners & corners, std::size_t cell, const Camera & camera)
{
  SeenFacet facet;
  facet.cell = cell;
  for (const Vector3 & corner : corners)
  {
    facet.outline.push_back(camera.place(corner));
    facet.nearness.push_back(camera.nearness(corner));
  }
  return facet;
}

/** What looks at the viewer of a face that is two triangles with the diagonal 0-2: all of it, one triangle or nothing.
 * So a warped face that is seen from its edge leaves no hole to what is behind it. */
SeenFacet
partTowardsViewer(const SeenFacet & face)
{
  const auto triangle = [&face](std::size_t second) {
    SeenFacet                        part{ face };
    const std::array<std::size_t, 3> corners{ { 0, second, second + 1 } };
    part.outline.clear();
    part.nearness.clear();
    for (const std::size_t corner : corners)
    {
      part.outline.push_back(face.outline[corner]);
      part.nearness.push_back(face.nearness[corner]);
    }
    return part;
  };
  SeenFacet    before = triangle(1);
  SeenFacet    behind = triangle(2);
  const double areaBefore = doubleArea(before.outline);
  const double areaBehind = doubleArea(behind.outline);
  if (areaBefore >= 0.0 && areaBehind >= 0.0)
  {
    return face;
  }
  return areaBefore > areaBehind ? before : behind;
}

/** Corners in the order of their angle around their mean, as the viewer sees them. */
void
sortByAngle(std::vector<Vector3> & corners, const Camera & camera)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & corner : corners)
  {
    sum += corner;
  }
  const Point2 middle = camera.place(sum / static_cast<double>(corners.size()));
  std::stable_sort(corners.begin(), corners.end(), [&](const Vector3 & a, const Vector3 & b) {
    const Point2 p = camera.place(a) - middle;
    const Point2 q = camera.place(b) - middle;
    return std::atan2(p[1], p[0]) < std::atan2(q[1], q[0]);
  });
}

} // namespace

std::vector<SeenFacet>
facesSeen(const UnstructuredHexMesh & mesh, const std::vector<std::size_t> & cells, const Camera & camera)
{
  std::vector<SeenFacet> facets;
  for (const BoundaryFace & face : boundaryFacesOf(mesh, cells))
  {
    std::array<Vector3, 4> corners;
    std::transform(
      face.nodes.begin(), face.nodes.end(), corners.begin(), [&mesh](std::size_t node) { return mesh.nodes[node]; });
    SeenFacet facet = partTowardsViewer(seen(corners, face.cell, camera));
    if (doubleArea(facet.outline) > 0.0)
    {
      facet.light = lightOn((corners[2] - corners[0]).cross(corners[3] - corners[1]), camera);
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

std::vector<SeenFacet>
sectionsSeen(const UnstructuredHexMesh & mesh, int axis, double position, const Camera & camera)
{
  std::vector<SeenFacet> facets;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const HexCorners     corners = cellCorners(mesh, cell);
    std::vector<Vector3> section;
    for (const auto & edge : edgeCorners)
    {
      const double before = corners[edge[0]][axis] - position;
      const double after = corners[edge[1]][axis] - position;
      if ((before < 0.0) != (after < 0.0))
      {
        section.push_back(corners[edge[0]] + before / (before - after) * (corners[edge[1]] - corners[edge[0]]));
      }
    }
    if (section.size() >= 3)
    {
      sortByAngle(section, camera);
      facets.push_back(seen(section, cell, camera));
    }
  }
  return facets;
}

std::vector<SeenFacet>
layerSeen(const HexMesh & lattice, int axis, int index, const Camera & camera)
{
  const int m = lattice.nodesPerSide - 1;
  if (index < 0 || index >= m)
  {
    throw InvalidInput("layer " + std::to_string(index) + " of cells is not there; they go from 0 to " +
                       std::to_string(m - 1));
  }
  std::vector<SeenFacet> facets;
  for (int second = 0; second < m; ++second)
  {
    for (int first = 0; first < m; ++first)
    {
      const std::array<std::array<int, 3>, 3> places{
        { { index, first, second }, { first, index, second }, { first, second, index } }
      };
      const std::array<int, 3> & at = places[static_cast<std::size_t>(axis)];
      const auto                 cell = static_cast<std::size_t>(at[0] + m * (at[1] + m * at[2]));
      const HexCorners           corners = cellCorners(lattice, cell);
      std::vector<Vector3>       middles;
      for (std::size_t edge = 0; edge < 4; ++edge)
      {
        const auto & ends = edgeCorners[4 * static_cast<std::size_t>(axis) + edge];
        middles.push_back(0.5 * (corners[ends[0]] + corners[ends[1]]));
      }
      SeenFacet     facet = seen(middles, cell, camera);
      const Vector3 normal = (middles[2] - middles[0]).cross(middles[3] - middles[1]);
      facet.light = lightOn(camera.nearness(normal) < 0.0 ? Vector3(-normal) : normal, camera);
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

Positions
cellPlaces(const HexMesh & lattice)
{
  const int m = lattice.nodesPerSide - 1;
  Positions places;
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        places.emplace_back((i + 0.5) / m, (j + 0.5) / m, (k + 0.5) / m);
      }
    }
  }
  for (std::size_t cell = lattice.latticeCellCount(); cell < lattice.cellCount(); ++cell)
  {
    const PillowCell pillow = pillowCell(lattice, cell);
    Vector3          place;
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] =
        axis == pillow.axis ? (pillow.last ? 1.0 : 0.0) : (pillow.quad[static_cast<std::size_t>(axis)] + 0.5) / m;
    }
    places.push_back(place);
  }
  return places;
}

std::vector<std::size_t>
withoutNearestOctant(const std::vector<std::size_t> & cells, const Positions & places, const Camera & camera)
{
  constexpr double         rounding = 1e-9;
  std::vector<std::size_t> left;
  for (const std::size_t cell : cells)
  {
    bool isNear = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double fromMiddle = places[cell][axis] - 0.5;
      isNear = isNear && (camera.towards[axis] < 0.0 ? -fromMiddle : fromMiddle) > rounding;
    }
    if (!isNear)
    {
      left.push_back(cell);
    }
  }
  return left;
}

} // namespace moserhex::app
