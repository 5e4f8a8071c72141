#include "SeedParts.h"
#include "moserhex/Analytic/SurfaceShapes.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstring>
#include <sstream>

namespace moserhex::fuzz
{
namespace
{

using analytic::cubeSurface;
using analytic::icosphere;

constexpr double size = 10.0; // [mm]

std::string
rowOf(const Vector3 & p)
{
  std::ostringstream text;
  text << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  return text.str();
}

std::string
rowOf(const Triangle & t, int first)
{
  return std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " + std::to_string(t[2] + first) + "\n";
}

/** A line for every vertex, then one for every triangle. */
std::string
rowsOf(const TriangleMesh & mesh, const std::string & beforeVertex, const std::string & beforeTriangle, int first)
{
  std::string text;
  for (const Vector3 & vertex : mesh.vertices)
  {
    text += beforeVertex + rowOf(vertex);
  }
  for (const Triangle & triangle : mesh.triangles)
  {
    text += beforeTriangle + rowOf(triangle, first);
  }
  return text;
}

template <typename T>
void
append(std::string & bytes, T value, bool bigEndian = false)
{
  const std::string raw(reinterpret_cast<const char *>(&value), sizeof value);
  bytes += bigEndian ? std::string(raw.rbegin(), raw.rend()) : raw;
}

std::string
textStl(const TriangleMesh & mesh)
{
  std::string text = "solid seed\n";
  for (const Triangle & triangle : mesh.triangles)
  {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const VertexIndex vertex : triangle)
    {
      text += "vertex " + rowOf(mesh.vertices[static_cast<std::size_t>(vertex)]);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid seed\n";
}

std::string
binaryStl(const TriangleMesh & mesh)
{
  std::string bytes = "solid seed, binary all the same";
  bytes.resize(80);
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle & triangle : mesh.triangles)
  {
    bytes += std::string(12, '\0');
    for (const VertexIndex vertex : triangle)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        append(bytes, static_cast<float>(mesh.vertices[static_cast<std::size_t>(vertex)][axis]));
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string
plyHeader(const TriangleMesh & mesh, const std::string & format)
{
  return "ply\nformat " + format + " 1.0\ncomment seed\nelement vertex " + std::to_string(mesh.vertices.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string
binaryPly(const TriangleMesh & mesh, bool bigEndian)
{
  std::string bytes = plyHeader(mesh, bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const Vector3 & vertex : mesh.vertices)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      append(bytes, static_cast<float>(vertex[axis]), bigEndian);
    }
  }
  for (const Triangle & triangle : mesh.triangles)
  {
    append(bytes, std::uint8_t{ 3 });
    for (const VertexIndex vertex : triangle)
    {
      append(bytes, vertex, bigEndian);
    }
  }
  return bytes;
}

std::string
legacyHeader(const TriangleMesh & mesh, const char * version, const char * encoding)
{
  return std::string("# vtk DataFile Version ") + version + "\nseed SPACE=LPS\n" + encoding +
         "\nDATASET POLYDATA\nPOINTS " + std::to_string(mesh.vertices.size()) + " float\n";
}

std::string
countsOf(const TriangleMesh & mesh)
{
  return "POLYGONS " + std::to_string(mesh.triangles.size()) + " " + std::to_string(4 * mesh.triangles.size()) + "\n";
}

std::string
textVtk(const TriangleMesh & mesh)
{
  return legacyHeader(mesh, "3.0", "ASCII") + rowsOf({ mesh.vertices, {} }, "", "", 0) + countsOf(mesh) +
         rowsOf({ {}, mesh.triangles }, "", "3 ", 0);
}

std::string
binaryVtk(const TriangleMesh & mesh)
{
  std::string bytes = legacyHeader(mesh, "4.2", "BINARY");
  for (const Vector3 & vertex : mesh.vertices)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      append(bytes, static_cast<float>(vertex[axis]), true);
    }
  }
  bytes += "\n" + countsOf(mesh);
  for (const Triangle & triangle : mesh.triangles)
  {
    append(bytes, std::int32_t{ 3 }, true);
    for (const VertexIndex vertex : triangle)
    {
      append(bytes, vertex, true);
    }
  }
  return bytes + "\n";
}

std::string
offsetsVtk(const TriangleMesh & mesh)
{
  const std::size_t count = mesh.triangles.size();
  std::string       text = legacyHeader(mesh, "5.1", "ASCII") + rowsOf({ mesh.vertices, {} }, "", "", 0) + "POLYGONS " +
                     std::to_string(count + 1) + " " + std::to_string(3 * count) + "\nOFFSETS vtktypeint64\n";
  for (std::size_t k = 0; k <= count; ++k)
  {
    text += std::to_string(3 * k) + "\n";
  }
  return text + "CONNECTIVITY vtktypeint64\n" + rowsOf({ {}, mesh.triangles }, "", "", 0);
}

SeedFile
xmlVtk(const TriangleMesh & mesh, const std::string & name, bool binary)
{
  vtkNew<vtkPoints>    points;
  vtkNew<vtkCellArray> polygons;
  for (const Vector3 & vertex : mesh.vertices)
  {
    points->InsertNextPoint(vertex.data());
  }
  for (const Triangle & triangle : mesh.triangles)
  {
    polygons->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(polygons);
  const ScratchFolder          folder;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName((folder / name).c_str());
  writer->SetInputData(data);
  binary ? writer->SetDataModeToAppended() : writer->SetDataModeToAscii();
  writer->Write();
  return folder.take(name);
}

} // namespace

void
addSurfaces(std::vector<Seed> & seeds)
{
  const TriangleMesh cube = cubeSurface(1, size);
  const TriangleMesh ball = icosphere(1, size);
  const std::string  off = std::to_string(cube.vertices.size()) + " " + std::to_string(cube.triangles.size()) + " 0\n";
  seeds.push_back({ SeedUse::Surface, "stl-text", { "text.stl", textStl(cube) }, {} });
  seeds.push_back({ SeedUse::Surface, "stl-binary", { "binary.stl", binaryStl(ball) }, {} });
  seeds.push_back({ SeedUse::Surface, "obj", { "cube.obj", "# seed\no cube\n" + rowsOf(cube, "v ", "f ", 1) }, {} });
  seeds.push_back(
    { SeedUse::Surface, "ply-text", { "text.ply", plyHeader(cube, "ascii") + rowsOf(cube, "", "3 ", 0) }, {} });
  seeds.push_back({ SeedUse::Surface, "ply-binary", { "little.ply", binaryPly(ball, false) }, {} });
  seeds.push_back({ SeedUse::Surface, "ply-big", { "big.ply", binaryPly(cube, true) }, {} });
  seeds.push_back({ SeedUse::Surface, "off", { "cube.off", "OFF\n" + off + rowsOf(cube, "", "3 ", 0) }, {} });
  seeds.push_back({ SeedUse::Surface, "vtk-text", { "text.vtk", textVtk(cube) }, {} });
  seeds.push_back({ SeedUse::Surface, "vtk-binary", { "binary.vtk", binaryVtk(ball) }, {} });
  seeds.push_back({ SeedUse::Surface, "vtk-offsets", { "offsets.vtk", offsetsVtk(cube) }, {} });
  seeds.push_back({ SeedUse::Surface, "vtp-text", xmlVtk(cube, "text.vtp", false), {} });
  seeds.push_back({ SeedUse::Surface, "vtp-binary", xmlVtk(ball, "binary.vtp", true), {} });
}

} // namespace moserhex::fuzz
