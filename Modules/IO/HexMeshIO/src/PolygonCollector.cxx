#include "PolygonCollector.h"

#include "FileText.h"

#include <Eigen/Geometry>

#include <optional>

namespace moserhex
{
namespace
{

constexpr std::size_t mostCorners = 256; // a fan is searched in O(corners^2)

/** Twice the vector area: its direction is the normal. */
Vector3
normalOf(const Positions & polygon)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
  {
    sum += (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
  }
  return sum;
}

/** The smallest component along `normal` of the triangles of the fan from a corner, relative to its length. */
double
worstOfFan(const Positions & polygon, std::size_t apex, const Vector3 & normal)
{
  const std::size_t count = polygon.size();
  double            worst = 1.0;
  for (std::size_t k = 1; k + 1 < count; ++k)
  {
    const Vector3 a = polygon[(apex + k) % count] - polygon[apex];
    const Vector3 b = polygon[(apex + k + 1) % count] - polygon[apex];
    worst = std::min(worst, a.cross(b).dot(normal) / normal.squaredNorm());
  }
  return worst;
}

/** The corner whose fan fills the polygon best, all its triangles facing the same way; none when it is concave from
 * everywhere. A polygon without area is taken as it comes. */
std::optional<std::size_t>
apexOf(const Positions & polygon)
{
  const Vector3 normal = normalOf(polygon);
  if (normal.squaredNorm() == 0.0)
  {
    return 0;
  }
  std::size_t best = 0;
  double      bestWorst = worstOfFan(polygon, 0, normal);
  for (std::size_t apex = 1; apex < polygon.size(); ++apex)
  {
    const double worst = worstOfFan(polygon, apex, normal);
    if (worst > bestWorst)
    {
      best = apex;
      bestWorst = worst;
    }
  }
  return bestWorst >= -1e-9 ? std::optional<std::size_t>(best) : std::nullopt;
}

} // namespace

std::int64_t
vertexNumberOf(const FileText & text, std::string_view word)
{
  std::int64_t number = 0;
  if (!parseNumber(word, number))
  {
    const bool isWhole = !word.empty() && word.find_first_not_of("0123456789", 1) == std::string_view::npos &&
                         word.find_first_of("0123456789") != std::string_view::npos;
    text.refuse(isWhole ? ErrorCode::SurfaceIndex : ErrorCode::Format,
                "'" + std::string(word.substr(0, 20)) + "' where a vertex number is expected");
  }
  return number;
}

void
PolygonCollector::addPolygon(const std::vector<std::int64_t> & corners)
{
  if (corners.size() < 3 || corners.size() > mostCorners)
  {
    throw BadInput(corners.size() < 3 ? ErrorCode::Format : ErrorCode::Unsupported,
                   m_FileName,
                   "face " + std::to_string(m_Ends.size() + 1) + " has " + std::to_string(corners.size()) +
                     " corners, need 3 to " + std::to_string(mostCorners),
                   exportSurfaceAgain);
  }
  m_Corners.insert(m_Corners.end(), corners.begin(), corners.end());
  m_Ends.push_back(m_Corners.size());
}

void
PolygonCollector::requireFinite() const
{
  const Positions & vertices = m_Surface.mesh.vertices;
  for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
  {
    if (!vertices[vertex].allFinite())
    {
      throw BadInput(ErrorCode::SurfaceNaN,
                     m_FileName,
                     "a coordinate of vertex " + std::to_string(static_cast<std::int64_t>(vertex) + m_FirstIndex) +
                       " is NaN or infinite",
                     exportSurfaceAgain);
    }
  }
}

void
PolygonCollector::requireIndices(std::size_t polygon) const
{
  const auto count = static_cast<std::int64_t>(vertexCount());
  for (std::size_t k = polygon == 0 ? 0 : m_Ends[polygon - 1]; k < m_Ends[polygon]; ++k)
  {
    if (m_Corners[k] < 0 || m_Corners[k] >= count)
    {
      throw BadInput(ErrorCode::SurfaceIndex,
                     m_FileName,
                     "face " + std::to_string(polygon + 1) + " names vertex " +
                       std::to_string(m_Corners[k] + m_FirstIndex) + ", need " + std::to_string(m_FirstIndex) + " to " +
                       std::to_string(count - 1 + m_FirstIndex),
                     exportSurfaceAgain);
    }
  }
}

void
PolygonCollector::addTriangles(std::size_t polygon)
{
  const std::size_t begin = polygon == 0 ? 0 : m_Ends[polygon - 1];
  const std::size_t count = m_Ends[polygon] - begin;
  std::size_t       apex = 0;
  if (count > 3)
  {
    Positions corners;
    for (std::size_t k = 0; k < count; ++k)
    {
      corners.push_back(m_Surface.mesh.vertices[static_cast<std::size_t>(m_Corners[begin + k])]);
    }
    const auto found = apexOf(corners);
    if (!found)
    {
      throw BadInput(ErrorCode::Unsupported,
                     m_FileName,
                     "face " + std::to_string(polygon + 1) + " is a concave polygon of " + std::to_string(count) +
                       " corners",
                     "triangulate the surface");
    }
    apex = *found;
    ++m_Surface.splitPolygons;
  }
  const auto corner = [&](std::size_t k) { return static_cast<VertexIndex>(m_Corners[begin + (apex + k) % count]); };
  for (std::size_t k = 1; k + 1 < count; ++k)
  {
    m_Surface.mesh.triangles.push_back({ corner(0), corner(k), corner(k + 1) });
  }
}

RawSurface
PolygonCollector::finish()
{
  if (m_Ends.empty())
  {
    throw BadInput(ErrorCode::Empty,
                   m_FileName,
                   vertexCount() == 0 ? "there are no triangles" : "there are points, but no polygons",
                   "give a closed triangle surface");
  }
  requireFinite();
  m_Surface.mesh.triangles.reserve(m_Ends.size());
  for (std::size_t polygon = 0; polygon < m_Ends.size(); ++polygon)
  {
    requireIndices(polygon);
    addTriangles(polygon);
  }
  return std::move(m_Surface);
}

} // namespace moserhex
