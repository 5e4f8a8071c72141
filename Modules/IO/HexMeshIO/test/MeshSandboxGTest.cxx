// Meshes that VTK reads in a child process: what comes back is the same, checked, and a death there is one refusal.
#include "../src/MeshBytes.h"

#include "TestFolder.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include <pthread.h>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

int forks = 0;

/** How many processes `call` starts. */
int
forksOf(const std::function<void()> & call)
{
  static const int registered = ::pthread_atfork([] { ++forks; }, nullptr, nullptr);
  EXPECT_EQ(registered, 0);
  forks = 0;
  call();
  return forks;
}

HexCellFile
hexahedra()
{
  const HexCellArrays arrays{ { { "OfCells", 2, std::vector<double>(16, 1.5) } },
                              { { "OfNodes", 1, std::vector<double>(27, -2.0) } } };
  return { unstructured(cubeLattice(3)), { "a warning", "another" }, arrays, { { "OfMesh", 3, { 1, 2, 3 } } } };
}

ErrorCode
codeOfBytes(const std::string & bytes)
{
  return codeThrownBy([&] { (void)hexCellFileOf("a.vtu", bytes); });
}

/** XML whose points, compressed, are in no blocks, the last of which is not full: VTK reads through a null pointer. */
std::string
deadlyXml(const std::string & kind, const std::string & cells)
{
  const std::string noBlocks("\0\0\0\0\x08\0\0\0\xC0\0\0\0", 12);
  return "<VTKFile type=\"" + kind +
         "\" version=\"0.1\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
         "compressor=\"vtkZLibDataCompressor\"><" +
         kind + "><Piece NumberOfPoints=\"8\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" " +
         "NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points>" + cells + "</Piece></" + kind +
         "><AppendedData encoding=\"raw\">_" + noBlocks + "</AppendedData></VTKFile>\n";
}

const char * const oneCell = "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5 6 7"
                             "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">8</DataArray>"
                             "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">12</DataArray></Cells>";

const ReadOptions here{ false };

} // namespace

TEST(MeshBytes, HexahedraGoThroughUnchanged)
{
  const HexCellFile file = hexahedra();
  const HexCellFile copy = hexCellFileOf("a.vtu", bytesOf(file));
  EXPECT_EQ(copy.mesh.nodes, file.mesh.nodes);
  EXPECT_EQ(copy.mesh.cells, file.mesh.cells);
  EXPECT_EQ(copy.warnings, file.warnings);
  ASSERT_EQ(copy.arrays.ofCells.size(), 1U);
  EXPECT_EQ(copy.arrays.ofCells[0].name, "OfCells");
  EXPECT_EQ(copy.arrays.ofCells[0].components, 2);
  EXPECT_EQ(copy.arrays.ofCells[0].values, file.arrays.ofCells[0].values);
  ASSERT_EQ(copy.arrays.ofNodes.size(), 1U);
  EXPECT_EQ(copy.arrays.ofNodes[0].values, file.arrays.ofNodes[0].values);
  ASSERT_EQ(copy.meshArrays.size(), 1U);
  EXPECT_EQ(copy.meshArrays[0].name, "OfMesh");
  EXPECT_EQ(copy.meshArrays[0].values, file.meshArrays[0].values);
}

TEST(MeshBytes, BytesThatAreNoWholeMeshAreRefused)
{
  const std::string bytes = bytesOf(hexahedra());
  for (std::size_t length = 0; length < bytes.size(); ++length)
  {
    ASSERT_EQ(codeOfBytes(bytes.substr(0, length)), ErrorCode::ReaderFailed) << length;
  }
  EXPECT_EQ(codeOfBytes(bytes + "x"), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeOfBytes(std::string(8, '\xFF') + bytes.substr(8)), ErrorCode::ReaderFailed);
}

TEST(MeshBytes, MeshThatIsNotValidIsRefused)
{
  HexCellFile notFinite = hexahedra();
  notFinite.mesh.nodes[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOfBytes(bytesOf(notFinite)), ErrorCode::ReaderFailed);
  HexCellFile outOfRange = hexahedra();
  outOfRange.mesh.cells[2][1] = 27;
  EXPECT_EQ(codeOfBytes(bytesOf(outOfRange)), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeOfBytes(bytesOf(HexCellFile())), ErrorCode::ReaderFailed);
  HexCellFile tooLong = hexahedra();
  tooLong.arrays.ofCells[0].values.push_back(0.0);
  EXPECT_EQ(codeOfBytes(bytesOf(tooLong)), ErrorCode::ReaderFailed);
  HexCellFile ofNoComponent = hexahedra();
  ofNoComponent.arrays.ofNodes[0].components = 0;
  ofNoComponent.arrays.ofNodes[0].values.clear();
  EXPECT_EQ(codeOfBytes(bytesOf(ofNoComponent)), ErrorCode::ReaderFailed);
}

TEST(MeshSandbox, DeathOfVtksReaderIsItsFailureAndNoMore)
{
  const TestFolder folder;
  writeBytes(folder / "a.vtu", deadlyXml("UnstructuredGrid", oneCell));
  EXPECT_EQ(codeThrownBy([&] { (void)readHexCells(folder / "a.vtu"); }), ErrorCode::ReaderFailed);
  EXPECT_EQ(codeThrownBy([&] { (void)readHexMesh(folder / "a.vtu"); }), ErrorCode::ReaderFailed);
  writeBytes(folder / "a.vtp", deadlyXml("PolyData", ""));
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtp"); }), ErrorCode::ReaderFailed);
}

TEST(MeshSandbox, ChangesNothing)
{
  const TestFolder folder;
  for (const char * name : { "a.vtu", "a.vtk" })
  {
    writeHexMesh(folder / name, cubeLattice(4), {});
    const HexCellFile there = readHexCells(folder / name);
    EXPECT_EQ(there.mesh.nodes, readHexCells(folder / name, here).mesh.nodes) << name;
    EXPECT_EQ(there.mesh.cells, readHexCells(folder / name, here).mesh.cells) << name;
    EXPECT_EQ(there.mesh.nodes, cubeLattice(4).nodes) << name;
  }
}

TEST(MeshSandbox, WhatStandsOnceForTheMeshComesBack)
{
  const TestFolder folder;
  HexMeshFields    fields;
  fields.meshArrays = { { "Turn", 3, { 10.0, 20.5, -30.0 } } };
  for (const char * name : { "a.vtu", "a.vtk" })
  {
    writeHexMesh(folder / name, cubeLattice(3), fields);
    for (const ReadOptions & options : { ReadOptions{}, here })
    {
      const HexMeshFile file = readHexMeshFile(folder / name, options);
      EXPECT_EQ(file.mesh.nodes, cubeLattice(3).nodes) << name;
      ASSERT_EQ(file.meshArrays.size(), 1U) << name;
      EXPECT_EQ(file.meshArrays[0].name, "Turn") << name;
      EXPECT_EQ(file.meshArrays[0].values, fields.meshArrays[0].values) << name;
    }
  }
}

TEST(MeshSandbox, OnlyWhatVtkReadsIsReadInAChild)
{
  const TestFolder folder;
  writeHexMesh(folder / "a.vtu", cubeLattice(2), {});
  EXPECT_EQ(forksOf([&] { (void)readHexCells(folder / "a.vtu"); }), 1);
  EXPECT_EQ(forksOf([&] { (void)readHexMesh(folder / "a.vtu"); }), 1);
  EXPECT_EQ(forksOf([&] { (void)readHexMesh(folder / "a.vtu", here); }), 0);
  writeBytes(folder / "a.off", "OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_EQ(forksOf([&] { (void)readSurface(folder / "a.off"); }), 0);
}

TEST(MeshSandbox, WriterReadsItsFileBackWithoutAChild)
{
  const TestFolder folder;
  for (const char * name : { "a.vtu", "a.vtk" })
  {
    EXPECT_EQ(forksOf([&] { writeHexMesh(folder / name, cubeLattice(3), {}); }), 0) << name;
  }
}

TEST(MeshSandbox, LegacyListLongerThanItsCellsIsRefused)
{
  const TestFolder folder;
  writeBytes(folder / "a.vtk",
             "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
             "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\nCELLS 1 18\n8 0 1 2 3 4 5 6 7\n8 0 1 2 3 4 5 6 7\n"
             "CELL_TYPES 2\n12\n12\n");
  EXPECT_NE(messageOf<BadInput>([&] { (void)readHexCells(folder / "a.vtk", here); }).find("9 numbers too many"),
            std::string::npos);
}
