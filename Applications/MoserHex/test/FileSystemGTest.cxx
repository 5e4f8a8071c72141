// Exact: file names and file systems as users have them. The smallest mesh keeps the runs short.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <csignal>
#include <cstdlib>
#include <fstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class FileSystem : public CommandTest
{
protected:
  [[nodiscard]] Outcome
  meshOf(const std::string & input, const std::string & output = "mesh.vtu") const
  {
    return run({ "mesh", "--shells=2", "--stage=initial", "--quiet", "--", input, path(output) });
  }

  /** Runs the program by a shell in the folder of the files: for redirections and limits. */
  [[nodiscard]] int
  shell(const std::string & redirection) const
  {
    const std::string command = "cd '" + path("") +
                                "' && " MOSERHEX_EXECUTABLE " mesh --shells=2 --stage=initial prostate.nrrd mesh.vtu " +
                                redirection;
    const int status = std::system(("bash -c \"" + command + "\"").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

} // namespace

TEST_F(FileSystem, NamesOfAnyCharactersAreRead)
{
  writeSample();
  for (const std::string name : { "my mask (1).nrrd",
                                  "gr\xC3\xB6\xC3\x9F"
                                  "e.nrrd",
                                  "line1\nline2.nrrd",
                                  "\xE9.nrrd",
                                  "a'b\"c;$(touch pwned)*.nrrd",
                                  "100%s%n%d.nrrd",
                                  "MASK.NRRD",
                                  "mask",
                                  ".nrrd" })
  {
    fs::copy_file(path("prostate.nrrd"), path(name));
    const Outcome outcome = meshOf(path(name));
    EXPECT_EQ(outcome.exitCode, 0) << name << ": " << outcome.error;
    EXPECT_EQ(readHexMesh(path("mesh.vtu")).nodesPerSide, 4);
    fs::remove(path("mesh.vtu"));
  }
  const std::string longest = std::string(250, 'x') + ".nrrd";
  fs::copy_file(path("prostate.nrrd"), path(longest));
  EXPECT_EQ(meshOf(path(longest), std::string(250, 'y') + ".vtu").exitCode, 0);
  EXPECT_FALSE(fs::exists("pwned"));
}

TEST_F(FileSystem, WhatIsNoRegularFileIsNoInput)
{
  ASSERT_EQ(::mkfifo(path("fifo.nrrd").c_str(), 0666), 0);
  fs::create_directory(path("folder.nrrd"));
  fs::create_symlink("nowhere.nrrd", path("dangling.nrrd"));
  fs::create_symlink("loop.nrrd", path("loop.nrrd"));
  for (const std::string name : { "fifo.nrrd", "folder.nrrd", "dangling.nrrd", "loop.nrrd", "missing.nrrd" })
  {
    expectErrorCode(meshOf(path(name)), "E_NOINPUT");
  }
  expectErrorCode(meshOf("/dev/zero"), "E_NOINPUT");
  EXPECT_FALSE(fs::exists(path("mesh.vtu")));
}

TEST_F(FileSystem, ALinkToALabelmapIsFollowedAndOneToTheOutputReplaced)
{
  writeSample();
  fs::create_symlink("prostate.nrrd", path("link.nrrd"));
  fs::create_symlink("elsewhere.vtu", path("mesh.vtu"));
  EXPECT_EQ(meshOf(path("link.nrrd")).exitCode, 0);
  EXPECT_FALSE(fs::is_symlink(path("mesh.vtu")));
  EXPECT_FALSE(fs::exists(path("elsewhere.vtu")));
}

TEST_F(FileSystem, AnOldMeshStaysUntilTheNewOneIsComplete)
{
  writeSample();
  std::ofstream(path("mesh.vtu")) << "old";
  EXPECT_EQ(run({ "mesh", path("prostate.nrrd"), path("mesh.vtu"), "--shells=4", "--stage=initial" }, 2000).exitCode,
            74);
  EXPECT_EQ(contentOf(path("mesh.vtu")), "old");
  EXPECT_EQ(fileCount(), 2u);
  EXPECT_EQ(meshOf(path("prostate.nrrd")).exitCode, 0);
  EXPECT_NE(contentOf(path("mesh.vtu")), "old");
}

TEST_F(FileSystem, OutputsThatWouldReplaceAnInputAreWrongUsage)
{
  writeSample();
  fs::copy_file(path("prostate.nrrd"), path("a.vtk"));
  fs::create_hard_link(path("a.vtk"), path("b.vtk"));
  expectErrorCode(run({ "mesh", path("a.vtk"), path("a.vtk") }), "E_USAGE");
  expectErrorCode(run({ "mesh", path("a.vtk"), path("b.vtk") }), "E_USAGE");
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.xyz") }), "E_USAGE");
  fs::create_directory(path("folder.vtu"));
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("folder.vtu") }), "E_CANTCREAT");
}

TEST_F(FileSystem, ClosedStreamsAndAReaderThatGoesAwayDoNotCostTheMesh)
{
  writeSample();
  for (const std::string redirection : { "<&- >&- 2>&-", ">&-", "| true; exit \\${PIPESTATUS[0]}" })
  {
    EXPECT_EQ(shell(redirection), 0) << redirection;
    EXPECT_EQ(readHexMesh(path("mesh.vtu")).nodesPerSide, 4) << redirection;
    fs::remove(path("mesh.vtu"));
  }
}

TEST_F(FileSystem, FewDescriptorsAreEnough)
{
  writeSample();
  const std::string command = "ulimit -n 16; " MOSERHEX_EXECUTABLE " mesh --shells=2 --stage=initial --quiet '" +
                              path("prostate.nrrd") + "' '" + path("mesh.vtu") + "'";
  EXPECT_EQ(std::system(("bash -c \"" + command + "\"").c_str()), 0);
}
