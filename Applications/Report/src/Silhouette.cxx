#include "Silhouette.h"

#include "HtmlText.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr int    picture = 96; ///< squares along a side, with an empty one around the mesh
constexpr double margin = 0.7; ///< a point on the outline may be so far from it when it is left out [squares]
constexpr double begin = 1.02; ///< of the mesh in the picture, of which it fills whole squares [squares]

using Point = std::array<double, 2>;
using Square = std::array<int, 2>;

/** Which squares of a picture the boundary covers. */
class Bitmap
{
public:
  explicit Bitmap(const HexMesh & mesh)
  {
    m_Low = { mesh.nodes.front().x(), mesh.nodes.front().z() };
    Point high = m_Low;
    for (const Vector3 & node : mesh.nodes)
    {
      m_Low = { std::min(m_Low[0], node.x()), std::min(m_Low[1], node.z()) };
      high = { std::max(high[0], node.x()), std::max(high[1], node.z()) };
    }
    m_Side = std::max({ high[0] - m_Low[0], high[1] - m_Low[1], 1e-9 }) / (picture - 2.0 * begin);
    for (const Quadrilateral & quad : boundaryQuads(mesh))
    {
      const auto at = [&](std::size_t corner) { return inSquares(mesh.nodes[quad[corner]]); };
      fill(at(0), at(1), at(2));
      fill(at(0), at(2), at(3));
    }
  }

  [[nodiscard]] bool
  covers(const Square & square) const
  {
    const bool isInside = square[0] >= 0 && square[1] >= 0 && square[0] < picture && square[1] < picture;
    return isInside && m_Covered[place(square)];
  }

  /** Of a corner of squares [mm]. */
  [[nodiscard]] Point
  positionOf(const Point & corner) const
  {
    return { m_Low[0] + (corner[0] - begin) * m_Side, m_Low[1] + (corner[1] - begin) * m_Side };
  }

private:
  static std::size_t
  place(const Square & square)
  {
    return static_cast<std::size_t>(square[0] + picture * square[1]);
  }

  [[nodiscard]] Point
  inSquares(const Vector3 & node) const
  {
    return { (node.x() - m_Low[0]) / m_Side + begin, (node.z() - m_Low[1]) / m_Side + begin };
  }

  void
  fill(const Point & a, const Point & b, const Point & c)
  {
    const auto cross = [](const Point & p, const Point & q, const Point & r) {
      return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    };
    const double area = cross(a, b, c);
    const auto [left, right] = std::minmax({ a[0], b[0], c[0] });
    const auto [bottom, top] = std::minmax({ a[1], b[1], c[1] });
    for (int y = static_cast<int>(bottom); y <= static_cast<int>(top); ++y)
    {
      for (int x = static_cast<int>(left); x <= static_cast<int>(right); ++x)
      {
        const Point p{ x + 0.5, y + 0.5 };
        if (area != 0.0 && cross(a, b, p) * area >= 0.0 && cross(b, c, p) * area >= 0.0 && cross(c, a, p) * area >= 0.0)
        {
          m_Covered[place({ x, y })] = true;
        }
      }
    }
  }

  Point                               m_Low{};
  double                              m_Side{ 1.0 }; ///< of a square [mm]
  std::array<bool, picture * picture> m_Covered{};
};

/** Empty where no square is covered. Corners of the squares around the covered ones, which lie on the left; from the
 * lowest one on. */
std::vector<Point>
outlineOf(const Bitmap & bitmap)
{
  Square start{ 0, 0 };
  while (!bitmap.covers(start))
  {
    if (start[1] == picture)
    {
      return {};
    }
    start = start[0] + 1 < picture ? Square{ start[0] + 1, start[1] } : Square{ 0, start[1] + 1 };
  }
  static constexpr std::array<Square, 4> steps{ { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } } };
  std::vector<Point>                     corners;
  Square                                 corner = start;
  std::size_t                            direction = 0;
  do
  {
    corners.push_back({ static_cast<double>(corner[0]), static_cast<double>(corner[1]) });
    corner = { corner[0] + steps[direction][0], corner[1] + steps[direction][1] };
    // The squares ahead, on the left and on the right of the way.
    const auto ahead = [&](std::size_t turn) {
      static constexpr std::array<Square, 4> squares{ { { 0, 0 }, { -1, 0 }, { -1, -1 }, { 0, -1 } } };
      const Square &                         offset = squares[(direction + turn) % 4];
      return bitmap.covers({ corner[0] + offset[0], corner[1] + offset[1] });
    };
    if (ahead(3))
    {
      direction = (direction + 3) % 4;
    }
    else if (!ahead(0))
    {
      direction = (direction + 1) % 4;
    }
  } while (corner != start || direction != 0);
  return corners;
}

/** Douglas and Peucker: keeps the corners between first and last that are far from the line. */
void
keepFar(const std::vector<Point> & corners, std::size_t first, std::size_t last, std::vector<bool> & isKept)
{
  const Eigen::Vector2d a(corners[first][0], corners[first][1]);
  const Eigen::Vector2d along = Eigen::Vector2d(corners[last][0], corners[last][1]) - a;
  double                farthest = margin;
  std::size_t           at = first;
  for (std::size_t c = first + 1; c < last; ++c)
  {
    const Eigen::Vector2d to = Eigen::Vector2d(corners[c][0], corners[c][1]) - a;
    const double          distance =
      along.norm() > 0.0 ? std::abs(along.x() * to.y() - along.y() * to.x()) / along.norm() : to.norm();
    if (distance > farthest)
    {
      farthest = distance;
      at = c;
    }
  }
  if (at != first)
  {
    isKept[at] = true;
    keepFar(corners, first, at, isKept);
    keepFar(corners, at, last, isKept);
  }
}

} // namespace

std::string
silhouette(const HexMesh & mesh)
{
  const Bitmap             bitmap(mesh);
  const std::vector<Point> corners = outlineOf(bitmap);
  if (corners.empty())
  {
    return "";
  }
  std::vector<bool> isKept(corners.size(), false);
  isKept.front() = isKept.back() = true;
  keepFar(corners, 0, corners.size() - 1, isKept);
  std::string text;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    if (isKept[c])
    {
      const Point position = bitmap.positionOf(corners[c]);
      text += (text.empty() ? "" : " ") + fixedNumber(position[0], 1) + "," + fixedNumber(position[1], 1);
    }
  }
  return text;
}

} // namespace moserhex::app
