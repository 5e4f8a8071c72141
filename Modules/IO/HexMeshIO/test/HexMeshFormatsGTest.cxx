// Meshes for finite-element programs. Exact: connectivity, sets, bytes; coordinates to the last bit (.inp: 1e-15 mm).
// CalculiX prints 7 digits: 1e-6 of the volume.
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include "FullDisk.h"
#include "TestFolder.h"
#include "TestLattice.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <sstream>

using namespace moserhex;

namespace
{

double
volumeOf(const HexMesh & mesh)
{
  const auto volumes = cellVolumes(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

std::string
written(const std::string & name, const HexMesh & mesh, const HexMeshFields & fields = {}, GmshVersion version = {})
{
  const TestFolder     folder;
  HexMeshWriterOptions options;
  options.gmshVersion = version;
  writeHexMesh(folder / name, mesh, fields, options);
  return readBytes(folder / name);
}

/** The text behind `begin` up to `end`. */
std::string
between(const std::string & text, const std::string & begin, const std::string & end)
{
  const auto from = text.find(begin);
  EXPECT_NE(from, std::string::npos) << begin;
  const auto start = from == std::string::npos ? text.size() : from + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

std::vector<std::size_t>
numbersIn(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream       stream(text);
  std::vector<std::size_t> numbers;
  for (std::size_t number = 0; stream >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

std::size_t
countOf(const std::string & text, const std::string & part)
{
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
  {
    ++count;
  }
  return count;
}

/** Nodes of the lattice of four nodes per side on its six faces, numbered from 1, by hand. */
struct FaceNodes
{
  const char *             name;
  std::vector<std::size_t> nodes;
};

const FaceNodes facesOfFour[] = {
  { "FACE_I0", { 1, 5, 9, 13, 17, 21, 25, 29, 33, 37, 41, 45, 49, 53, 57, 61 } },
  { "FACE_I1", { 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64 } },
  { "FACE_J0", { 1, 2, 3, 4, 17, 18, 19, 20, 33, 34, 35, 36, 49, 50, 51, 52 } },
  { "FACE_J1", { 13, 14, 15, 16, 29, 30, 31, 32, 45, 46, 47, 48, 61, 62, 63, 64 } },
  { "FACE_K0", { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16 } },
  { "FACE_K1", { 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64 } },
};

/** Corners 1, 2, ... of quadrilaterals, sorted and once each. */
std::vector<std::size_t>
sortedOnce(std::vector<std::size_t> nodes)
{
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/** Whether the quadrilaterals (node numbers from 1) of a lattice centred on c face away from it. */
bool
faceOutwards(const HexMesh & mesh, const std::vector<std::size_t> & corners)
{
  Vector3 centre = Vector3::Zero();
  for (const Vector3 & node : mesh.nodes)
  {
    centre += node / static_cast<double>(mesh.nodes.size());
  }
  for (std::size_t i = 0; i + 3 < corners.size(); i += 4)
  {
    const Vector3 & a = mesh.nodes[corners[i] - 1];
    const Vector3 & b = mesh.nodes[corners[i + 1] - 1];
    const Vector3 & c = mesh.nodes[corners[i + 2] - 1];
    if ((b - a).cross(c - a).dot(a - centre) <= 0.0)
    {
      return false;
    }
  }
  return !corners.empty();
}

/** The cells of a mesh in another order of nodes and cells, by the lattice's nodes in the same places, sorted. */
std::vector<std::array<std::size_t, 8>>
latticeNumbersOf(const UnstructuredHexMesh & read, const HexMesh & mesh)
{
  std::vector<std::size_t> numbers;
  for (const Vector3 & node : read.nodes)
  {
    const auto found = std::find_if(mesh.nodes.begin(), mesh.nodes.end(), [&node](const Vector3 & other) {
      return (node - other).cwiseAbs().maxCoeff() <= 1e-12;
    });
    numbers.push_back(static_cast<std::size_t>(found - mesh.nodes.begin()));
  }
  auto cells = read.cells;
  for (auto & cell : cells)
  {
    std::transform(cell.begin(), cell.end(), cell.begin(), [&numbers](std::size_t node) { return numbers[node]; });
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

bool
commandSucceeds(const std::string & command)
{
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

bool
hasMeshio()
{
  return commandSucceeds("/usr/bin/python3 -c 'import meshio'");
}

std::string
endingOf(const testing::TestParamInfo<const char *> & instance)
{
  return std::string(instance.param).substr(5);
}

} // namespace

class HexMeshFormats : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(Formats,
                         HexMeshFormats,
                         testing::Values("mesh.msh", "mesh.inp", "mesh.mesh", "mesh.feb", "mesh.exo"),
                         endingOf);

TEST_P(HexMeshFormats, SameMeshGivesTheSameBytes)
{
  const HexMesh mesh = bentLattice(6);
  const auto    first = written(GetParam(), mesh, someFields(mesh));
  EXPECT_GT(first.size(), 1000U);
  EXPECT_EQ(written(GetParam(), mesh, someFields(mesh)), first);
}

TEST_P(HexMeshFormats, FullDiskIsReportedAndKeepsTheOldFile)
{
  const TestFolder folder;
  const auto       write = [&] { writeHexMesh(folder / GetParam(), bentLattice(12)); };
  EXPECT_TRUE(reportsFullDisk(write));
  EXPECT_EQ(folder.fileCount(), 0U);
  writeBytes(folder / GetParam(), "old");
  EXPECT_TRUE(reportsFullDisk(write));
  EXPECT_EQ(readBytes(folder / GetParam()), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST_P(HexMeshFormats, FolderThatIsMissingIsReported)
{
  const TestFolder folder;
  EXPECT_EQ(codeThrownBy([&] { writeHexMesh(folder / (std::string("no/") + GetParam()), bentLattice(4)); }),
            ErrorCode::CannotCreate);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST_P(HexMeshFormats, NodeThatIsNotFiniteIsRefused)
{
  const TestFolder folder;
  HexMesh          mesh = bentLattice(4);
  mesh.nodes[5].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeHexMesh(folder / GetParam(), mesh), InvalidInput);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST_P(HexMeshFormats, SmallestMeshIsWritten)
{
  EXPECT_FALSE(written(GetParam(), bentLattice(2)).empty());
  EXPECT_FALSE(written(GetParam(), bentLattice(5)).empty());
}

TEST_P(HexMeshFormats, CapitalEndingIsTheSameFormat)
{
  std::string capital = GetParam();
  std::transform(
    capital.begin() + 5, capital.end(), capital.begin() + 5, [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  EXPECT_TRUE(isHexMeshName(capital));
  EXPECT_EQ(written(capital, bentLattice(4)), written(GetParam(), bentLattice(4)));
}

class ReadableHexMeshFormats : public testing::TestWithParam<const char *>
{};
INSTANTIATE_TEST_SUITE_P(Formats,
                         ReadableHexMeshFormats,
                         testing::Values("mesh.msh", "mesh.inp", "mesh.mesh"),
                         endingOf);

TEST_P(ReadableHexMeshFormats, RoundTripKeepsNodesAndConnectivity)
{
  for (const GmshVersion version : { GmshVersion::Msh41, GmshVersion::Msh22 })
  {
    const TestFolder     folder;
    const HexMesh        mesh = bentLattice(7);
    HexMeshWriterOptions options;
    options.gmshVersion = version;
    writeHexMesh(folder / GetParam(), mesh, someFields(mesh), options);
    EXPECT_EQ(folder.fileCount(), 1U);
    EXPECT_EQ(readHexCells(folder / GetParam()).mesh.cells, unstructured(mesh).cells);
    const HexMesh read = readHexMesh(folder / GetParam());
    ASSERT_EQ(read.nodesPerSide, 7);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    {
      const double bound = std::string(GetParam()) == "mesh.inp" ? 1e-15 : 0.0;
      EXPECT_LE((read.nodes[node] - mesh.nodes[node]).cwiseAbs().maxCoeff(), bound) << node;
    }
  }
}

TEST_P(ReadableHexMeshFormats, MeshThatIsNoLatticeIsRefused)
{
  const TestFolder  folder;
  const std::string cube = "MeshVersionFormatted 2\nDimension 3\nVertices\n12\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
                           "0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n0 0 2 0\n1 0 2 0\n1 1 2 0\n0 1 2 0\nHexahedra\n2\n"
                           "1 2 3 4 5 6 7 8 0\n5 6 7 8 9 10 11 12 0\nEnd\n";
  writeBytes(folder / "two.mesh", cube);
  EXPECT_EQ(codeThrownBy([&] { (void)readHexMesh(folder / "two.mesh"); }), ErrorCode::NotHexahedra);
}

TEST(AbaqusWriter, SetsOfFourNodesPerSideAreThoseByHand)
{
  const std::string text = written("a.inp", bentLattice(4));
  for (const FaceNodes & face : facesOfFour)
  {
    EXPECT_EQ(numbersIn(between(text, std::string("*NSET, NSET=") + face.name + "\n", "*")), face.nodes) << face.name;
  }
  EXPECT_EQ(numbersIn(between(text, "*ELSET, ELSET=SHELL_1\n", "*")), std::vector<std::size_t>{ 14 });
  EXPECT_EQ(numbersIn(between(text, "*ELSET, ELSET=SHELL_2\n", "*")).size(), 26U);
  EXPECT_EQ(countOf(text, "SHELL_"), 2U * 1U);
  EXPECT_NE(text.find("*NODE, NSET=ALL\n"), std::string::npos);
  EXPECT_NE(text.find("*ELEMENT, TYPE=C3D8, ELSET=ALL\n1, 1, 2, 6, 5, 17, 18, 22, 21\n"), std::string::npos);
}

TEST(AbaqusWriter, LinesHaveAtMostSixteenNumbersOfTwentyCharacters)
{
  HexMesh mesh = bentLattice(8);
  mesh.nodes[9].x() =
    -1.2345678901234567e-5; // as shortest text 23 characters, of which 20 would be -1.2345678901234567
  mesh.nodes[10].x() = -0.0;
  mesh.nodes[11].x() = 5e-324;
  std::istringstream lines(written("a.inp", mesh));
  std::size_t        widest = 0;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.empty() || line[0] == '*' || line.compare(0, 4, "Mose") == 0)
    {
      continue;
    }
    EXPECT_EQ(line.find('e'), std::string::npos) << line;
    EXPECT_LE(std::count(line.begin(), line.end(), ','), 15) << line;
    for (std::size_t begin = 0; begin < line.size();)
    {
      const auto end = std::min(line.find(", ", begin), line.size());
      widest = std::max(widest, end - begin);
      begin = end + 2;
    }
  }
  EXPECT_EQ(widest, 20U);
}

TEST(MeditWriter, ReferencesAreFacesAndShells)
{
  const HexMesh                         mesh = bentLattice(4);
  const std::string                     text = written("a.mesh", mesh);
  std::istringstream                    sides(between(text, "Quadrilaterals\n54\n", "Hexahedra"));
  std::vector<std::vector<std::size_t>> corners(7);
  for (std::array<std::size_t, 5> line{}; sides >> line[0] >> line[1] >> line[2] >> line[3] >> line[4];)
  {
    ASSERT_GE(line[4], 1U);
    ASSERT_LE(line[4], 6U);
    corners[line[4]].insert(corners[line[4]].end(), line.begin(), line.begin() + 4);
  }
  for (std::size_t face = 1; face <= 6; ++face)
  {
    EXPECT_EQ(corners[face].size(), 36U);
    EXPECT_EQ(sortedOnce(corners[face]), facesOfFour[face - 1].nodes);
    EXPECT_TRUE(faceOutwards(mesh, corners[face])) << face;
  }
  const auto cells = numbersIn(between(text, "Hexahedra\n27\n", "End"));
  ASSERT_EQ(cells.size(), 27U * 9U);
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    EXPECT_EQ(cells[9 * cell + 8], cell == 13 ? 1U : 2U) << cell;
  }
}

TEST(GmshWriter, GroupsAreFacesAndShells)
{
  const HexMesh mesh = bentLattice(4);
  for (const GmshVersion version : { GmshVersion::Msh41, GmshVersion::Msh22 })
  {
    const std::string text = written("a.msh", mesh, {}, version);
    EXPECT_EQ(between(text, "$PhysicalNames\n", "$End"),
              "8\n2 1 \"FACE_I0\"\n2 2 \"FACE_I1\"\n2 3 \"FACE_J0\"\n2 4 \"FACE_J1\"\n2 5 \"FACE_K0\"\n"
              "2 6 \"FACE_K1\"\n3 1 \"SHELL_1\"\n3 2 \"SHELL_2\"\n");
  }
  const std::string msh41 = written("a.msh", mesh);
  EXPECT_EQ(msh41.compare(0, 21, "$MeshFormat\n4.1 0 8\n$"), 0);
  const std::string elements = between(msh41, "$Elements\n", "$End");
  EXPECT_EQ(elements.compare(0, 54, "8 81 1 81\n3 1 5 1\n14 22 23 27 26 38 39 43 42\n3 2 5 26\n"), 0) << elements;
  for (std::size_t face = 1; face <= 6; ++face)
  {
    const std::string head = "\n2 " + std::to_string(face) + " 3 9\n";
    const auto        lines = numbersIn(elements.substr(elements.find(head) + head.size()));
    ASSERT_GE(lines.size(), 45U);
    std::vector<std::size_t> corners;
    for (std::size_t line = 0; line < 9; ++line)
    {
      corners.insert(corners.end(),
                     lines.begin() + static_cast<std::ptrdiff_t>(5 * line + 1),
                     lines.begin() + static_cast<std::ptrdiff_t>(5 * line + 5));
    }
    EXPECT_EQ(sortedOnce(corners), facesOfFour[face - 1].nodes);
    EXPECT_TRUE(faceOutwards(mesh, corners)) << face;
  }
  const std::string msh22 = written("a.msh", mesh, {}, GmshVersion::Msh22);
  EXPECT_EQ(msh22.compare(0, 21, "$MeshFormat\n2.2 0 8\n$"), 0);
  EXPECT_NE(msh22.find("\n14 5 2 1 1 22 23 27 26 38 39 43 42\n"), std::string::npos);
  EXPECT_NE(msh22.find("\n1 5 2 2 2 1 2 6 5 17 18 22 21\n"), std::string::npos);
  EXPECT_NE(msh22.find("\n28 3 2 1 1 1 17 21 5\n"), std::string::npos);
}

TEST(GmshWriter, FieldsHaveTheirNames)
{
  const HexMesh mesh = bentLattice(4);
  for (const GmshVersion version : { GmshVersion::Msh41, GmshVersion::Msh22 })
  {
    const std::string text = written("a.msh", mesh, someFields(mesh), version);
    for (const char * name : { "Shell", "VolumeRatio", "ScaledJacobian", "Label" })
    {
      const std::string head = std::string("$ElementData\n1\n\"") + name + "\"\n1\n0\n3\n0\n1\n81\n";
      EXPECT_NE(text.find(head), std::string::npos) << name;
    }
    EXPECT_NE(text.find("\"ScaledJacobian\"\n"), std::string::npos);
    EXPECT_NE(between(text, "\"ScaledJacobian\"", "$End").find("\n27 0.034482758620689655\n"), std::string::npos);
    EXPECT_NE(between(text, "\"LatticeIndex\"", "$End").find("\n64 3 3 3\n"), std::string::npos);
    EXPECT_NE(text.find("\"CubeCoordinate\"\n1\n0\n3\n0\n3\n64\n"), std::string::npos);
    EXPECT_EQ(written("a.msh", mesh, {}, version).find("Label"), std::string::npos);
  }
}

TEST(FebioWriter, PartsSetsAndSurfacesAreThere)
{
  const HexMesh     mesh = bentLattice(4);
  const std::string text = written("a.feb", mesh);
  for (const FaceNodes & face : facesOfFour)
  {
    EXPECT_EQ(numbersIn(between(text, std::string("<NodeSet name=\"") + face.name + "\">", "<")), face.nodes);
    std::string              surface = between(text, std::string("<Surface name=\"") + face.name + "\">", "</Surface>");
    std::vector<std::size_t> corners;
    for (std::size_t side = 1; side <= 9; ++side)
    {
      const auto four = numbersIn(between(surface, "<quad4 id=\"" + std::to_string(side) + "\">", "<"));
      EXPECT_EQ(four.size(), 4U);
      corners.insert(corners.end(), four.begin(), four.end());
    }
    EXPECT_EQ(sortedOnce(corners), face.nodes);
    EXPECT_TRUE(faceOutwards(mesh, corners)) << face.name;
  }
  EXPECT_NE(text.find("<febio_spec version=\"4.0\">"), std::string::npos);
  EXPECT_EQ(countOf(text, "<node id="), 64U);
  EXPECT_EQ(countOf(text, "<elem id="), 27U);
  EXPECT_EQ(between(text, "<Elements type=\"hex8\" name=\"SHELL_1\">\n", "    </Elements>"),
            "      <elem id=\"14\">22,23,27,26,38,39,43,42</elem>\n");
  EXPECT_EQ(countOf(text, "<SolidDomain name=\"SHELL_"), 2U);
  EXPECT_EQ(countOf(text, "mat=\"placeholder\""), 2U);
}

TEST(FebioWriter, NodesComeBackToTheLastBit)
{
  const HexMesh     mesh = bentLattice(5);
  const std::string text = written("a.feb", mesh);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    std::string words = between(text, "<node id=\"" + std::to_string(node + 1) + "\">", "<");
    std::replace(words.begin(), words.end(), ',', ' ');
    std::istringstream stream(words);
    Vector3            position;
    stream >> position.x() >> position.y() >> position.z();
    EXPECT_EQ(position, mesh.nodes[node]) << words;
  }
}

TEST(FebioWriter, XmllintTakesItWhenItIsInstalled)
{
  if (!commandSucceeds("command -v xmllint"))
  {
    GTEST_SKIP() << "no xmllint here";
  }
  const TestFolder folder;
  writeHexMesh(folder / "a.feb", bentLattice(6));
  EXPECT_TRUE(commandSucceeds("xmllint --noout '" + folder / "a.feb" + "'"));
}

TEST(FormatsOfOtherTools, GmshReadsWhatIsWrittenWhenItIsInstalled)
{
  if (!commandSucceeds("command -v gmsh"))
  {
    GTEST_SKIP() << "no gmsh here";
  }
  const HexMesh mesh = bentLattice(6);
  for (const char * name : { "a.msh", "22.msh", "a.mesh" })
  {
    const TestFolder     folder;
    HexMeshWriterOptions options;
    options.gmshVersion = name[0] == '2' ? GmshVersion::Msh22 : GmshVersion::Msh41;
    writeHexMesh(folder / name, mesh, someFields(mesh), options);
    const std::string again = folder / "again.msh";
    ASSERT_TRUE(commandSucceeds("gmsh -0 -save_all -format msh22 -o '" + again + "' '" + folder / name + "'")) << name;
    EXPECT_EQ(latticeNumbersOf(readHexCells(again).mesh, mesh), unstructured(mesh).cells) << name;
    if (std::string(name).find(".msh") != std::string::npos)
    {
      const std::string text = readBytes(again);
      EXPECT_NE(text.find("\"FACE_K1\""), std::string::npos) << name;
      EXPECT_NE(text.find("\"SHELL_3\""), std::string::npos) << name;
    }
  }
}

TEST(FormatsOfOtherTools, MeshioReadsWhatIsWrittenWhenItIsInstalled)
{
  if (!hasMeshio())
  {
    GTEST_SKIP() << "no python3-meshio here";
  }
  const HexMesh    mesh = bentLattice(6);
  const TestFolder folder;
  // Not MSH 2.2: meshio 5.0 takes no cell data there with more than one type of cells.
  // Nodes and cells exactly as in the .vtk; cell data of .msh, and sets of .inp, by their numbers.
  const char * const script = "import sys, numpy, meshio\n"
                              "folder, name = sys.argv[1:]\n"
                              "v = meshio.read(folder + 'reference.vtk')\n"
                              "m = meshio.read(folder + name)\n"
                              "hexes = numpy.vstack([c.data for c in m.cells if c.type == 'hexahedron'])\n"
                              "hexes = hexes[numpy.argsort(hexes[:, 0])]\n"
                              "assert numpy.abs(m.points - v.points).max() <= 1e-15\n"
                              "assert (hexes == v.cells[0].data).all()\n"
                              "if name.endswith('.msh'):\n"
                              "    order = {tuple(c): i for i, c in enumerate(v.cells[0].data)}\n"
                              "    for field in ('Shell', 'VolumeRatio', 'ScaledJacobian', 'Label'):\n"
                              "        for block, data in zip(m.cells, m.cell_data[field]):\n"
                              "            if block.type == 'hexahedron':\n"
                              "                where = [order[tuple(c)] for c in block.data]\n"
                              "                assert (v.cell_data[field][0][where] == data.ravel()).all(), field\n"
                              "    assert (m.point_data['LatticeIndex'] == v.point_data['LatticeIndex']).all()\n"
                              "    assert set(m.field_data) >= {'FACE_I0', 'FACE_K1', 'SHELL_1', 'SHELL_3'}\n"
                              "if name.endswith('.inp'):\n"
                              "    i0 = m.point_sets['FACE_I0']\n"
                              "    assert len(i0) == 36 and (v.point_data['LatticeIndex'][i0][:, 0] == 0).all()\n"
                              "    shell = m.cell_sets['SHELL_2'][0]\n"
                              "    assert (v.cell_data['Shell'][0][shell] == 2).all() and len(shell) == 26\n";
  writeBytes(folder / "check.py", script);
  writeHexMesh(folder / "reference.vtk", mesh, someFields(mesh));
  for (const char * name : { "a.msh", "a.mesh", "a.inp" })
  {
    writeHexMesh(folder / name, mesh, someFields(mesh));
    const std::string command = "/usr/bin/python3 '" + folder / "check.py" + "' '" + folder / "" + "' " + name;
    EXPECT_EQ(std::system((command + " > '" + folder / "log" + "' 2>&1").c_str()), 0)
      << name << ": " << readBytes(folder / "log");
  }
}

TEST(FormatsOfOtherTools, CalculiXFindsTheSameVolumeWhenItIsInstalled)
{
  if (!commandSucceeds("command -v ccx"))
  {
    GTEST_SKIP() << "no ccx here";
  }
  const HexMesh    mesh = bentLattice(8);
  const TestFolder folder;
  writeHexMesh(folder / "mesh.inp", mesh);
  writeBytes(folder / "job.inp",
             "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=SOFT\n*ELASTIC\n1., 0.3\n"
             "*SOLID SECTION, ELSET=ALL, MATERIAL=SOFT\n*BOUNDARY\nFACE_K0, 1, 3\n*STEP\n*STATIC\n"
             "*BOUNDARY\nFACE_K1, 3, 3, 0.01\n*EL PRINT, ELSET=ALL, TOTALS=ONLY\nEVOL\n"
             "*EL PRINT, ELSET=SHELL_4, TOTALS=ONLY\nEVOL\n*END STEP\n");
  ASSERT_TRUE(commandSucceeds("cd '" + folder / "" + "' && OMP_NUM_THREADS=1 ccx job"));
  const std::string output = readBytes(folder / "job.dat");
  const auto        volumeBehind = [&output](const std::string & set) {
    const auto at = output.find("for set " + set);
    EXPECT_NE(at, std::string::npos) << output;
    return at == std::string::npos ? 0.0 : std::strtod(output.c_str() + output.find('\n', at), nullptr);
  };
  EXPECT_NEAR(volumeBehind("ALL") / volumeOf(mesh), 1.0, 1e-6) << output;
  double     outermost = 0.0;
  const auto volumes = cellVolumes(mesh);
  for (int cell = 0; cell < 343; ++cell)
  {
    const auto inner = [](int index) { return index > 0 && index < 6; };
    outermost +=
      inner(cell % 7) && inner(cell / 7 % 7) && inner(cell / 49) ? 0.0 : volumes[static_cast<std::size_t>(cell)];
  }
  EXPECT_NEAR(volumeBehind("SHELL_4") / outermost, 1.0, 1e-6) << output;
}
