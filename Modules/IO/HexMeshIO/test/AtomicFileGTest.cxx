// Exact: what is in the folder afterwards.
#include "moserhex/HexMeshIO/AtomicFile.h"

#include "FullDisk.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

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
  EXPECT_TRUE(reportsFullDisk([&] { writeTextFile(folder / "a.txt", std::string(9000, 'x')); }));
  EXPECT_EQ(folder.fileCount(), 0u);
}
