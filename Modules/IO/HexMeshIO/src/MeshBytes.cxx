#include "MeshBytes.h"

#include "Parcel.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace moserhex
{
namespace
{

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

[[noreturn]] void
refuse(const std::string & fileName, const char * what, const char * remedy)
{
  throw BadInput(
    ErrorCode::ReaderFailed, fileName, std::string("the process that read it gave no whole ") + what, remedy);
}

} // namespace

SandboxLimits
meshReadingLimits(const std::string & fileName)
{
  std::error_code     error;
  const std::uint64_t fileBytes = std::filesystem::file_size(fileName, error);
  SandboxLimits       limits;
  limits.memoryBytes = (std::uint64_t{ 1 } << 30) + (error ? 0 : 64 * fileBytes);
  return limits;
}

std::string
bytesOf(const RawSurface & surface)
{
  ParcelWriter parcel({});
  parcel.put(surface.mesh.vertices);
  parcel.put(surface.mesh.triangles);
  parcel.put(std::uint64_t{ surface.splitPolygons });
  parcel.put(surface.isRas);
  return parcel.take();
}

RawSurface
rawSurfaceOf(const std::string & fileName, const std::string & bytes)
{
  try
  {
    RawSurface   surface;
    ParcelReader parcel(bytes, 0);
    surface.mesh.vertices = parcel.positions();
    surface.mesh.triangles = parcel.rows<Triangle>();
    surface.splitPolygons = static_cast<std::size_t>(parcel.number<std::uint64_t>());
    surface.isRas = parcel.number<char>() != 0;
    if (parcel.atEnd() && isSound(surface.mesh))
    {
      return surface;
    }
  }
  catch (const std::out_of_range &)
  {
    // Refused below.
  }
  refuse(fileName, "surface", exportSurfaceAgain);
}

std::string
bytesOf(const HexCellFile & file)
{
  ParcelWriter parcel({});
  parcel.put(file.mesh.nodes);
  parcel.put(file.mesh.cells);
  parcel.put(file.warnings);
  return parcel.take();
}

HexCellFile
hexCellFileOf(const std::string & fileName, const std::string & bytes)
{
  try
  {
    HexCellFile  file;
    ParcelReader parcel(bytes, 0);
    file.mesh.nodes = parcel.positions();
    file.mesh.cells = parcel.rows<std::array<std::size_t, 8>>();
    file.warnings = parcel.texts();
    requireValid(file.mesh);
    if (parcel.atEnd())
    {
      return file;
    }
  }
  catch (const std::out_of_range &)
  {
    // Refused below, like the next.
  }
  catch (const InvalidInput &)
  {}
  refuse(fileName, "mesh", "write the mesh again");
}

} // namespace moserhex
