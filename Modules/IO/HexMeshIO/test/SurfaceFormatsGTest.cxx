// What each format's reader takes and refuses, by code. Coordinates are binary fractions: volumes are exact.
#include "SurfaceFormats.h"

#include "MeshBytes.h"
#include "TestFolder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

/** Reads `bytes` as a file with this ending. */
RawSurface
read(const std::string & ending, const std::string & bytes)
{
  const TestFolder folder;
  writeBytes(folder / ("a." + ending), bytes);
  return readRawSurface(folder / ("a." + ending));
}

ErrorCode
codeOf(const std::string & ending, const std::string & bytes)
{
  return codeThrownBy([&] { (void)read(ending, bytes); });
}

std::string
replaced(std::string text, const std::string & from, const std::string & to)
{
  const std::size_t found = text.find(from);
  if (found == std::string::npos)
  {
    throw std::runtime_error("'" + from + "' is not there");
  }
  return text.replace(found, from.size(), to);
}

/** A cube of eight vertices and six quadrilaterals; volume 1000. */
const char * const cubeVertices[] = {
  "0 0 0", "10 0 0", "10 10 0", "0 10 0", "0 0 10", "10 0 10", "10 10 10", "0 10 10"
};
constexpr int cubeFaces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
                                  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

std::string
cubeObj()
{
  std::string text = "# a cube\nmtllib a.mtl\no cube\n";
  for (const char * vertex : cubeVertices)
  {
    text += std::string("v ") + vertex + "\n";
  }
  for (const auto & face : cubeFaces)
  {
    text += "f";
    for (const int vertex : face)
    {
      text += " " + std::to_string(vertex + 1);
    }
    text += "\n";
  }
  return text;
}

std::string
cubeRows(bool vertices)
{
  std::string text;
  for (const char * vertex : cubeVertices)
  {
    text += vertices ? std::string(vertex) + "\n" : "";
  }
  for (const auto & face : cubeFaces)
  {
    std::ostringstream row;
    row << "4 " << face[0] << ' ' << face[1] << ' ' << face[2] << ' ' << face[3] << '\n';
    text += vertices ? "" : row.str();
  }
  return text;
}

std::string
cubeOff()
{
  return "OFF\n8 6 0\n" + cubeRows(true) + cubeRows(false);
}

std::string
cubePly()
{
  return "ply\nformat ascii 1.0\ncomment made in a test\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n" +
         cubeRows(true) + cubeRows(false);
}

std::string
cubeVtk()
{
  return "# vtk DataFile Version 3.0\na cube\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n" + cubeRows(true) +
         "POLYGONS 6 30\n" + cubeRows(false);
}

std::string
cubeVtk5()
{
  std::string text = "# vtk DataFile Version 5.1\na cube\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n" + cubeRows(true) +
                     "POLYGONS 7 24\nOFFSETS vtktypeint64\n0 4 8 12 16 20 24\nCONNECTIVITY vtktypeint64\n";
  for (const auto & face : cubeFaces)
  {
    for (const int vertex : face)
    {
      text += std::to_string(vertex) + " ";
    }
  }
  return text + "\n";
}

/** Big-endian bytes of a value. */
template <typename T>
std::string
bigEndian(T value)
{
  const std::string raw(reinterpret_cast<const char *>(&value), sizeof value);
  return { raw.rbegin(), raw.rend() };
}

template <typename T>
std::string
littleEndian(T value)
{
  return { reinterpret_cast<const char *>(&value), sizeof value };
}

std::string
cubeVtkBinary()
{
  std::string bytes = "# vtk DataFile Version 3.0\na cube\nBINARY\nDATASET POLYDATA\nPOINTS 8 float\n";
  for (const char * vertex : cubeVertices)
  {
    std::istringstream numbers(vertex);
    for (float number; numbers >> number;)
    {
      bytes += bigEndian(number);
    }
  }
  bytes += "\nPOLYGONS 6 30\n";
  for (const auto & face : cubeFaces)
  {
    bytes += bigEndian(std::int32_t{ 4 });
    for (const std::int32_t vertex : face)
    {
      bytes += bigEndian(vertex);
    }
  }
  return bytes + "\n";
}

std::string
cubeStlText()
{
  std::ostringstream text;
  text << "solid a cube\n";
  const TriangleMesh mesh = cubeSurface(1, 2.0);
  for (const Triangle & triangle : mesh.triangles)
  {
    text << "facet normal 0 0 nan\n  outer loop\n";
    for (const VertexIndex v : triangle)
    {
      const Vector3 & p = mesh.vertices[v];
      text << "    vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    text << "  endloop\nendfacet\n";
  }
  text << "endsolid a cube\n";
  return text.str();
}

std::string
cubeStlBinary(const std::string & header = "made in a test", std::uint32_t count = 12)
{
  std::string bytes = header;
  bytes.resize(80);
  bytes += littleEndian(count);
  const TriangleMesh mesh = cubeSurface(1, 2.0);
  for (const Triangle & triangle : mesh.triangles)
  {
    bytes += std::string(12, '\0');
    for (const VertexIndex v : triangle)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        bytes += littleEndian(static_cast<float>(mesh.vertices[v][axis]));
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

double
volumeOf(const RawSurface & surface)
{
  return enclosedVolume(surface.mesh);
}

} // namespace

TEST(SurfaceFormats, QuadrilateralsAreCutInEveryFormat)
{
  for (const auto & [ending, text] : { std::pair<std::string, std::string>{ "obj", cubeObj() },
                                       { "off", cubeOff() },
                                       { "ply", cubePly() },
                                       { "vtk", cubeVtk() },
                                       { "vtk", cubeVtk5() },
                                       { "vtk", cubeVtkBinary() } })
  {
    const RawSurface surface = read(ending, text);
    EXPECT_EQ(surface.splitPolygons, 6u) << ending;
    EXPECT_EQ(surface.mesh.triangles.size(), 12u) << ending;
    EXPECT_DOUBLE_EQ(volumeOf(surface), 1000.0) << ending;
  }
}

TEST(SurfaceFormats, PolygonIsCutFromTheCornerThatSeesAllOfIt)
{
  // A dart: only corner 1 and its opposite see the whole.
  const RawSurface dart = read("obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n");
  EXPECT_EQ(dart.mesh.triangles.size(), 2u);
  EXPECT_DOUBLE_EQ(surfaceArea(dart.mesh), 4.0);
  EXPECT_EQ(codeOf("obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4 5 6\n"),
            ErrorCode::Unsupported);
}

TEST(SurfaceFormats, CutTextIsTruncatedOrLacksPolygons)
{
  for (const auto & [ending, text] : { std::pair<std::string, std::string>{ "off", cubeOff() },
                                       { "ply", cubePly() },
                                       { "vtk", cubeVtk() },
                                       { "vtk", cubeVtk5() },
                                       { "vtk", cubeVtkBinary() },
                                       { "stl", cubeStlText() },
                                       { "stl", cubeStlBinary() } })
  {
    for (std::size_t length = 1; length + 10 < text.size(); length += 11)
    {
      EXPECT_THROW((void)read(ending, text.substr(0, length)), BadInput) << ending << ' ' << length;
    }
  }
}

TEST(SurfaceFormats, NumberThatIsNoneIsOfTheWrongFormat)
{
  for (const auto & [ending, text] : { std::pair<std::string, std::string>{ "obj", cubeObj() },
                                       { "off", cubeOff() },
                                       { "ply", cubePly() },
                                       { "vtk", cubeVtk() } })
  {
    EXPECT_EQ(codeOf(ending, replaced(text, "10 10 0", "10,5 10 0")), ErrorCode::Format) << ending;
    EXPECT_EQ(codeOf(ending, replaced(text, "10 10 0", "x 10 0")), ErrorCode::Format) << ending;
    EXPECT_EQ(codeOf(ending, replaced(text, "10 10 0", "nan 10 0")), ErrorCode::SurfaceNaN) << ending;
    EXPECT_EQ(codeOf(ending, replaced(text, "10 10 0", "10 -inf 0")), ErrorCode::SurfaceNaN) << ending;
  }
}

TEST(SurfaceFormats, MissingCoordinateIsNotTakenFromTheNextLine)
{
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "10 10 0\n", "10 10\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "10 10 0\n", "10 10\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("ply", replaced(cubePly(), "10 10 0\n", "10 10\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("ply", replaced(cubePly(), "10 10 0\n", "10 10 0 7\n")), ErrorCode::Format);
}

TEST(SurfaceFormats, IndexOutOfRangeIsNamed)
{
  for (const char * index : { "8", "-1", "1000000000000000000", "99999999999999999999999" })
  {
    const std::string row = std::string("4 4 5 6 ") + index + "\n";
    for (const auto & [ending, text] :
         { std::pair<std::string, std::string>{ "off", cubeOff() }, { "ply", cubePly() }, { "vtk", cubeVtk() } })
    {
      EXPECT_EQ(codeOf(ending, replaced(text, "4 4 5 6 7\n", row)), ErrorCode::SurfaceIndex) << ending << index;
    }
  }
  for (const char * index : { "0", "9", "-9", "1000000000000000000", "99999999999999999999999" })
  {
    EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", std::string("f 5 6 7 ") + index)), ErrorCode::SurfaceIndex)
      << index;
  }
}

TEST(SurfaceFormats, CountsOfOffThatLieAreRefused)
{
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "8 6 0", "8 5 0")), ErrorCode::Header);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "8 6 0", "8 7 0")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "8 6 0", "8 999999999999 0")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "8 6 0", "-8 6 0")), ErrorCode::Header);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "8 6 0", "8")), ErrorCode::Header);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "4 4 5 6 7\n", "5 4 5 6 7\n")), ErrorCode::Format);
}

TEST(SurfaceFormats, KindsOfOff)
{
  EXPECT_NO_THROW((void)read("off", replaced(cubeOff(), "OFF\n8 6 0", "OFF 8 6 0")));
  EXPECT_NO_THROW((void)read("off", replaced(cubeOff(), "OFF\n", "OFF # comment\n\n# another\n")));
  EXPECT_NO_THROW((void)read("off", replaced(cubeOff(), "10 10 0\n", "10 10 0 # corner\n")));
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "OFF", "4OFF")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "OFF", "OFF BINARY")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("off", replaced(cubeOff(), "OFF", "FFO")), ErrorCode::Format);
  EXPECT_EQ(codeOf("off", "OFF"), ErrorCode::Truncated);
}

TEST(SurfaceFormats, FormsOfObj)
{
  for (const char * form : { "f 5/1 6/2 7/3 8/4",
                             "f 5//1 6//1 7//1 8//1",
                             "f 5/1/1 6/2/1 7/3/1 8/4/1",
                             "f -4 -3 -2 -1",
                             "f 5 6 \\\n7 8",
                             "f 5 6 7 \\\n 8" })
  {
    EXPECT_DOUBLE_EQ(volumeOf(read("obj", replaced(cubeObj(), "f 5 6 7 8", form))), 1000.0) << form;
  }
  EXPECT_NO_THROW((void)read("obj", replaced(cubeObj(), "v 10 10 0\n", "v 10 10 0 0.5 0.5 0.5\n")));
  EXPECT_NO_THROW((void)read("obj", replaced(cubeObj(), "v 10 10 0\n", "vn 0 0 1\nvt 0 0\nv 10 10 0 1.0\ns off\n")));
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", "f 5 6")), ErrorCode::Format);
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", "f 5 6 7.5 8")), ErrorCode::Format);
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", "f 5/x 6 7 8")), ErrorCode::Format);
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", "surf 0 1 0 1 1 2 3")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "f 5 6 7 8", "facet 5 6 7 8")), ErrorCode::Format);
  EXPECT_EQ(codeOf("obj", cubeObj() + "f 5 6 7 \\"), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("obj", replaced(cubeObj(), "v 10 10 0\n", "v 10 10 0 blue\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("obj", "v 0 0 0\n"), ErrorCode::Empty);
}

TEST(SurfaceFormats, VertexOfObjMayFollowItsFace)
{
  EXPECT_NO_THROW((void)read("obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"));
}

TEST(SurfaceFormats, HeadersOfPlyThatLieAreRefused)
{
  const std::string ply = cubePly();
  EXPECT_EQ(codeOf("ply", replaced(ply, "vertex 8", "vertex -8")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "vertex 8", "vertex 8.5")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "vertex 8", "vertex 2000000000")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("ply", replaced(ply, "face 6", "face 5")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "face 6", "face 7")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("ply", replaced(ply, "face 6", "face 0")), ErrorCode::Empty);
  EXPECT_EQ(codeOf("ply", replaced(ply, "format ascii 1.0\n", "")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "ascii", "ebcdic")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "float z", "float x")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "float z", "float w")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "float z", "quad z")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "vertex_indices", "corners")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "element face", "element vertex")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "element face", "element tristrips")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("ply", replaced(ply, "end_header", "header_end")), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", replaced(ply, "4 4 5 6 7\n", "-4 4 5 6 7\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("ply", replaced(ply, "4 4 5 6 7\n", "3 4 5 6 7\n")), ErrorCode::Format);
  EXPECT_EQ(codeOf("ply", replaced(ply, "4 4 5 6 7\n", "4 4 5 6.5 7\n")), ErrorCode::SurfaceIndex);
}

TEST(SurfaceFormats, EveryBinaryTypeOfPlyIsRead)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char a\nproperty uchar b\n"
                      "property short c\nproperty ushort d\nproperty uint e\nproperty double x\nproperty double y\n"
                      "property float z\nelement face 1\nproperty list int uint vertex_index\nend_header\n";
  for (const double x : { 0.0, 1.0, 2.0 })
  {
    bytes += std::string(1 + 1 + 2 + 2 + 4, '\7') + littleEndian(x) + littleEndian(x * x) + littleEndian(0.5F);
  }
  bytes += littleEndian(std::int32_t{ 3 }) + littleEndian(std::uint32_t{ 0 }) + littleEndian(std::uint32_t{ 1 }) +
           littleEndian(std::uint32_t{ 2 });
  const RawSurface surface = read("ply", bytes);
  EXPECT_EQ(surface.mesh.vertices[2], Vector3(2.0, 4.0, 0.5));
  EXPECT_EQ(codeOf("ply", bytes + "x"), ErrorCode::Header);
  EXPECT_EQ(codeOf("ply", bytes.substr(0, bytes.size() - 1)), ErrorCode::Truncated);
}

TEST(SurfaceFormats, BinaryPlyWithATextFlagIsOfTheWrongFormat)
{
  const std::string header = cubePly().substr(0, cubePly().find("0 0 0"));
  EXPECT_EQ(codeOf("ply", header + std::string(300, '\1')), ErrorCode::Format);
}

TEST(SurfaceFormats, TextAndBinaryStlAreTold)
{
  EXPECT_DOUBLE_EQ(volumeOf(read("stl", cubeStlText())), 8.0);
  EXPECT_DOUBLE_EQ(volumeOf(read("stl", cubeStlBinary())), 8.0);
  EXPECT_DOUBLE_EQ(volumeOf(read("stl", cubeStlBinary("solid exported by a program"))), 8.0);
  std::string upper = cubeStlText();
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  EXPECT_DOUBLE_EQ(volumeOf(read("stl", upper)), 8.0);
  EXPECT_EQ(read("stl", cubeStlText() + cubeStlText()).mesh.triangles.size(), 24u);
}

TEST(SurfaceFormats, WrongWordsInTextStlAreRefused)
{
  const std::string text = cubeStlText();
  for (const char * word : { "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet" })
  {
    EXPECT_EQ(codeOf("stl", replaced(text, word, "word")), ErrorCode::Format) << word;
  }
  EXPECT_EQ(codeOf("stl", replaced(text, "endsolid", "endsoldi")), ErrorCode::Format);
  EXPECT_EQ(codeOf("stl", replaced(text, "endsolid a cube\n", "")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("stl", replaced(text, "vertex -1", "vertex -1,0")), ErrorCode::Format);
  EXPECT_EQ(codeOf("stl", replaced(text, "vertex -1", "vertex nan")), ErrorCode::SurfaceNaN);
  EXPECT_EQ(codeOf("stl", "solid nothing\nendsolid nothing\n"), ErrorCode::Empty);
  EXPECT_EQ(codeOf("stl", "facet normal 0 0 1\n"), ErrorCode::Format);
}

TEST(SurfaceFormats, CountsOfBinaryStlThatLieAreRefused)
{
  EXPECT_EQ(codeOf("stl", cubeStlBinary("", 4294967295U)), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("stl", cubeStlBinary("", 13)), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("stl", cubeStlBinary("", 11)), ErrorCode::Header);
  EXPECT_EQ(codeOf("stl", cubeStlBinary("").substr(0, 82)), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("stl", cubeStlBinary("", 0).substr(0, 84)), ErrorCode::Empty);
  std::string nan = cubeStlBinary();
  const float quiet = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(nan.data() + 84 + 12, &quiet, sizeof quiet);
  EXPECT_EQ(codeOf("stl", nan), ErrorCode::SurfaceNaN);
}

TEST(SurfaceFormats, LegacyVtkHeadersThatLieAreRefused)
{
  const std::string vtk = cubeVtk();
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "# vtk", "# VTK?")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "3.0", "9.9")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "ASCII", "UTF-8")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "ASCII", "BINARY")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(cubeVtkBinary(), "BINARY", "ASCII")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "DATASET ", "DATA ")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYDATA", "UNSTRUCTURED_GRID")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POINTS 8", "POINTS -8")), ErrorCode::Header);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POINTS 8", "POINTS 18446744073709551615")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POINTS 8 double", "POINTS 8 string")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POINTS 8", "POINTS 9")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 6 30", "POLYGONS 6 29")), ErrorCode::SurfaceIndex);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 6 30", "POLYGONS 5 30")), ErrorCode::Header);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 6 30", "POLYGONS 6 100000")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 6 30", "TRIANGLE_STRIPS 6 30")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 6 30", "LINES 6 30")), ErrorCode::Empty);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "4 4 5 6 7", "-4 4 5 6 7")), ErrorCode::SurfaceIndex);
  EXPECT_EQ(codeOf("vtk", vtk.substr(0, vtk.find("POINTS"))), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("vtk", vtk + "POLYGONS 0 0\n"), ErrorCode::Format);
}

TEST(SurfaceFormats, OffsetsOfLegacyVtkThatLieAreRefused)
{
  const std::string vtk = cubeVtk5();
  for (const char * offsets : { "0 4 8 12 16 20 23", "1 4 8 12 16 20 24", "0 4 8 6 16 20 24", "0 4 -8 12 16 20 24" })
  {
    EXPECT_EQ(codeOf("vtk", replaced(vtk, "0 4 8 12 16 20 24", offsets)), ErrorCode::SurfaceIndex) << offsets;
  }
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "OFFSETS", "OFFSET")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 7 24", "POLYGONS 0 24")), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtk", replaced(vtk, "POLYGONS 7 24", "POLYGONS 7 24000000")), ErrorCode::Truncated);
}

TEST(SurfaceFormats, WhatSurroundsTheSurfaceInLegacyVtkIsPassedOver)
{
  const std::string field = "FIELD FieldData 2\nSPACE 1 1 string\nRAS\nnumbers 2 2 short\n1 2 3 4\n"
                            "METADATA\nINFORMATION 0\n\nPOINTS";
  const RawSurface  surface = read("vtk", replaced(cubeVtk(), "POINTS", field) + "POINT_DATA 8\nSCALARS a int\n1 2\n");
  EXPECT_TRUE(surface.isRas);
  EXPECT_EQ(surface.mesh.triangles.size(), 12u);
  EXPECT_FALSE(read("vtk", replaced(cubeVtk(), "POINTS", replaced(field, "RAS", "LPS"))).isRas);
  EXPECT_TRUE(read("vtk", replaced(cubeVtk(), "a cube", "3D Slicer output. SPACE=RAS")).isRas);

  const std::string numbers = "FIELD F 3\na 1 1 short\n" + std::string(2, '\xFF') + "\nMETADATA\nINFORMATION 0\n\n" +
                              "b 2 1 unsigned_char\n" + std::string(2, '\xFF') + "\nc 1 1 unsigned_short\n" +
                              std::string(2, '\xFF') + "\nPOINTS";
  EXPECT_EQ(read("vtk", replaced(cubeVtkBinary(), "POINTS", numbers)).mesh.triangles.size(), 12u);
  const std::string binaryField = "FIELD FieldData 1\nSPACE 1 1 string\n\xC3RAS\nPOINTS";
  EXPECT_TRUE(read("vtk", replaced(cubeVtkBinary(), "POINTS", binaryField)).isRas);
  EXPECT_EQ(codeOf("vtk", replaced(cubeVtkBinary(), "POINTS", "FIELD F 1\nSPACE 1 1 string\n\x3FRAS")),
            ErrorCode::Truncated);
}

TEST(SurfaceFormats, SurfaceGoesThroughBytesUnchanged)
{
  RawSurface surface = read("off", cubeOff());
  surface.isRas = true;
  const RawSurface copy = rawSurfaceOf("a.vtp", bytesOf(surface));
  EXPECT_EQ(copy.mesh.vertices, surface.mesh.vertices);
  EXPECT_EQ(copy.mesh.triangles, surface.mesh.triangles);
  EXPECT_EQ(copy.splitPolygons, 6u);
  EXPECT_TRUE(copy.isRas);
}

TEST(SurfaceFormats, BytesThatAreNoWholeSurfaceAreRefused)
{
  const RawSurface  surface = read("off", cubeOff());
  const std::string bytes = bytesOf(surface);
  const auto        codeOfBytes = [](const std::string & damaged) {
    return codeThrownBy([&] { (void)rawSurfaceOf("a.vtp", damaged); });
  };
  EXPECT_EQ(codeOfBytes(""), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeOfBytes(bytes.substr(0, bytes.size() - 1)), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeOfBytes(bytes + "x"), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeOfBytes(std::string(8, '\xFF') + bytes.substr(8)), ErrorCode::ReaderFailed);
  RawSurface notFinite = surface;
  notFinite.mesh.vertices[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOfBytes(bytesOf(notFinite)), ErrorCode::ReaderFailed);
  RawSurface outOfRange = surface;
  outOfRange.mesh.triangles[2][1] = 8;
  EXPECT_EQ(codeOfBytes(bytesOf(outOfRange)), ErrorCode::ReaderFailed);
}

TEST(SurfaceFormats, XmlThatCouldHarmIsRefused)
{
  const std::string vtp = "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"0\" "
                          "NumberOfPolys=\"0\"></Piece></PolyData></VTKFile>\n";
  EXPECT_EQ(codeOf("vtp", "<!DOCTYPE x [<!ENTITY e \"boom\">]>\n" + vtp), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtp", replaced(vtp, "\"0\"", "\"-1\"")), ErrorCode::Header);
  EXPECT_EQ(codeOf("vtp", replaced(vtp, "\"0\"", "\"4000000000\"")), ErrorCode::Truncated);
  EXPECT_EQ(codeOf("vtp", replaced(vtp, "<PolyData>", "<ImageData>")), ErrorCode::Unsupported);
  EXPECT_EQ(codeOf("vtp", "hello"), ErrorCode::Format);
  EXPECT_EQ(codeOf("vtp", replaced(vtp, "<Piece", "<FieldData><Array type=\"nan\"/></FieldData><Piece")),
            ErrorCode::Header);
}
