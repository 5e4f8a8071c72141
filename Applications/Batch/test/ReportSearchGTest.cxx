// Exact: which files are found, and what they are called.
#include "ReportSearch.h"
#include "Summary.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

void
writeReport(const std::string & fileName, const std::string & mesh)
{
  fs::create_directories(fs::path(fileName).parent_path());
  RunReport report;
  report.versions.moserhex = "1.2.3";
  report.input.file = "in.nrrd";
  report.mesh.file = mesh;
  writeRunReport(fileName, report);
}

} // namespace

TEST(ReportSearch, FindsReportsOnlySortedByTheirPaths)
{
  const TestFolder folder;
  for (const char * name : { "sub-2/b.json", "sub-2/a.json", "sub-1/c.json", ".hidden/d.json", ".e.json", "f.jsonl" })
  {
    writeReport(folder / name, "x.vtk");
  }
  writeBytes(folder / "summary.json", "{\"done\": 1}");
  fs::create_directory_symlink(folder / "sub-1", folder / "link");
  std::vector<std::string> names;
  for (const BatchCase & batchCase : casesOfReports(folder / "", 2).cases)
  {
    names.push_back(batchCase.name);
    EXPECT_EQ(batchCase.options.input.file, "in.nrrd");
  }
  EXPECT_EQ(names, (std::vector<std::string>{ "sub-1/c.vtk", "sub-2/a.vtk", "sub-2/b.vtk" }));
}

TEST(ReportSearch, MeshIsTakenBesideTheReportFirst)
{
  const TestFolder folder;
  const auto       mesh = [&folder] { return casesOfReports(folder / "", 1).cases.at(0).options.output; };
  writeReport(folder / "a.json", "/elsewhere/mesh.vtu");
  EXPECT_EQ(mesh(), "/elsewhere/mesh.vtu");
  EXPECT_EQ(summarise(casesOfReports(folder / "", 1), 1).at(0).status, CaseStatus::Missing);
  writeBytes(folder / "mesh.vtu", "mesh");
  EXPECT_EQ(mesh(), folder / "mesh.vtu");
  writeBytes(folder / "a.vtu", "mesh");
  EXPECT_EQ(mesh(), folder / "a.vtu");
  EXPECT_EQ(summarise(casesOfReports(folder / "", 1), 1).at(0).status, CaseStatus::Done);
}

TEST(ReportSearch, FolderWithoutReportsIsRefused)
{
  const TestFolder folder;
  EXPECT_EQ(codeThrownBy([&] { (void)casesOfReports(folder / "", 1); }), ErrorCode::NoInput);
  EXPECT_THROW((void)casesOfReports(folder / "missing", 1), Error);
}
