// Exact: the code at the end of the line, one bad file or command each; and that no code is without documentation or
// test.
#include "CommandTest.h"

#include "moserhex/Common/ErrorCode.h"

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class ErrorCodes : public CommandTest
{
protected:
  /** Writes a file and says what meshing it ends with. */
  [[nodiscard]] Outcome
  meshOf(const std::string & name, const std::string & content) const
  {
    std::ofstream(path(name), std::ios::binary) << content;
    return run({ "mesh", path(name), path("mesh.vtu"), "--quiet" });
  }
};

/** A NRRD file of unsigned bytes. */
std::string
nrrd(const std::string & fields, const std::string & voxels)
{
  return "NRRD0004\ntype: uchar\nencoding: raw\n" + fields + "\n" + voxels;
}

const std::string volume = "dimension: 3\nsizes: 4 4 4\nspace: left-posterior-superior\n";
const std::string axes = "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n";

std::string
sourceOfAllTests()
{
  std::string text;
  for (const char * folder : { "Modules", "Applications", "Testing" })
  {
    for (const auto & entry : fs::recursive_directory_iterator(fs::path(MOSERHEX_SOURCE_FOLDER) / folder))
    {
      const bool isTest = entry.path().filename().string().find("GTest.cxx") != std::string::npos;
      if (isTest && entry.path().filename() != "ErrorCodeGTest.cxx")
      {
        text += contentOf(entry.path());
      }
    }
  }
  return text;
}

/** ErrorCode's enumerators in their order, as written in the header. */
std::vector<std::string>
enumerators()
{
  std::ifstream header(fs::path(MOSERHEX_SOURCE_FOLDER) / "Modules/Core/Common/include/moserhex/Common/ErrorCode.h");
  std::vector<std::string> names;
  for (std::string line; std::getline(header, line);)
  {
    const auto comment = line.find("///< E_");
    if (comment != std::string::npos)
    {
      names.push_back(line.substr(2, line.find_first_of(", ", 2) - 2));
    }
  }
  return names;
}

} // namespace

TEST_F(ErrorCodes, ImagesEndWithTheCodeOfTheirFault)
{
  const std::string voxels(64, '\1');
  expectErrorCode(meshOf("a.nrrd", ""), "E_EMPTY");
  expectErrorCode(meshOf("a.nrrd", "PK\3\4 a zip file"), "E_FORMAT");
  expectErrorCode(meshOf("a.nrrd", nrrd("dimension: 3\nsizes: 4 4\n", voxels)), "E_HEADER");
  expectErrorCode(meshOf("a.nrrd", nrrd(volume + axes, "few")), "E_TRUNCATED");
  expectErrorCode(meshOf("a.nrrd", nrrd("dimension: 2\nsizes: 8 8\n", voxels)), "E_DIMENSION");
  expectErrorCode(meshOf("a.nrrd", nrrd(volume + "space directions: (1,0,0) (0,1,0) (0,0,0)\n", voxels)), "E_GEOMETRY");
  expectErrorCode(meshOf("a.nrrd", nrrd(volume + axes, std::string(64, '\0'))), "E_EMPTY_LABEL");
  expectErrorCode(meshOf("a.nhdr", nrrd(volume + axes + "data file: /etc/passwd\n", "")), "E_REFERENCE");
  EXPECT_FALSE(fs::exists(path("mesh.vtu")));
}

TEST_F(ErrorCodes, SurfacesEndWithTheCodeOfTheirFault)
{
  const std::string header = "OFF\n4 4 6\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n";
  const std::string three = "3 0 2 1\n3 0 1 3\n3 1 2 3\n";
  expectErrorCode(meshOf("a.off", "OFF\n4 3 6\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n" + three), "E_SURFACE_OPEN");
  expectErrorCode(meshOf("a.off", header + three + "3 2 0 7\n"), "E_SURFACE_INDEX");
  expectErrorCode(meshOf("a.off", "OFF\n4 4 6\n0 0 0\nnan 0 0\n0 9 0\n0 0 9\n" + three + "3 2 0 3\n"), "E_SURFACE_NAN");
}

TEST_F(ErrorCodes, CommandsEndWithTheCodeOfTheirFault)
{
  writeSample();
  const std::string sample = path("prostate.nrrd");
  expectErrorCode(run({ "mesh", sample }), "E_USAGE");
  expectErrorCode(run({ "mesh", path("missing.nrrd"), path("mesh.vtu") }), "E_NOINPUT");
  expectErrorCode(run({ "mesh", sample, path("mesh.vtu"), "--label", "9" }), "E_LABELS");
  expectErrorCode(run({ "mesh", sample, path("no/mesh.vtu") }), "E_CANTCREAT");
  expectErrorCode(run({ "mesh", sample, path("mesh.vtu"), "--shells=3", "--stage=initial" }, 500), "E_IO");
  std::ofstream(path("points.msh")) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  expectErrorCode(run({ "quality", path("points.msh") }), "E_NOT_HEXAHEDRA");
}

TEST_F(ErrorCodes, EveryCodeIsDocumentedWithItsExitStatus)
{
  const std::string page = contentOf(fs::path(MOSERHEX_SOURCE_FOLDER) / "Documentation/Errors.md");
  for (int code = 0; code <= static_cast<int>(lastErrorCode); ++code)
  {
    const auto        errorCode = static_cast<ErrorCode>(code);
    const std::string row =
      "| `" + std::string(nameOf(errorCode)) + "` | " + std::to_string(exitStatusOf(errorCode)) + " |";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST_F(ErrorCodes, EveryCodeIsExpectedBySomeTest)
{
  const std::string              tests = sourceOfAllTests();
  const std::vector<std::string> names = enumerators();
  ASSERT_EQ(names.size(), static_cast<std::size_t>(lastErrorCode) + 1);
  for (std::size_t code = 0; code < names.size(); ++code)
  {
    const std::string inText = "\"" + std::string(nameOf(static_cast<ErrorCode>(code))) + "\"";
    const bool        isTested =
      tests.find("ErrorCode::" + names[code]) != std::string::npos || tests.find(inText) != std::string::npos;
    EXPECT_TRUE(isTested) << names[code] << " is in no test";
  }
}
