#include "moserhex/Analytic/SurfaceShapes.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <utility>

namespace moserhex::analytic
{
namespace
{

TriangleMesh
icosahedron()
{
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  mesh.vertices = { { -1, golden, 0 }, { 1, golden, 0 }, { -1, -golden, 0 }, { 1, -golden, 0 },
                    { 0, -1, golden }, { 0, 1, golden }, { 0, -1, -golden }, { 0, 1, -golden },
                    { golden, 0, -1 }, { golden, 0, 1 }, { -golden, 0, -1 }, { -golden, 0, 1 } };
  mesh.triangles = { { 0, 11, 5 },  { 0, 5, 1 },  { 0, 1, 7 },  { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
                     { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 },  { 3, 9, 4 },  { 3, 4, 2 },   { 3, 2, 6 }, { 3, 6, 8 },
                     { 3, 8, 9 },   { 4, 9, 5 },  { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },   { 9, 8, 1 } };
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex.normalize();
  }
  return mesh;
}

/** Splits every triangle into four; new vertices on the unit sphere. */
TriangleMesh
splitOnSphere(const TriangleMesh & mesh)
{
  TriangleMesh                                               fine;
  std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
  fine.vertices = mesh.vertices;
  const auto middle = [&](VertexIndex a, VertexIndex b) {
    const auto [entry, isNew] = middles.insert({ std::minmax(a, b), static_cast<VertexIndex>(fine.vertices.size()) });
    if (isNew)
    {
      const Vector3 sum = fine.vertices[static_cast<std::size_t>(a)] + fine.vertices[static_cast<std::size_t>(b)];
      fine.vertices.push_back(sum.normalized());
    }
    return entry->second;
  };
  for (const auto & [a, b, c] : mesh.triangles)
  {
    const VertexIndex ab = middle(a, b);
    const VertexIndex bc = middle(b, c);
    const VertexIndex ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  return fine;
}

void
requireAtLeast(const char * what, int value, int least)
{
  if (value < least)
  {
    throw InvalidInput(std::string(what) + " = " + std::to_string(value) + ", need >= " + std::to_string(least));
  }
}

} // namespace

TriangleMesh
icosphere(int levels, double radius)
{
  return starShapedSurface(levels, [radius](const Vector3 &) { return radius; });
}

TriangleMesh
ellipsoidSurface(int levels, const Vector3 & semiAxes)
{
  TriangleMesh mesh = icosphere(levels);
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex = vertex.cwiseProduct(semiAxes).eval();
  }
  return mesh;
}

TriangleMesh
starShapedSurface(int levels, const std::function<double(const Vector3 &)> & radius)
{
  requireAtLeast("icosphere: levels", levels, 0);
  TriangleMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level)
  {
    mesh = splitOnSphere(mesh);
  }
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex *= radius(vertex);
  }
  return mesh;
}

TriangleMesh
cubeSurface(int divisions, double side)
{
  requireAtLeast("cubeSurface: divisions", divisions, 1);
  TriangleMesh                              mesh;
  std::map<std::array<int, 3>, VertexIndex> numbers;
  const auto                                vertex = [&](const std::array<int, 3> & index) {
    const auto [entry, isNew] = numbers.insert({ index, static_cast<VertexIndex>(mesh.vertices.size()) });
    if (isNew)
    {
      const Vector3 unit = Vector3(index[0], index[1], index[2]) / divisions - Vector3::Constant(0.5);
      mesh.vertices.push_back(side * unit);
    }
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto w = static_cast<std::size_t>(axis);
    const auto u = static_cast<std::size_t>((axis + 1) % 3);
    const auto v = static_cast<std::size_t>((axis + 2) % 3);
    for (const bool upper : { false, true })
    {
      for (int j = 0; j < divisions; ++j)
      {
        for (int i = 0; i < divisions; ++i)
        {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> index{};
            index[u] = i + di;
            index[v] = j + dj;
            index[w] = upper ? divisions : 0;
            return vertex(index);
          };
          const VertexIndex a = corner(0, 0);
          const VertexIndex b = upper ? corner(1, 0) : corner(0, 1);
          const VertexIndex c = corner(1, 1);
          const VertexIndex d = upper ? corner(0, 1) : corner(1, 0);
          mesh.triangles.push_back({ a, b, c });
          mesh.triangles.push_back({ a, c, d });
        }
      }
    }
  }
  return mesh;
}

TriangleMesh
torusSurface(int ringDivisions, int tubeDivisions, double ringRadius, double tubeRadius)
{
  requireAtLeast("torusSurface: ringDivisions", ringDivisions, 3);
  requireAtLeast("torusSurface: tubeDivisions", tubeDivisions, 3);
  TriangleMesh mesh;
  for (int i = 0; i < ringDivisions; ++i)
  {
    const double ring = 2.0 * pi * i / ringDivisions;
    for (int j = 0; j < tubeDivisions; ++j)
    {
      const double tube = 2.0 * pi * j / tubeDivisions;
      const double distance = ringRadius + tubeRadius * std::cos(tube);
      mesh.vertices.emplace_back(distance * std::cos(ring), distance * std::sin(ring), tubeRadius * std::sin(tube));
    }
  }
  const auto vertex = [&](int i, int j) {
    return static_cast<VertexIndex>((i % ringDivisions) * tubeDivisions + j % tubeDivisions);
  };
  for (int i = 0; i < ringDivisions; ++i)
  {
    for (int j = 0; j < tubeDivisions; ++j)
    {
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
    }
  }
  return mesh;
}

TriangleMesh
renumbered(const TriangleMesh & mesh, std::uint64_t seed)
{
  Random     random(seed);
  const auto permutation = [&random](std::size_t count) {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      order[i] = i;
    }
    for (std::size_t i = count; i > 1; --i)
    {
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.next() % i)]);
    }
    return order;
  };
  const std::vector<std::size_t> newNumber = permutation(mesh.vertices.size());
  const std::vector<std::size_t> order = permutation(mesh.triangles.size());
  TriangleMesh                   result;
  result.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
  {
    result.vertices[newNumber[v]] = mesh.vertices[v];
  }
  for (const std::size_t f : order)
  {
    Triangle triangle = mesh.triangles[f];
    for (VertexIndex & v : triangle)
    {
      v = static_cast<VertexIndex>(newNumber[static_cast<std::size_t>(v)]);
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

Matrix3
rotation(const Vector3 & axis, double angle)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

} // namespace moserhex::analytic
