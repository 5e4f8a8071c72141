#include "RawSurfaceBytes.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <cstring>

namespace moserhex
{
namespace
{

struct Counts
{
  std::uint64_t vertices;
  std::uint64_t triangles;
  std::uint64_t splitPolygons;
  std::uint64_t isRas;
};

constexpr std::size_t vertexBytes = 3 * sizeof(double);
constexpr std::size_t triangleBytes = sizeof(Triangle);

[[nodiscard]] bool
isSound(const TriangleMesh & mesh)
{
  const auto isFinite = [](const Vector3 & vertex) { return vertex.allFinite(); };
  const auto count = static_cast<VertexIndex>(mesh.vertices.size());
  const auto isInRange = [count](const Triangle & triangle) {
    return std::all_of(
      triangle.begin(), triangle.end(), [count](VertexIndex vertex) { return vertex >= 0 && vertex < count; });
  };
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), isFinite) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), isInRange);
}

} // namespace

std::string
bytesOf(const RawSurface & surface)
{
  const TriangleMesh & mesh = surface.mesh;
  const Counts         counts{
    mesh.vertices.size(), mesh.triangles.size(), surface.splitPolygons, surface.isRas ? std::uint64_t{ 1 } : 0
  };
  std::string bytes(reinterpret_cast<const char *>(&counts), sizeof counts);
  for (const Vector3 & vertex : mesh.vertices)
  {
    bytes.append(reinterpret_cast<const char *>(vertex.data()), vertexBytes);
  }
  bytes.append(reinterpret_cast<const char *>(mesh.triangles.data()), mesh.triangles.size() * triangleBytes);
  return bytes;
}

RawSurface
rawSurfaceOf(const std::string & fileName, const std::string & bytes)
{
  const auto refuse = [&fileName] {
    throw BadInput(
      ErrorCode::ReaderFailed, fileName, "the process that read it gave no whole surface", exportSurfaceAgain);
  };
  Counts counts{};
  if (bytes.size() < sizeof counts)
  {
    refuse();
  }
  std::memcpy(&counts, bytes.data(), sizeof counts);
  const std::size_t room = bytes.size() - sizeof counts;
  if (counts.vertices > room / vertexBytes || counts.triangles > room / triangleBytes ||
      counts.vertices * vertexBytes + counts.triangles * triangleBytes != room)
  {
    refuse();
  }
  RawSurface surface;
  surface.splitPolygons = static_cast<std::size_t>(counts.splitPolygons);
  surface.isRas = counts.isRas != 0;
  surface.mesh.vertices.resize(static_cast<std::size_t>(counts.vertices));
  const char * next = bytes.data() + sizeof counts;
  for (Vector3 & vertex : surface.mesh.vertices)
  {
    std::memcpy(vertex.data(), next, vertexBytes);
    next += vertexBytes;
  }
  surface.mesh.triangles.resize(static_cast<std::size_t>(counts.triangles));
  for (Triangle & triangle : surface.mesh.triangles)
  {
    std::memcpy(triangle.data(), next, triangleBytes);
    next += triangleBytes;
  }
  if (!isSound(surface.mesh))
  {
    refuse();
  }
  return surface;
}

} // namespace moserhex
