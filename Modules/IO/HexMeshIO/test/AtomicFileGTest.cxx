// Exact: what is in the folder afterwards.
#include "moserhex/HexMeshIO/AtomicFile.h"

#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <csignal>

#include <sys/resource.h>
#include <sys/wait.h>

using namespace moserhex;

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

TEST(WriteTextFile, FullDiskIsReportedAndLeavesNothing)
{
  const TestFolder folder;
  const pid_t      child = ::fork();
  if (child == 0)
  {
    // A limit on the size of files fails like a full disk does.
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{ 1000, 1000 };
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try
    {
      writeTextFile(folder / "a.txt", std::string(5000, 'x'));
    }
    catch (const IOError &)
    {
      ::_exit(42);
    }
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 42);
  EXPECT_EQ(folder.fileCount(), 0u);
}
