#include "moserhex/HexMeshIO/SurfaceReader.h"

#include "FileNames.h"
#include "ImageFileCheck.h"
#include "ImageHeader.h"
#include "LegacyVtkCheck.h"
#include "OffReader.h"
#include "PlyReader.h"
#include "VtkMessages.h"
#include "VtkSpace.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace moserhex
{
namespace
{

struct FileSurface
{
  TriangleMesh mesh;
  bool         isRas{ false };
};

TriangleMesh
trianglesOf(const std::string & fileName, vtkPolyData & data)
{
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
  {
    data.GetPoint(static_cast<vtkIdType>(vertex), mesh.vertices[vertex].data());
  }
  if (data.GetStrips() && data.GetStrips()->GetNumberOfCells() > 0)
  {
    throw BadInput(ErrorCode::Unsupported, fileName, "triangle strips, need triangles", "triangulate the surface");
  }
  vtkNew<vtkIdList> corners;
  vtkCellArray *    polygons = data.GetPolys();
  for (vtkIdType cell = 0; polygons && cell < polygons->GetNumberOfCells(); ++cell)
  {
    polygons->GetCellAtId(cell, corners);
    if (corners->GetNumberOfIds() != 3)
    {
      throw BadInput(ErrorCode::Unsupported,
                     fileName,
                     "a polygon with " + std::to_string(corners->GetNumberOfIds()) + " corners, need triangles",
                     "triangulate the surface");
    }
    Triangle triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      triangle[corner] = static_cast<VertexIndex>(corners->GetId(static_cast<vtkIdType>(corner)));
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

template <typename TReader>
FileSurface
readWith(const std::string & fileName)
{
  const VtkMessages messages;
  vtkNew<TReader>   reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || !messages.firstError().empty())
  {
    throw BadInput(ErrorCode::Format,
                   fileName,
                   "not a readable surface (" + messages.firstError() + ")",
                   "export the surface again");
  }
  FileSurface surface;
  surface.mesh = trianglesOf(fileName, *reader->GetOutput());
  if constexpr (std::is_same_v<TReader, vtkPolyDataReader> || std::is_same_v<TReader, vtkSTLReader>)
  {
    surface.isRas = saysRas(reader->GetHeader());
  }
  else
  {
    surface.isRas = saysRas(reader->GetOutput()->GetFieldData());
  }
  return surface;
}

/** A binary STL file has 84 + 50 n bytes; VTK's reader takes what is there. */
void
requireWholeStl(const std::string & fileName)
{
  std::ifstream          file(fileName, std::ios::binary);
  std::array<char, 1000> begin{};
  const std::uint64_t    size = std::filesystem::file_size(fileName);
  const auto             count = static_cast<std::size_t>(file.read(begin.data(), begin.size()).gcount());
  if (lowerCase(std::string(begin.data(), count)).find("facet") != std::string::npos)
  {
    return; // text
  }
  std::uint64_t triangles = 0;
  for (std::size_t byte = 4; byte-- > 0;)
  {
    triangles = 256 * triangles + static_cast<unsigned char>(begin[80 + byte]);
  }
  if (count < 84 || size != 84 + 50 * triangles)
  {
    throw BadInput(ErrorCode::Truncated,
                   fileName,
                   std::to_string(size) + " bytes do not fit the " + std::to_string(triangles) + " triangles promised",
                   copyAgain);
  }
}

FileSurface
readFile(const std::string & fileName)
{
  requireReadableFile(fileName);
  if (endsWith(fileName, ".vtk"))
  {
    requireHonestCounts(fileName);
    return readWith<vtkPolyDataReader>(fileName);
  }
  if (endsWith(fileName, ".vtp"))
  {
    return readWith<vtkXMLPolyDataReader>(fileName);
  }
  if (endsWith(fileName, ".stl"))
  {
    requireWholeStl(fileName);
    return readWith<vtkSTLReader>(fileName);
  }
  if (endsWith(fileName, ".obj"))
  {
    return readWith<vtkOBJReader>(fileName);
  }
  if (endsWith(fileName, ".ply"))
  {
    return { readPly(fileName), false };
  }
  if (endsWith(fileName, ".off"))
  {
    return { readOff(fileName), false };
  }
  throw BadInput(
    ErrorCode::Format, fileName, "not a surface's name", "give a .vtk, .vtp, .stl, .obj, .ply or .off file");
}

void
requireSaneNumbers(const std::string & fileName, const TriangleMesh & mesh)
{
  if (mesh.triangles.empty())
  {
    throw BadInput(ErrorCode::Empty, fileName, "there are no triangles", "give a closed triangle surface");
  }
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
  {
    if (!(mesh.vertices[vertex].array().abs() <= 1e6).all())
    {
      throw BadInput(ErrorCode::SurfaceNaN,
                     fileName,
                     "vertex " + std::to_string(vertex) + " is not finite or beyond 1e6 mm",
                     "export the surface again, in millimetres");
    }
  }
  const auto count = static_cast<VertexIndex>(mesh.vertices.size());
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle)
  {
    for (const VertexIndex vertex : mesh.triangles[triangle])
    {
      if (vertex < 0 || vertex >= count)
      {
        throw BadInput(ErrorCode::SurfaceIndex,
                       fileName,
                       "triangle " + std::to_string(triangle) + " names vertex " + std::to_string(vertex) + " of " +
                         std::to_string(count),
                       "export the surface again");
      }
    }
  }
}

/** Vertices with equal coordinates become one, in order of first use; triangles that lose a side go. */
TriangleMesh
withMergedVertices(const TriangleMesh & mesh)
{
  const auto less = [&mesh](std::size_t a, std::size_t b) {
    const Vector3 & p = mesh.vertices[a];
    const Vector3 & q = mesh.vertices[b];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::vector<std::size_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(), less);
  std::vector<std::size_t> representative(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && !less(order[i - 1], order[i]);
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
  }

  TriangleMesh             merged;
  std::vector<VertexIndex> newNumber(mesh.vertices.size(), -1);
  for (const Triangle & triangle : mesh.triangles)
  {
    std::array<std::size_t, 3> corner{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      corner[i] = representative[static_cast<std::size_t>(triangle[i])];
    }
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
    {
      continue;
    }
    Triangle renumbered{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (newNumber[corner[i]] < 0)
      {
        newNumber[corner[i]] = static_cast<VertexIndex>(merged.vertices.size());
        merged.vertices.push_back(mesh.vertices[corner[i]]);
      }
      renumbered[i] = newNumber[corner[i]];
    }
    merged.triangles.push_back(renumbered);
  }
  return merged;
}

void
requireClosed(const std::string & fileName, const TriangleMesh & mesh)
{
  const SurfaceTopologySummary summary = summarizeTopology(mesh);
  if (summary.boundaryEdges > 0)
  {
    throw BadInput(ErrorCode::SurfaceOpen,
                   fileName,
                   "the surface is open (" + std::to_string(summary.boundaryEdges) + " edges with one triangle)",
                   "close its holes");
  }
  if (summary.nonManifoldEdges > 0)
  {
    throw BadInput(ErrorCode::SurfaceNonManifold,
                   fileName,
                   std::to_string(summary.nonManifoldEdges) +
                     " edges with more than two triangles or two of opposite orientation",
                   "repair the surface and orient its triangles");
  }
}

void
flip(TriangleMesh & mesh)
{
  for (Triangle & triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

} // namespace

bool
isSurfaceName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtk", ".vtp", ".stl", ".obj", ".ply", ".off" });
}

TriangleMesh
readSurface(const std::string & fileName)
{
  FileSurface file = readFile(fileName);
  requireSaneNumbers(fileName, file.mesh);
  TriangleMesh mesh = withMergedVertices(file.mesh);
  if (file.isRas)
  {
    turnRasIntoLps(mesh.vertices);
  }
  requireSaneNumbers(fileName, mesh);
  requireClosed(fileName, mesh);
  const double      volume = enclosedVolume(mesh);
  const BoundingBox box = boundingBox(mesh.vertices);
  const Vector3     extent = box.upper - box.lower;
  if (!(std::abs(volume) > 1e-9 * extent.prod()))
  {
    throw BadInput(
      ErrorCode::SurfaceDegenerate, fileName, "the surface encloses no volume", "give a closed surface of a solid");
  }
  if (volume < 0.0)
  {
    flip(mesh);
  }
  return mesh;
}

} // namespace moserhex
