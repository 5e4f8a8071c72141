// Files of Gmsh and meshio in test/data (one sheared box): counts exact, volumes within 1e-9, as Gmsh places its nodes
// to 1e-11. Files made here: exact. Damaged files: refused or read, never a crash.
#include "moserhex/HexMeshIO/HexCellReader.h"

#include "TestFolder.h"
#include "moserhex/Common/Random.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

using namespace moserhex;

namespace
{

std::string
dataFile(const std::string & name)
{
  return std::string(MOSERHEX_TEST_DATA) + "/" + name;
}

/** The message of the refusal of a file with this content. */
std::string
refusalOf(const std::string & name, const std::string & content)
{
  const TestFolder folder;
  writeBytes(folder / name, content);
  return messageOf<BadInput>([&] { (void)readHexCells(folder / name); });
}

HexCellFile
readText(const std::string & name, const std::string & content)
{
  const TestFolder folder;
  writeBytes(folder / name, content);
  return readHexCells(folder / name);
}

bool
contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

std::string
replaced(std::string text, const std::string & from, const std::string & to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/** One cell, corners of the unit cube numbered 1 to 8 in VTK's order. */
const char * const cubeInp =
  "*HEADING\nanything, even 1, 2\n*NODE, NSET=ALL\n1, 0, 0, 0\n2, 1., 0, 0\n3, 1.D+00, 1, 0\n"
  "4, 0, +1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n7, 1, 1, 1\n8, 0, 1, 1\n"
  "*ELEMENT, TYPE=C3D8R, ELSET=E1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*END STEP\n";

const char * const cubeMesh = "MeshVersionFormatted 2\n# a comment\nDimension\n3\nVertices\n8\n0 0 0 1\n1 0 0 1\n"
                              "1 1 0 1\n0 1 0 1\n0 0 1 1\n1 0 1 1\n1 1 1 1\n0 1 1 1\nHexahedra\n1\n"
                              "1 2 3 4 5 6 7 8 9\nEnd\n";

const char * const cubeMsh22 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"box\"\n"
                               "$EndPhysicalNames\n$Nodes\n8\n11 0 0 0\n22 1 0 0\n33 1 1 0\n44 0 1 0\n5 0 0 1\n"
                               "6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n$Elements\n2\n1 15 2 0 0 11\n"
                               "2 5 2 0 0 11 22 33 44 5 6 7 8\n$EndElements\n";

const char * const cubeMsh41 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 8 1 900\n3 1 0 4\n100\n200\n300\n900\n"
                               "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 1 4\n5\n6\n7\n8\n0 0 1 .1 .2\n1 0 1 .1 .2\n"
                               "1 1 1 .1 .2\n0 1 1 .1 .2\n$EndNodes\n$Elements\n1 1 1 1\n3 1 5 1\n"
                               "1 100 200 300 900 5 6 7 8\n$EndElements\n";

const char * const cubeVtk = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n"
                             "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\nCELLS 1 9\n8 0 1 2 3 4 5 6 7\n"
                             "CELL_TYPES 1\n12\n";

struct NamedText
{
  const char * name;
  const char * text;
};

const NamedText cubes[] = { { "a.inp", cubeInp },
                            { "a.mesh", cubeMesh },
                            { "22.msh", cubeMsh22 },
                            { "41.msh", cubeMsh41 },
                            { "a.vtk", cubeVtk } };

double
volumeOf(const UnstructuredHexMesh & mesh)
{
  double sum = 0.0;
  for (const double volume : cellVolumes(mesh))
  {
    EXPECT_GT(volume, 0.0);
    sum += volume;
  }
  return sum;
}

} // namespace

class FilesOfOtherTools : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(Data,
                         FilesOfOtherTools,
                         testing::Values("gmsh.inp",
                                         "gmsh.mesh",
                                         "gmsh.vtk",
                                         "gmsh_binary.vtk",
                                         "gmsh_msh22.msh",
                                         "gmsh_msh22_binary.msh",
                                         "gmsh_msh41.msh",
                                         "gmsh_msh41_binary.msh",
                                         "meshio.inp",
                                         "meshio.mesh",
                                         "meshio.vtk",
                                         "meshio.vtu",
                                         "meshio_22.msh",
                                         "meshio_41.msh",
                                         "meshio_41b.msh",
                                         "meshio_ascii.vtk",
                                         "meshio_vtk42.vtk"),
                         [](const auto & instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST_P(FilesOfOtherTools, ShearedBoxIsRead)
{
  const HexCellFile file = readHexCells(dataFile(GetParam()));
  EXPECT_EQ(file.mesh.nodes.size(), 27U);
  EXPECT_EQ(file.mesh.cells.size(), 8U);
  EXPECT_NEAR(volumeOf(file.mesh), 6.0, 1e-9);
  Vector3 centre = Vector3::Zero();
  for (const Vector3 & node : file.mesh.nodes)
  {
    centre += node / 27.0;
  }
  const bool fromGmsh = std::string(GetParam()).compare(0, 4, "gmsh") == 0;
  EXPECT_LT((centre - Vector3(0.75, fromGmsh ? 1.0 : 0.0, 1.5)).norm(), 1e-9);
  EXPECT_EQ(boundaryFaces(file.mesh).size(), 24U);
  if (fromGmsh)
  {
    ASSERT_EQ(file.warnings.size(), 1U); // quadrilaterals, lines, points
    EXPECT_TRUE(contains(file.warnings[0], "ignored: ")) << file.warnings[0];
    EXPECT_TRUE(contains(file.warnings[0], "24 x ")) << file.warnings[0];
  }
}

TEST_P(FilesOfOtherTools, CutAnywhereIsRefusedOrWhole)
{
  const TestFolder  folder;
  const std::string bytes = readBytes(dataFile(GetParam()));
  const std::string name = folder / GetParam();
  for (std::size_t length = 1; length < bytes.size(); length += 29)
  {
    writeBytes(name, bytes.substr(0, length));
    try
    {
      const HexCellFile file = readHexCells(name);
      // What is missing was not needed; only .inp has neither counts nor an end, and there it shows in mid-line.
      const bool saysSo = !file.warnings.empty() && contains(file.warnings.back(), "may be cut");
      EXPECT_TRUE(file.mesh.cells.size() == 8 || saysSo || bytes[length - 1] == '\n') << length;
    }
    catch (const BadInput &)
    {}
  }
}

TEST_P(FilesOfOtherTools, DamagedBytesAreRefusedOrReadWithoutACrash)
{
  const TestFolder  folder;
  const std::string bytes = readBytes(dataFile(GetParam()));
  const std::string name = folder / GetParam();
  Random            random(17);
  for (int trial = 0; trial < 60; ++trial)
  {
    std::string damaged = bytes;
    for (int i = 0; i < 1 + trial % 4; ++i)
    {
      const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()));
      damaged[at] = trial % 2 == 0 ? static_cast<char>(random.uniform() * 256.0) : "0123456789- "[trial % 12];
    }
    writeBytes(name, damaged);
    try
    {
      requireValid(readHexCells(name).mesh);
    }
    catch (const BadInput &)
    {}
  }
}

TEST(HexCellReader, CubeIsReadFromEveryTextFormat)
{
  for (const NamedText & cube : cubes)
  {
    const HexCellFile file = readText(cube.name, cube.text);
    ASSERT_EQ(file.mesh.cells.size(), 1U) << cube.name;
    EXPECT_EQ(file.mesh.nodes.size(), 8U) << cube.name;
    EXPECT_DOUBLE_EQ(hexVolume(cellCorners(file.mesh, 0)), 1.0) << cube.name;
    EXPECT_EQ(cellCorners(file.mesh, 0)[6], Vector3(1, 1, 1)) << cube.name;
    EXPECT_EQ(cellCorners(file.mesh, 0)[1], Vector3(1, 0, 0)) << cube.name;
  }
}

TEST(HexCellReader, WrittenLatticeIsReadAsOne)
{
  const TestFolder folder;
  HexMesh          mesh{ 4, {} };
  for (int i = 0; i < 64; ++i)
  {
    mesh.nodes.emplace_back(i % 4 + 0.1 * (i / 16), i / 4 % 4 - 1.0 / 3.0, i / 16);
  }
  for (const char * name : { "a.vtu", "a.vtk" })
  {
    writeHexMesh(folder / name, mesh);
    const auto lattice = asLattice(readHexCells(folder / name).mesh);
    ASSERT_TRUE(lattice) << name;
    EXPECT_EQ(lattice->nodes, mesh.nodes) << name;
  }
}

TEST(HexCellReader, GmshCellsComeInTheOrderOfTheirNumbers)
{
  std::string text = replaced(cubeMsh22, "$Elements\n2", "$Elements\n3");
  text =
    replaced(text, "2 5 2 0 0 11 22 33 44 5 6 7 8\n", "7 5 2 0 0 5 6 7 8 11 22 33 44\n2 5 2 0 0 11 22 33 44 5 6 7 8\n");
  const HexCellFile file = readText("a.msh", text);
  ASSERT_EQ(file.mesh.cells.size(), 2U);
  EXPECT_EQ(file.mesh.cells[0], (std::array<std::size_t, 8>{ 0, 1, 2, 3, 4, 5, 6, 7 }));
  EXPECT_EQ(file.mesh.cells[1], (std::array<std::size_t, 8>{ 4, 5, 6, 7, 0, 1, 2, 3 }));
}

TEST(HexCellReader, LegacyFileInRasIsTurnedIntoLps)
{
  const HexCellFile file = readText("a.vtk", replaced(cubeVtk, "title", "3D Slicer output. SPACE=RAS"));
  EXPECT_EQ(cellCorners(file.mesh, 0)[6], Vector3(-1, -1, 1));
  EXPECT_DOUBLE_EQ(hexVolume(cellCorners(file.mesh, 0)), 1.0);
}

TEST(HexCellReader, ArraysAreThoseOfTheHexahedraAndTheirNodes)
{
  const TestFolder  folder;
  const std::string text = replaced(replaced(replaced(cubeVtk, "POINTS 8 double\n", "POINTS 9 double\n9 9 9 "),
                                             "CELLS 1 9\n8 0 1 2 3 4 5 6 7\n",
                                             "CELLS 2 12\n2 0 1\n8 1 2 3 4 5 6 7 8\n"),
                                    "CELL_TYPES 1\n",
                                    "CELL_TYPES 2\n3\n");
  writeBytes(folder / "a.vtk",
             text + "CELL_DATA 2\nSCALARS Shell int 1\nLOOKUP_TABLE default\n7 8\n"
                    "POINT_DATA 9\nVECTORS Motion double\n0 0 0 1 1 1 2 2 2 3 3 3 4 4 4 5 5 5 6 6 6 7 7 7 8 8 9\n");
  for (const bool sandbox : { true, false })
  {
    const HexCellArrays arrays = readHexCellsWithArrays(folder / "a.vtk", { sandbox }).arrays;
    ASSERT_EQ(arrays.ofCells.size(), 1U);
    EXPECT_EQ(arrays.ofCells[0].name, "Shell");
    EXPECT_EQ(arrays.ofCells[0].values, std::vector<double>({ 8.0 }));
    ASSERT_EQ(arrays.ofNodes.size(), 1U);
    EXPECT_EQ(arrays.ofNodes[0].components, 3);
    ASSERT_EQ(arrays.ofNodes[0].values.size(), 24U);
    EXPECT_EQ(arrays.ofNodes[0].values[0], 1.0);
    EXPECT_EQ(arrays.ofNodes[0].values[22], 8.0);
    EXPECT_EQ(arrays.ofNodes[0].values[23], 9.0);
    EXPECT_TRUE(readHexCells(folder / "a.vtk", { sandbox }).arrays.ofCells.empty());
  }
}

TEST(HexCellReader, ArrayOfAnotherLengthIsRefusedWhereArraysAreRead)
{
  const TestFolder folder;
  writeBytes(folder / "a.vtk", std::string(cubeVtk) + "CELL_DATA 1\nFIELD FieldData 1\nLong 1 3 double\n1 2 3\n");
  EXPECT_EQ(readHexCells(folder / "a.vtk").mesh.cells.size(), 1U);
  EXPECT_TRUE(contains(messageOf<BadInput>([&] { (void)readHexCellsWithArrays(folder / "a.vtk"); }),
                       "array Long is 3 long and not 1"));
}

TEST(HexCellReader, OtherVolumeCellsAreRefusedByNameAndCount)
{
  EXPECT_TRUE(contains(refusalOf("a.inp", std::string(cubeInp) + "*ELEMENT, TYPE=C3D4\n2, 1, 2, 3, 5\n3, 1, 2, 3, 6\n"),
                       "2 x C3D4"));
  EXPECT_TRUE(
    contains(refusalOf("a.mesh", replaced(cubeMesh, "End", "Tetrahedra\n1\n1 2 3 5 0\nEnd")), "1 x tetrahedron"));
  EXPECT_TRUE(contains(refusalOf("a.msh",
                                 replaced(replaced(cubeMsh22, "$Elements\n2", "$Elements\n3"),
                                          "$EndElements",
                                          "3 6 0 11 22 33 5 6 7\n$EndElements")),
                       "1 x prism"));
  EXPECT_TRUE(contains(
    refusalOf(
      "a.vtk",
      replaced(replaced(cubeVtk, "CELLS 1 9\n", "CELLS 2 14\n4 0 1 2 4\n"), "CELL_TYPES 1\n", "CELL_TYPES 2\n10\n")),
    "1 x Tetra"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", replaced(cubeVtk, "\n12\n", "\n11\n")), "1 x Voxel"));
}

TEST(HexCellReader, LowerCellsAndUnusedNodesAreIgnoredAndCounted)
{
  const HexCellFile file =
    readText("a.inp",
             replaced(cubeInp, "1, 0, 0, 0\n", "99, 5, 5, 5\n1, 0, 0, 0\n") +
               "*ELEMENT, TYPE=S4R\n2, 1, 2,\n3, 4\n3, 5, 6, 7, 8\n*ELEMENT, TYPE=B31\n4, 1, 2\n");
  ASSERT_EQ(file.warnings.size(), 2U);
  EXPECT_EQ(file.warnings[0], "ignored: 1 x B31, 2 x S4R");
  EXPECT_EQ(file.warnings[1], "ignored: 1 nodes without a hexahedron");
  EXPECT_EQ(file.mesh.nodes.size(), 8U);
  EXPECT_DOUBLE_EQ(hexVolume(cellCorners(file.mesh, 0)), 1.0);
}

TEST(HexCellReader, AbaqusElementMayGoOnInTheNextLine)
{
  const HexCellFile file = readText(
    "a.inp",
    replaced(cubeInp, "1, 1, 2, 3, 4, 5, 6, 7, 8\n", "1, 1, 2, 3, 4,\n 5, 6, 7, 8\n2, 1, 2, 3, 4,\n5, 6, 7, 8,\n"));
  EXPECT_EQ(file.mesh.cells.size(), 2U);
  const HexCellFile keyword = readText("a.inp", replaced(cubeInp, "*ELEMENT, TYPE=C3D8R,", "*Element,\n type=C3D8I,"));
  EXPECT_EQ(keyword.mesh.cells.size(), 1U);
}

TEST(HexCellReader, AbaqusFeaturesThatMoveOrMakeNodesAreRefused)
{
  const std::string inp = cubeInp;
  EXPECT_TRUE(contains(refusalOf("a.inp", "*INCLUDE, INPUT=other.inp\n" + inp), "*INCLUDE"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(inp, "NSET=ALL", "INPUT=nodes.txt")), "include"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(inp, "NSET=ALL", "SYSTEM=C")), "coordinate system"));
  EXPECT_TRUE(contains(refusalOf("a.inp", inp + "*NGEN\n1, 8\n"), "*NGEN"));
  EXPECT_TRUE(contains(refusalOf("a.inp", inp + "*INSTANCE, NAME=A, PART=B\n1., 0., 0.\n"), "*INSTANCE"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(inp, "TYPE=C3D8R, ", "")), "without TYPE"));
}

TEST(HexCellReader, AbaqusElementsOfAnotherLengthAreRefused)
{
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, ", 7, 8\n", ", 7\n")), "fewer than 8 nodes"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, ", 7, 8\n", ", 7, 8, 9\n")), "more than 8 nodes"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, "4, 0, +1, 0", "4, 0, +1")), "three coordinates"));
}

TEST(HexCellReader, NodeThatIsMissingGivenTwiceOrTwiceInACellIsRefused)
{
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, ", 7, 8\n", ", 7, 9\n")), "names node 9"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, ", 7, 8\n", ", 7, -8\n")), "names node -8"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, "8, 0, 1, 1", "7, 0, 1, 1")), "node 7 is given twice"));
  EXPECT_TRUE(contains(refusalOf("a.inp", replaced(cubeInp, ", 7, 8\n", ", 7, 7\n")), "one node twice"));
  EXPECT_TRUE(contains(refusalOf("a.mesh", replaced(cubeMesh, "7 8 9", "7 0 9")), "names node 0"));
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh22, "5 6 7 8\n", "5 6 7 9\n")), "names node 9"));
  EXPECT_TRUE(
    contains(refusalOf("a.msh", replaced(cubeMsh41, "900 5 6 7 8\n", "900 5 6 7 100000000000\n")), "names node"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", replaced(cubeVtk, "5 6 7\n", "5 6 8\n")), "names node 8"));
}

TEST(HexCellReader, CoordinateThatIsNotFiniteOrHugeIsRefused)
{
  for (const char * bad : { "nan", "inf", "1e300" })
  {
    EXPECT_TRUE(
      contains(refusalOf("a.inp", replaced(cubeInp, "2, 1., 0", "2, " + std::string(bad) + ", 0")), "node 2"));
    EXPECT_TRUE(contains(refusalOf("a.mesh", replaced(cubeMesh, "1 0 0 1", std::string(bad) + " 0 0 1")), "node 2"));
    EXPECT_TRUE(
      contains(refusalOf("a.msh", replaced(cubeMsh22, "22 1 0", "22 " + std::string(bad) + " 0")), "node 22"));
  }
}

TEST(HexCellReader, CountsBeyondTheFileAreRefusedBeforeMemoryIsAskedFor)
{
  const char * const huge = "99999999999999";
  EXPECT_TRUE(contains(refusalOf("a.mesh", replaced(cubeMesh, "\n8\n", std::string("\n") + huge + "\n")), "too short"));
  EXPECT_TRUE(contains(
    refusalOf("a.mesh", replaced(cubeMesh, "Hexahedra\n1\n", std::string("Hexahedra\n") + huge + "\n")), "too short"));
  EXPECT_TRUE(
    contains(refusalOf("a.msh", replaced(cubeMsh22, "$Nodes\n8", std::string("$Nodes\n") + huge)), "too short"));
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh41, "3 1 0 4", std::string("3 1 0 ") + huge)), "too short"));
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh41, "3 1 5 1", std::string("3 1 5 ") + huge)), "too short"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", replaced(cubeVtk, "POINTS 8", "POINTS 80000")), "promises"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", replaced(cubeVtk, "\n8 0 1", "\n80000 0 1")), "beyond the list"));
}

TEST(HexCellReader, OtherVersionsAndContentsAreRefusedByName)
{
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh41, "4.1 0", "4 0")), "MSH version 4"));
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh22, "2.2 0", "1.0 0")), "MSH version 1.0"));
  EXPECT_TRUE(contains(refusalOf("a.msh", "PK\x03\x04"), "not Gmsh"));
  EXPECT_TRUE(contains(refusalOf("a.msh", replaced(cubeMsh22, "2 5 2", "2 999 2")), "unknown type 999"));
  EXPECT_TRUE(contains(refusalOf("a.mesh", "MFEM mesh v1.0\n"), "not ASCII MEDIT"));
  EXPECT_TRUE(contains(refusalOf("a.mesh", replaced(cubeMesh, "\n3\n", "\n2\n")), "dimension 2"));
  EXPECT_TRUE(contains(refusalOf("a.inp", "<html>\n"), "not an Abaqus"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", "<html>\n"), "not a readable VTK mesh"));
  EXPECT_TRUE(contains(refusalOf("a.vtk", replaced(cubeVtk, "3.0", "5-1")), "no version")); // VTK 9.1 crashes on it
  EXPECT_TRUE(contains(refusalOf("a.step", "x"), "not a mesh file's name"));
  EXPECT_THROW((void)readHexCells("/nonexistent/a.msh"), BadInput);
}

TEST(HexCellReader, BigEndianGmshIsRefusedByName)
{
  std::string bytes = readBytes(dataFile("gmsh_msh41_binary.msh"));
  const auto  one = bytes.find("4.1 1 8\n") + 8;
  std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(one), bytes.begin() + static_cast<std::ptrdiff_t>(one) + 4);
  EXPECT_TRUE(contains(refusalOf("a.msh", bytes), "big-endian"));
}

TEST(HexCellReader, FileWithoutHexahedraIsRefusedWithWhatItHas)
{
  EXPECT_TRUE(contains(
    refusalOf("a.msh",
              replaced(replaced(cubeMsh22, "$Elements\n2", "$Elements\n1"), "2 5 2 0 0 11 22 33 44 5 6 7 8\n", "")),
    "no hexahedron, only 1 x point"));
  EXPECT_TRUE(contains(refusalOf("a.mesh", "MeshVersionFormatted 2\nDimension 3\nEnd\n"), "no hexahedron"));
}

TEST(HexCellReader, GmshOfTodayIsReadWhenItIsInstalled)
{
  if (std::system("command -v gmsh > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "no gmsh here";
  }
  const TestFolder folder;
  for (const char * format : { "msh41", "msh22", "mesh", "inp", "vtk" })
  {
    const std::string name = folder / (std::string("box.") + (format[1] == 's' ? "msh" : format));
    const std::string command =
      "gmsh -3 -format " + std::string(format) + " -o '" + name + "' '" + dataFile("box.geo") + "' > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << format;
    EXPECT_NEAR(volumeOf(readHexCells(name).mesh), 6.0, 1e-9) << format;
    std::filesystem::remove(name);
  }
}
