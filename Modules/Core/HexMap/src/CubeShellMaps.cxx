#include "moserhex/HexMap/CubeShellMaps.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/SphericalMap/AreaPreservingMap.h"
#include "moserhex/StructuredGrid/CubeToSphere.h"

#include <algorithm>
#include <string>

namespace moserhex
{
namespace
{
/** Squares a side below which a cube's surface is too coarse for a triangle map to keep areas. */
constexpr int leastSquares = 24;

/** Numbers of the nodes on the surface of a lattice of (squares + 1)^3 nodes, in lattice order. */
class SurfaceNumbering
{
public:
  explicit SurfaceNumbering(int squares)
    : m_Side(squares + 1)
    , m_Number(static_cast<std::size_t>(m_Side) * static_cast<std::size_t>(m_Side) * static_cast<std::size_t>(m_Side),
               -1)
  {
    for (int k = 0; k < m_Side; ++k)
    {
      for (int j = 0; j < m_Side; ++j)
      {
        for (int i = 0; i < m_Side; ++i)
        {
          if (i == 0 || j == 0 || k == 0 || i == squares || j == squares || k == squares)
          {
            m_Number[index(i, j, k)] = static_cast<VertexIndex>(m_Positions.size());
            m_Positions.emplace_back(2.0 * i / squares - 1.0, 2.0 * j / squares - 1.0, 2.0 * k / squares - 1.0);
          }
        }
      }
    }
  }

  [[nodiscard]] VertexIndex
  number(const std::array<int, 3> & at) const
  {
    return m_Number[index(at[0], at[1], at[2])];
  }

  [[nodiscard]] const Positions &
  positions() const
  {
    return m_Positions;
  }

private:
  [[nodiscard]] std::size_t
  index(int i, int j, int k) const
  {
    const auto n = static_cast<std::size_t>(m_Side);
    return static_cast<std::size_t>(i) + n * (static_cast<std::size_t>(j) + n * static_cast<std::size_t>(k));
  }

  int                      m_Side;
  std::vector<VertexIndex> m_Number;
  Positions                m_Positions;
};

/** Cuts a counter-clockwise quadrilateral into two triangles, along corners 0-2 or 1-3. */
void
appendTriangles(const std::array<VertexIndex, 4> & quad, bool alongFirst, std::vector<Triangle> & triangles)
{
  if (alongFirst)
  {
    triangles.push_back({ quad[0], quad[1], quad[2] });
    triangles.push_back({ quad[0], quad[2], quad[3] });
  }
  else
  {
    triangles.push_back({ quad[0], quad[1], quad[3] });
    triangles.push_back({ quad[1], quad[2], quad[3] });
  }
}
} // namespace

TriangleMesh
cubeSurfaceMesh(int squares)
{
  if (squares < 1)
  {
    throw InvalidInput("squares a side " + std::to_string(squares) + ", must be at least 1");
  }
  const SurfaceNumbering numbering(squares);
  TriangleMesh           mesh;
  mesh.vertices = numbering.positions();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      const auto vertex = [&](int a, int b) {
        std::array<int, 3> at{};
        at[axis] = upper ? squares : 0;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return numbering.number(at);
      };
      for (int b = 0; b < squares; ++b)
      {
        for (int a = 0; a < squares; ++a)
        {
          std::array<VertexIndex, 4> quad{ vertex(a, b), vertex(a + 1, b), vertex(a + 1, b + 1), vertex(a, b + 1) };
          if (!upper)
          {
            std::swap(quad[1], quad[3]);
          }
          const bool towardsCentre = (2 * a < squares - 1) == (2 * b < squares - 1);
          appendTriangles(quad, towardsCentre, mesh.triangles);
        }
      }
    }
  }
  return mesh;
}

namespace
{
Positions
closedFormMap(const CubeLattice & lattice, int shell)
{
  Positions directions;
  for (const std::size_t node : lattice.nodesOfShell(shell))
  {
    directions.push_back(cubeToSphere(lattice.positionOnShell(node)));
  }
  return directions;
}

Positions
conformalMoserMap(const CubeLattice & lattice, int shell, int subdivisions)
{
  const int              quads = 2 * shell - 1;
  const int              parts = subdivisions > 0 ? subdivisions : std::max(1, (leastSquares + quads - 1) / quads);
  const SurfaceNumbering numbering(quads * parts);
  const AreaPreservingMapResult map = areaPreservingSphereMap(cubeSurfaceMesh(quads * parts));

  const int offset = lattice.shells() - shell;
  Positions directions;
  for (const std::size_t node : lattice.nodesOfShell(shell))
  {
    const auto at = lattice.nodeIndex(node);
    const auto vertex =
      numbering.number({ parts * (at[0] - offset), parts * (at[1] - offset), parts * (at[2] - offset) });
    directions.push_back(map.positions[static_cast<std::size_t>(vertex)]);
  }
  return directions;
}
} // namespace

Positions
cubeShellMap(const CubeLattice & lattice, int shell, const CubeShellMapOptions & options)
{
  if (options.subdivisions < 0)
  {
    throw InvalidInput("subdivisions " + std::to_string(options.subdivisions) + ", must be at least 0");
  }
  if (options.method == CubeShellMethod::conformalMoser)
  {
    static_cast<void>(lattice.relativeSize(shell)); // checks the shell number before the surface is built
    return conformalMoserMap(lattice, shell, options.subdivisions);
  }
  return closedFormMap(lattice, shell);
}

} // namespace moserhex
