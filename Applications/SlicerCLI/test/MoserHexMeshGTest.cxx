// The contract of a module of 3D Slicer, by running the program as Slicer does.
#include "CommandTest.h"
#include "ModuleDescription.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <sstream>
#include <thread>

#include <unistd.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

namespace fs = std::filesystem;

class MoserHexMesh : public CommandTest
{
protected:
  /** A quick run on the sample. */
  [[nodiscard]] std::vector<std::string>
  quickRun() const
  {
    return { "--shells", "3", path("prostate.nrrd"), path("mesh.vtk") };
  }
};

/** Text between each <tag> and </tag>. */
std::vector<std::string>
textsOf(const std::string & out, const std::string & tag)
{
  std::vector<std::string> texts;
  const std::string        begin = "<" + tag + ">";
  for (std::size_t at = out.find(begin); at != std::string::npos; at = out.find(begin, at + 1))
  {
    const std::size_t first = at + begin.size();
    texts.push_back(out.substr(first, out.find("</" + tag + ">", first) - first));
  }
  return texts;
}

/** "" where a character is not of the alphabet or the end is not filled up to four. */
std::string
fromBase64(const std::string & text)
{
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t end = std::min(text.find('='), text.size());
  std::string       bytes;
  unsigned int      bits = 0;
  int               count = 0;
  for (std::size_t i = 0; i < end; ++i)
  {
    const std::size_t digit = alphabet.find(text[i]);
    if (digit == std::string::npos || text.size() % 4 != 0)
    {
      return "";
    }
    bits = (bits << 6U | static_cast<unsigned int>(digit)) & 0xffffU;
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned int>(count) & 0xffU);
    }
  }
  return bytes;
}

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

TEST_F(MoserHexMesh, XmlIsTheFileBesideItAndNothingElse)
{
  const Outcome outcome = run({ "--xml" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.out.compare(0, 6, "<?xml "), 0);
  EXPECT_EQ(outcome.out, contentOf(MOSERHEX_MODULE_XML));
  EXPECT_EQ(fs::path(MOSERHEX_EXECUTABLE).filename().string().find('.'), std::string::npos);
}

TEST_F(MoserHexMesh, HelpNamesEveryParameterAndVersionIsOneLine)
{
  const slicer::ModuleDescription module = slicer::parseModuleDescription(contentOf(MOSERHEX_MODULE_XML));
  const Outcome                   help = run({ "--help" });
  EXPECT_EQ(help.exitCode, 0);
  for (const slicer::ParameterGroup & group : module.groups)
  {
    for (const slicer::ModuleParameter & parameter : group.parameters)
    {
      const std::string name = parameter.longFlag.empty() ? parameter.name : "--" + parameter.longFlag;
      EXPECT_NE(help.out.find(name), std::string::npos) << name;
      EXPECT_NE(help.out.find(parameter.description), std::string::npos) << name;
    }
  }
  const Outcome version = run({ "--version" });
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1) << version.out;
}

TEST_F(MoserHexMesh, LogoIsSixLinesAndItsPixelsArePackedAsTheySay)
{
  const Outcome outcome = run({ "--logo" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 6);
  EXPECT_EQ(outcome.out.back(), '\n');
  std::istringstream logo(outcome.out);
  std::string        mark;
  std::size_t        width = 0;
  std::size_t        height = 0;
  std::size_t        pixel = 0;
  std::size_t        length = 0;
  std::string        data;
  logo >> mark >> width >> height >> pixel >> length >> data;
  ASSERT_TRUE(logo);
  EXPECT_EQ(mark, "LOGO");
  EXPECT_GE(width, 16u);
  EXPECT_EQ(height, width);
  EXPECT_EQ(pixel, 4u);
  EXPECT_EQ(data.size(), length);
  const std::string pixels = fromBase64(data);
  ASSERT_EQ(pixels.size(), width * height * pixel); // as they are: what has another size, Slicer takes for compressed
  for (std::size_t i = 3; i < pixels.size(); i += pixel)
  {
    ASSERT_EQ(pixels[i], '\xff') << "not opaque: pixel " << i / pixel;
  }
  const std::size_t middle = (height / 2 * width + width / 2) * pixel;
  EXPECT_NE(pixels.substr(0, 3), pixels.substr(middle, 3));
}

TEST_F(MoserHexMesh, RunWritesAllOutputsAndTellsItsProgress)
{
  writeSample();
  const Outcome outcome = run({ "--returnparameterfile",
                                path("return.txt"),
                                "--label",
                                "1",
                                "--shells=3",
                                "--outputSurface",
                                path("surface.vtk"),
                                "--qualityTable",
                                path("table.tsv"),
                                "--report",
                                path("report.json"),
                                path("prostate.nrrd"),
                                path("mesh.vtk") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");

  const std::vector<std::string> fractions = textsOf(outcome.out, "filter-progress");
  ASSERT_GT(fractions.size(), 5u);
  double before = -1.0;
  for (const std::string & fraction : fractions)
  {
    EXPECT_GT(std::stod(fraction), before);
    before = std::stod(fraction);
  }
  EXPECT_EQ(before, 1.0);
  EXPECT_EQ(outcome.out.compare(0, 15, "<filter-start>\n"), 0);
  EXPECT_NE(outcome.out.find("</filter-end>\n"), std::string::npos);
  EXPECT_GE(textsOf(outcome.out, "filter-comment").size(), 4u);

  const HexMesh mesh = readHexMesh(path("mesh.vtk"));
  EXPECT_EQ(mesh.nodesPerSide, 6);
  const std::map<std::string, std::string> values = returnParameters(path("return.txt"));
  EXPECT_EQ(values.at("cells"), "125");
  EXPECT_EQ(values.at("exact"), "yes");
  EXPECT_LE(std::stod(values.at("volumeVariance")), 1e-12);
  EXPECT_NEAR(std::stod(values.at("meshVolume")) / std::stod(values.at("labelVolume")), 1.0, 1e-6);
  const slicer::ModuleDescription module = slicer::parseModuleDescription(contentOf(MOSERHEX_MODULE_XML));
  for (const slicer::ParameterGroup & group : module.groups)
  {
    for (const slicer::ModuleParameter & parameter : group.parameters)
    {
      EXPECT_EQ(values.count(parameter.name), parameter.isSimpleOutput() ? 1u : 0u) << parameter.name;
    }
  }

  const std::string table = contentOf(path("table.tsv"));
  EXPECT_EQ(table.compare(0, 6, "stage\t"), 0);
  EXPECT_NE(table.find("\nexact\t"), std::string::npos) << table;
  EXPECT_NE(contentOf(path("report.json")).find("\"shells\": 3"), std::string::npos);
  EXPECT_NE(contentOf(path("surface.vtk")).find("SPACE=LPS"), std::string::npos);
  EXPECT_EQ(readSurface(path("surface.vtk")).mesh.vertices.size(), 152u); // 6^3 - 4^3
}

TEST_F(MoserHexMesh, WarningsGoToTheStandardOutput)
{
  writeLabelImage(path("tunnel.nrrd"), cubeWithTunnel());
  const Outcome outcome =
    run({ "--shells", "3", path("tunnel.nrrd"), path("mesh.vtk"), "--returnparameterfile", path("return.txt") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_NE(outcome.out.find("\nwarning: 1 tunnel filled: "), std::string::npos) << outcome.out;
  EXPECT_NE(returnParameters(path("return.txt")).at("warnings"), "0");
}

TEST_F(MoserHexMesh, FailureIsOneLineAndLeavesNothing)
{
  writeSample();
  expectOneLineError(run({ "--label", "7", path("prostate.nrrd"), path("mesh.vtk") }), 3);
  expectErrorCode(run({ path("prostate.nrrd") }), "E_USAGE");
  expectErrorCode(run({ "--shells=65", path("prostate.nrrd"), path("mesh.vtk") }), "E_USAGE");
  expectErrorCode(run({ path("prostate.nrrd"), path("mesh.obj") }), "E_USAGE");
  expectErrorCode(run({ path("none.nrrd"), path("mesh.vtk") }), "E_NOINPUT");
  expectErrorCode(run({ path("prostate.nrrd"), path("nowhere/mesh.vtk") }), "E_CANTCREAT");
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(MoserHexMesh, FullDiskKeepsTheOldFile)
{
  writeSample();
  ASSERT_EQ(run(quickRun()).exitCode, 0);
  const std::string old = contentOf(path("mesh.vtk"));
  EXPECT_NE(run({ "--shells", "4", path("prostate.nrrd"), path("mesh.vtk") }, 4096).exitCode, 0);
  EXPECT_EQ(contentOf(path("mesh.vtk")), old);
}

TEST_F(MoserHexMesh, KilledRunLeavesNoHalfFile)
{
  writeSample();
  for (int attempt = 0; attempt < 12; ++attempt)
  {
    fs::remove(path("mesh.vtk"));
    const pid_t child = startProgram(quickRun(), m_Root / "streams");
    std::this_thread::sleep_for(std::chrono::milliseconds(15 * attempt));
    ::kill(child, SIGKILL);
    (void)waitForProgram(child, m_Root / "streams");
    if (fs::exists(path("mesh.vtk")))
    {
      EXPECT_EQ(readHexMesh(path("mesh.vtk")).nodesPerSide, 6) << "attempt " << attempt;
    }
  }
}

TEST_F(MoserHexMesh, ClosedInputStreamDoesNotMatter)
{
  writeSample();
  const int input = ::dup(STDIN_FILENO);
  ::close(STDIN_FILENO);
  const Outcome outcome = run(quickRun());
  if (input >= 0)
  {
    ::dup2(input, STDIN_FILENO);
    ::close(input);
  }
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(readHexMesh(path("mesh.vtk")).nodesPerSide, 6);
}
