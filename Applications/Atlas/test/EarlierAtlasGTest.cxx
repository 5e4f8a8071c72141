// Exact: which files go and which stay.
#include "EarlierAtlas.h"

#include "CommandErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;

TEST(EarlierAtlas, ItsFilesGoAndOthersStay)
{
  const TestFolder folder;
  for (const char * file : { "mean.vtu", "mode-12-minus3.vtu", "group.csv", "P01.vtu", "mode-01-plus3.vtu.txt" })
  {
    writeTextFile(folder / file, "");
  }
  removeEarlierAtlas(folder / "");
  EXPECT_EQ(folder.fileCount(), 5u); // no atlas is there
  writeTextFile(folder / "atlas.json", "");
  writeTextFile(folder / "model.json", "");
  EXPECT_TRUE(holdsAtlas(folder / ""));
  removeEarlierAtlas(folder / "");
  EXPECT_EQ(folder.fileCount(), 2u);
  EXPECT_TRUE(std::filesystem::exists(folder / "P01.vtu"));
  EXPECT_TRUE(std::filesystem::exists(folder / "mode-01-plus3.vtu.txt"));
}

TEST(EarlierAtlas, OneThatWasBegunCounts)
{
  const TestFolder folder;
  writeTextFile(folder / "mean.vtu", "");
  writeTextFile(folder / "atlas.json", "{ \"of\": \"another program\" }\n");
  EXPECT_FALSE(holdsAtlas(folder / ""));
  requireNoAtlas(folder / "");
  markAtlasBegun(folder / "");
  EXPECT_TRUE(holdsAtlas(folder / ""));
  EXPECT_THROW(requireNoAtlas(folder / ""), UsageError);
  removeEarlierAtlas(folder / "");
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(EarlierAtlas, InputsThatTheOutputWouldReplaceAreRefused)
{
  const TestFolder folder;
  requireNotOverwritten({ folder / "P01.vtu", "mean.vtu" }, folder / "");
  EXPECT_NE(analytic::messageOf<UsageError>([&] {
              requireNotOverwritten({ folder / "group.csv" }, folder / "");
            }).find("an input that the output would replace"),
            std::string::npos);
}
