// The contract of the module MoserHexCompare, by running the program as Slicer does.
#include "CommandTest.h"
#include "ModuleDescription.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <map>
#include <sstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

HexMesh
block(int n, const Vector3 & size)
{
  HexMesh mesh{ n, {}, 0 };
  for (int node = 0; node < n * n * n; ++node)
  {
    mesh.nodes.emplace_back(Vector3(node % n, node / n % n, node / (n * n)).cwiseProduct(size) / (n - 1));
  }
  return mesh;
}

class MoserHexCompare : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    writeHexMesh(path("a.vtk"), block(4, { 10, 10, 10 }));
    writeHexMesh(path("b.vtk"), block(4, { 12, 10, 10 }));
    writeHexMesh(path("large.vtk"), block(6, { 12, 10, 10 }));
  }
};

std::map<std::string, std::string>
returnParameters(const std::string & file)
{
  std::map<std::string, std::string> values;
  std::istringstream                 lines(contentOf(file));
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find(" = ");
    values[line.substr(0, equals)] = line.substr(equals + 3);
  }
  return values;
}

} // namespace

TEST_F(MoserHexCompare, XmlIsTheFileBesideItAndItsParametersAreInTheHelp)
{
  const Outcome xml = run({ "--xml" });
  EXPECT_EQ(xml.exitCode, 0);
  EXPECT_EQ(xml.error, "");
  EXPECT_EQ(xml.out, contentOf(MOSERHEX_MODULE_XML));
  const Outcome help = run({ "--help" });
  for (const slicer::ParameterGroup & group : slicer::parseModuleDescription(xml.out).groups)
  {
    for (const slicer::ModuleParameter & parameter : group.parameters)
    {
      EXPECT_NE(help.out.find(parameter.description), std::string::npos) << parameter.name;
    }
  }
}

TEST_F(MoserHexCompare, RunWritesModelTableAndMeasurements)
{
  const Outcome outcome = run({ "--returnparameterfile",
                                path("return.txt"),
                                "--align=none",
                                "--regions",
                                "halves",
                                "--regionTable",
                                path("table.tsv"),
                                path("a.vtk"),
                                path("b.vtk"),
                                path("out.vtk") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.out.compare(0, 15, "<filter-start>\n"), 0);
  EXPECT_NE(outcome.out.find("<filter-progress>1.000</filter-progress>"), std::string::npos) << outcome.out;

  EXPECT_EQ(readHexMesh(path("out.vtk")).nodes, block(4, { 12, 10, 10 }).nodes);
  const std::string model = contentOf(path("out.vtk"));
  for (const char * array : { "SignedDistance", "ThicknessChange", "LargestStretch", "DeformationGradient" })
  {
    EXPECT_NE(model.find(array), std::string::npos) << array;
  }
  EXPECT_NE(contentOf(path("table.tsv")).find("1\tb\t\thalves\tleft\t"), std::string::npos);

  const auto values = returnParameters(path("return.txt"));
  EXPECT_NEAR(std::stod(values.at("volumeChange")), 20.0, 1e-9);
  EXPECT_NEAR(std::stod(values.at("surfaceOut95")), 2.0, 1e-9);
  EXPECT_EQ(values.at("uniformGrowth"), "yes");
  for (const slicer::ParameterGroup & group : slicer::parseModuleDescription(contentOf(MOSERHEX_MODULE_XML)).groups)
  {
    for (const slicer::ModuleParameter & parameter : group.parameters)
    {
      EXPECT_EQ(values.count(parameter.name), parameter.isSimpleOutput() ? 1u : 0u) << parameter.name;
    }
  }
}

TEST_F(MoserHexCompare, ATransformLeadsFromTheBaselinesSpaceToTheFollowUps)
{
  HexMesh moved = block(4, { 12, 10, 10 });
  for (Vector3 & node : moved.nodes)
  {
    node += Vector3(50, 0, 0);
  }
  writeHexMesh(path("moved.vtk"), moved);
  writeTextFile(path("move.tfm"),
                "#Insight Transform File V1.0\n#Transform 0\nTransform: TranslationTransform_double_3_3\n"
                "Parameters: 50 0 0\nFixedParameters: \n");
  const Outcome outcome = run({ "--transform", path("move.tfm"), path("a.vtk"), path("moved.vtk"), path("out.vtk") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_LT((readHexMesh(path("out.vtk")).nodes.front() - Vector3(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((readHexMesh(path("out.vtk")).nodes.back() - Vector3(12, 10, 10)).norm(), 1e-9);
}

TEST_F(MoserHexCompare, TheTablesSeparatorIsThatOfItsEnding)
{
  ASSERT_EQ(run({ "--regionTable", path("table.csv"), path("a.vtk"), path("b.vtk"), path("out.vtk") }).exitCode, 0);
  EXPECT_NE(contentOf(path("table.csv")).find("1,b,,octants,"), std::string::npos);
}

TEST_F(MoserHexCompare, FailureIsOneLineAndLeavesNothing)
{
  expectErrorCode(run({ path("a.vtk"), path("large.vtk"), path("out.vtk") }), "E_PRECONDITION");
  expectErrorCode(run({ path("a.vtk"), path("none.vtk"), path("out.vtk") }), "E_NOINPUT");
  expectErrorCode(run({ path("a.vtk"), path("b.vtk"), path("a.vtk") }), "E_USAGE");
  for (const char * name : { "out.obj", "out.msh", "out.inp" })
  {
    expectErrorCode(run({ path("a.vtk"), path("b.vtk"), path(name) }), "E_USAGE");
  }
  expectErrorCode(run({ "--regionTable", path("out.vtk"), path("a.vtk"), path("b.vtk"), path("out.vtk") }), "E_USAGE");
  expectErrorCode(run({ "--align=affine", path("a.vtk"), path("b.vtk"), path("out.vtk") }), "E_USAGE");
  EXPECT_EQ(fileCount(), 3u);
}
