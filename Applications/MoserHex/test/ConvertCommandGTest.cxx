// Exact: exit codes, streams and files of moserhex convert.
#include "CommandTest.h"

#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <filesystem>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class ConvertCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    m_Mesh.nodesPerSide = 4;
    for (int node = 0; node < 64; ++node)
    {
      m_Mesh.nodes.emplace_back(node % 4 / 3.0, node / 4 % 4 + 0.1 * (node % 4), node / 16 * 1.1);
    }
    writeHexMesh(path("a.vtu"), m_Mesh);
  }

  HexMesh m_Mesh;
};

} // namespace

TEST_F(ConvertCommand, MeshGoesThroughEveryFormatUnchanged)
{
  std::string last = "a.vtu";
  for (const std::string next : { "b.msh", "c.inp", "d.mesh", "e.vtk", "f.vtu" })
  {
    const Outcome outcome = run({ "convert", path(last), path(next) });
    ASSERT_EQ(outcome.exitCode, 0) << next << outcome.error;
    EXPECT_NE(outcome.out.find(next + ": 64 nodes, 27 cells\n"), std::string::npos) << outcome.out;
    last = next;
  }
  const HexMesh read = readHexMesh(path("f.vtu"));
  for (std::size_t node = 0; node < 64; ++node)
  {
    EXPECT_LE((read.nodes[node] - m_Mesh.nodes[node]).cwiseAbs().maxCoeff(), 1e-15) << node;
  }
  EXPECT_EQ(run({ "convert", path("a.vtu"), path("g.feb"), "--quiet" }).out, "");
  EXPECT_TRUE(fs::exists(path("g.feb")));
}

TEST_F(ConvertCommand, TheTurnOfTheLatticeIsKept)
{
  HexMeshFields fields;
  fields.meshArrays = { { "LatticeTurn", 3, { 0.0, 0.0, 45.0 } } };
  writeHexMesh(path("turned.vtu"), m_Mesh, fields);
  ASSERT_EQ(run({ "convert", path("turned.vtu"), path("b.vtk"), "--quiet" }).exitCode, 0);
  const HexMeshFile read = readHexMeshFile(path("b.vtk"));
  ASSERT_EQ(read.meshArrays.size(), 1u);
  EXPECT_EQ(read.meshArrays[0].values, fields.meshArrays[0].values);
  EXPECT_EQ(run({ "convert", path("turned.vtu"), path("b.msh"), "--quiet" }).exitCode, 0);
}

TEST_F(ConvertCommand, GmshVersionIsChosen)
{
  const auto headOf = [this](const std::string & name) { return contentOf(path(name)).substr(0, 15); };
  ASSERT_EQ(run({ "convert", path("a.vtu"), path("b.msh"), "--gmsh-version", "2.2" }).exitCode, 0);
  EXPECT_EQ(headOf("b.msh"), "$MeshFormat\n2.2");
  ASSERT_EQ(run({ "convert", path("a.vtu"), path("b.msh") }).exitCode, 0);
  EXPECT_EQ(headOf("b.msh"), "$MeshFormat\n4.1");
  expectErrorCode(run({ "convert", path("a.vtu"), path("b.msh"), "--gmsh-version", "4.0" }), "E_USAGE");
}

TEST_F(ConvertCommand, WhatIsIgnoredIsCounted)
{
  ASSERT_EQ(run({ "convert", path("a.vtu"), path("b.mesh"), "--quiet" }).exitCode, 0);
  const Outcome outcome = run({ "convert", path("b.mesh"), path("c.vtu"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "warning: ignored: 54 x quadrilateral\n");
}

TEST_F(ConvertCommand, MeshThatIsNoLatticeIsRefused)
{
  std::ofstream(path("two.inp")) << "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
                                    "9,0,0,2\n10,1,0,2\n11,1,1,2\n12,0,1,2\n*ELEMENT,TYPE=C3D8\n"
                                    "1,1,2,3,4,5,6,7,8\n2,5,6,7,8,9,10,11,12\n";
  expectErrorCode(run({ "convert", path("two.inp"), path("b.vtu") }), "E_NOT_HEXAHEDRA");
  EXPECT_FALSE(fs::exists(path("b.vtu")));
}

TEST_F(ConvertCommand, RefusesWithTheExitCodesOfTheOthers)
{
  expectOneLineError(run({ "convert" }), 2);
  expectOneLineError(run({ "convert", path("a.vtu"), path("b.xyz") }), 2);
  expectOneLineError(run({ "convert", path("a.vtu"), path("a.vtu") }), 2);
  expectOneLineError(run({ "convert", path("missing.vtu"), path("b.msh") }), 3);
  expectErrorCode(run({ "convert", path("a.stl"), path("b.msh") }), "E_FORMAT");
  expectErrorCode(run({ "convert", path("a.vtu"), path("no/b.msh") }), "E_CANTCREAT");
  EXPECT_EQ(fileCount(), 1U);
}

TEST_F(ConvertCommand, FullDiskKeepsTheOldFile)
{
  for (const char * name : { "b.msh", "b.inp", "b.mesh", "b.feb", "b.exo" })
  {
    std::ofstream(path(name)) << "old";
    expectErrorCode(run({ "convert", path("a.vtu"), path(name) }, 2000), "E_IO");
    EXPECT_EQ(contentOf(path(name)), "old");
  }
  EXPECT_EQ(fileCount(), 6U);
}
