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

void
putArrays(ParcelWriter & parcel, const std::vector<NamedArray> & arrays)
{
  parcel.put(static_cast<std::uint64_t>(arrays.size()));
  for (const NamedArray & array : arrays)
  {
    parcel.put(array.name);
    parcel.put(array.components);
    parcel.put(array.values);
  }
}

/** \param count  of cells or nodes, or 1 \throws std::out_of_range  too short, or an array that does not fit the count
 */
std::vector<NamedArray>
takeArrays(ParcelReader & parcel, std::size_t count)
{
  std::vector<NamedArray> arrays;
  for (auto left = parcel.number<std::uint64_t>(); left > 0; --left)
  {
    NamedArray array;
    array.name = parcel.text();
    array.components = parcel.number<int>();
    array.values = parcel.rows<double>();
    if (array.components < 1 || array.values.size() != count * static_cast<std::size_t>(array.components))
    {
      throw std::out_of_range("an array of another length");
    }
    arrays.push_back(std::move(array));
  }
  return arrays;
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
  putArrays(parcel, file.arrays.ofCells);
  putArrays(parcel, file.arrays.ofNodes);
  putArrays(parcel, file.meshArrays);
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
    file.arrays.ofCells = takeArrays(parcel, file.mesh.cells.size());
    file.arrays.ofNodes = takeArrays(parcel, file.mesh.nodes.size());
    file.meshArrays = takeArrays(parcel, 1);
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
