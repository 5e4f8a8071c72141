// Exact: what is in the folder afterwards.
#include "moserhex/HexMeshIO/AtomicFile.h"

#include "FullDisk.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;
namespace fs = std::filesystem;

TEST(AtomicFile, NothingIsLeftWithoutCommit)
{
  const TestFolder folder;
  {
    const AtomicFile file(folder / "a.vtu");
    writeBytes(file.partName(), "half");
    EXPECT_EQ(folder.fileCount(), 1u);
  }
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(AtomicFile, CommitReplacesTheOldFile)
{
  const TestFolder folder;
  writeBytes(folder / "a.txt", "old");
  writeTextFile(folder / "a.txt", "new");
  EXPECT_EQ(readBytes(folder / "a.txt"), "new");
  EXPECT_EQ(folder.fileCount(), 1u);
}

TEST(AtomicFile, OldFileStaysWithoutCommit)
{
  const TestFolder folder;
  writeBytes(folder / "a.txt", "old");
  {
    const AtomicFile file(folder / "a.txt");
    writeBytes(file.partName(), "half");
  }
  EXPECT_EQ(readBytes(folder / "a.txt"), "old");
}

TEST(AtomicFile, PartKeepsTheExtension)
{
  const TestFolder folder;
  const AtomicFile file(folder / "a.vtu");
  EXPECT_EQ(std::filesystem::path(file.partName()).extension(), ".vtu");
}

TEST(AtomicFile, MissingFolderIsRefused)
{
  const TestFolder folder;
  EXPECT_THROW(AtomicFile(folder / "no/a.vtu"), IOError);
}

TEST(AtomicFile, FolderAsFileIsRefused)
{
  const TestFolder folder;
  std::filesystem::create_directory(folder / "a.vtu");
  EXPECT_THROW(AtomicFile(folder / "a.vtu"), IOError);
}

TEST(AtomicFile, LostPartIsReported)
{
  const TestFolder folder;
  AtomicFile       file(folder / "a.vtu");
  std::filesystem::remove(file.partName());
  EXPECT_THROW(file.commit(), IOError);
}

TEST(AtomicFile, SignalHandlersCanRemoveUnfinishedFiles)
{
  const TestFolder folder;
  const AtomicFile first(folder / "a.vtu");
  const AtomicFile second(folder / "b.json");
  EXPECT_EQ(folder.fileCount(), 2u);
  removeUnfinishedFiles();
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(AbandonedParts, OfDeadProcessesAreRemovedAndNothingElse)
{
  const TestFolder folder;
  const pid_t      dead = ::fork();
  if (dead == 0)
  {
    const AtomicFile file(folder / "mesh.vtu");
    ::_exit(0); // without destructors, as after a kill
  }
  siginfo_t ended = {};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(dead), &ended, WEXITED | WNOWAIT), 0); // a zombie is as dead as any
  const AtomicFile               ofLiving(folder / "mesh.vtu");
  const std::string              number = std::to_string(dead);
  const std::vector<std::string> others{
    ".other." + number + ".part.vtu",      ".mesh." + number + ".part.json", ".mesh.x.part.vtu", ".mesh..part.vtu",
    ".mesh.99999999999999999999.part.vtu", "mesh." + number + ".part.vtu",   ".mesh.vtu"
  };
  for (const std::string & name : others)
  {
    std::ofstream(folder / name) << "x";
  }
  ASSERT_TRUE(fs::exists(folder / (".mesh." + number + ".part.vtu")));
  removeAbandonedParts({ folder / "mesh.vtu", folder / "missing/mesh.vtu" });
  EXPECT_FALSE(fs::exists(folder / (".mesh." + number + ".part.vtu")));
  EXPECT_TRUE(fs::exists(ofLiving.partName()));
  ASSERT_EQ(::waitpid(dead, nullptr, 0), dead);
  for (const std::string & name : others)
  {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  removePartOf(folder / "other.vtu", dead);
  EXPECT_FALSE(fs::exists(folder / others.front()));
}

TEST(AbandonedParts, OfANumberThatAnotherProcessHasGotAreRemoved)
{
  const TestFolder folder;
  writeBytes(folder / "part", "half");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const pid_t later = ::fork();
  if (later == 0)
  {
    ::pause();
  }
  const std::string part = folder / (".mesh." + std::to_string(later) + ".part.vtu");
  fs::rename(folder / "part", part); // keeps its time
  removeAbandonedParts({ folder / "mesh.vtu" });
  EXPECT_FALSE(fs::exists(part));
  writeBytes(part, "being written");
  removeAbandonedParts({ folder / "mesh.vtu" });
  EXPECT_TRUE(fs::exists(part));
  ::kill(later, SIGKILL);
  ASSERT_EQ(::waitpid(later, nullptr, 0), later);
}

TEST(MakeFolder, MakesWhatIsMissingOrSaysWhyNot)
{
  const TestFolder folder;
  makeFolder(folder / "a/b");
  makeFolder(folder / "a/b");
  EXPECT_TRUE(fs::is_directory(folder / "a/b"));
  std::ofstream(folder / "file") << "x";
  EXPECT_THROW(makeFolder(folder / "file/c"), IOError);
}

TEST(WriteTextFile, FullDiskIsReportedAndLeavesNothing)
{
  const TestFolder folder;
  EXPECT_TRUE(reportsFullDisk([&] { writeTextFile(folder / "a.txt", std::string(9000, 'x')); }));
  EXPECT_EQ(folder.fileCount(), 0u);
}
