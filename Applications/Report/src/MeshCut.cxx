#include "MeshCut.h"

#include "moserhex/Geometry/HexMeshNumbering.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace moserhex::app
{
namespace
{

/** An edge of a triangle, the smaller node first: all triangles at it find the same point of the plane on it. */
using Edge = std::pair<std::size_t, std::size_t>;
using Segment = std::array<Edge, 2>;

struct CutFace
{
  Quadrilateral      corners{};
  int                shell{ 0 }; ///< of the first cell
  std::optional<int> otherShell; ///< of the second; empty: there is none
};

constexpr std::array<std::array<std::size_t, 4>, 6> facesOfCell{
  { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } }
};

class Cutter
{
public:
  Cutter(const HexMesh & mesh, const CutPlane & plane) : m_Mesh(mesh), m_Plane(plane)
  {}

  [[nodiscard]] MeshCut
  cut() const
  {
    std::vector<Segment>                boundary;
    std::vector<Segment>                inner;
    std::map<int, std::vector<Segment>> shells;
    for (const auto & [key, face] : cutFaces())
    {
      std::vector<Segment> & segments = !face.otherShell ? boundary
                                        : face.shell == *face.otherShell
                                          ? inner
                                          : shells[std::min(face.shell, *face.otherShell)];
      addSegments(face.corners, segments);
    }
    MeshCut result;
    result.boundary = chained(boundary);
    result.inner = chained(inner);
    for (const auto & [shell, segments] : shells)
    {
      result.shells[shell] = chained(segments);
    }
    return result;
  }

private:
  /** Nodes in the plane count as above it, so that no triangle lies in it. */
  [[nodiscard]] bool
  isAbove(std::size_t node) const
  {
    return m_Mesh.nodes[node][m_Plane.axis] >= m_Plane.place;
  }

  /** Faces of the cells that the plane cuts, by their sorted nodes. */
  [[nodiscard]] std::map<Quadrilateral, CutFace>
  cutFaces() const
  {
    const std::vector<int>           shells = shellOfCells(m_Mesh);
    std::map<Quadrilateral, CutFace> faces;
    for (std::size_t cell = 0; cell < m_Mesh.cellCount(); ++cell)
    {
      const auto nodes = m_Mesh.cellNodes(cell);
      const auto above = std::count_if(nodes.begin(), nodes.end(), [this](std::size_t node) { return isAbove(node); });
      if (above == 0 || above == 8)
      {
        continue;
      }
      for (const auto & local : facesOfCell)
      {
        const Quadrilateral corners{ nodes[local[0]], nodes[local[1]], nodes[local[2]], nodes[local[3]] };
        Quadrilateral       key = corners;
        std::sort(key.begin(), key.end());
        const auto [face, isNew] = faces.try_emplace(key, CutFace{ corners, shells[cell], {} });
        if (!isNew)
        {
          face->second.otherShell = shells[cell];
        }
      }
    }
    return faces;
  }

  void
  addSegments(const Quadrilateral & q, std::vector<Segment> & segments) const
  {
    for (const std::array<std::size_t, 3> & triangle :
         { std::array<std::size_t, 3>{ q[0], q[1], q[2] }, std::array<std::size_t, 3>{ q[0], q[2], q[3] } })
    {
      std::vector<Edge> crossed;
      for (std::size_t side = 0; side < 3; ++side)
      {
        const auto [a, b] = std::minmax(triangle[side], triangle[(side + 1) % 3]);
        if (isAbove(a) != isAbove(b))
        {
          crossed.emplace_back(a, b);
        }
      }
      if (crossed.size() == 2)
      {
        segments.push_back({ crossed[0], crossed[1] });
      }
    }
  }

  [[nodiscard]] PlanePoint
  pointOn(const Edge & edge) const
  {
    const Vector3 & a = m_Mesh.nodes[edge.first];
    const Vector3 & b = m_Mesh.nodes[edge.second];
    const double    t = (m_Plane.place - a[m_Plane.axis]) / (b[m_Plane.axis] - a[m_Plane.axis]);
    const Vector3   p = a + t * (b - a);
    const int       first = m_Plane.axis == 0 ? 1 : 0;
    const int       second = m_Plane.axis == 2 ? 1 : 2;
    return { p[first], p[second] };
  }

  [[nodiscard]] std::vector<PlaneLine>
  chained(const std::vector<Segment> & segments) const
  {
    std::map<Edge, std::vector<std::size_t>> segmentsAt;
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      segmentsAt[segments[s][0]].push_back(s);
      segmentsAt[segments[s][1]].push_back(s);
    }
    std::vector<bool> isUsed(segments.size(), false);
    const auto        follow = [&](Edge end, PlaneLine & line) {
      for (bool goesOn = true; goesOn;)
      {
        goesOn = false;
        for (const std::size_t s : segmentsAt.at(end))
        {
          if (!isUsed[s])
          {
            isUsed[s] = true;
            end = segments[s][0] == end ? segments[s][1] : segments[s][0];
            line.push_back(pointOn(end));
            goesOn = true;
            break;
          }
        }
      }
    };
    std::vector<PlaneLine> lines;
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      if (isUsed[s])
      {
        continue;
      }
      isUsed[s] = true;
      PlaneLine line{ pointOn(segments[s][0]), pointOn(segments[s][1]) };
      follow(segments[s][1], line);
      std::reverse(line.begin(), line.end());
      follow(segments[s][0], line);
      lines.push_back(std::move(line));
    }
    return lines;
  }

  const HexMesh & m_Mesh;
  const CutPlane  m_Plane;
};

} // namespace

MeshCut
cutMesh(const HexMesh & mesh, const CutPlane & plane)
{
  return Cutter(mesh, plane).cut();
}

} // namespace moserhex::app
