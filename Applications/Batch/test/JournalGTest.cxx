// Exact: what comes back from a journal, whatever happened to its bytes.
#include "Journal.h"

#include "BatchTest.h"
#include "moserhex/Common/Random.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class JournalTest : public BatchTest
{
protected:
  [[nodiscard]] std::string
  journal(const std::string & shard = "") const
  {
    return journalName(folder(), shard);
  }

  void
  write(const std::vector<JournalEntry> & entries, const std::string & shard = "") const
  {
    JournalWriter writer(journal(shard));
    for (const JournalEntry & entry : entries)
    {
      writer.append(entry);
    }
  }
};

JournalEntry
doneEntry(const std::string & name)
{
  JournalEntry entry;
  entry.name = name;
  entry.key = { "in-" + name, "arguments", "version" };
  entry.done = true;
  entry.meshSha256 = "mesh-" + name;
  entry.reportSha256 = "report-" + name;
  return entry;
}

} // namespace

TEST_F(JournalTest, EntriesComeBack)
{
  JournalEntry failed;
  failed.name = "b/\"quoted\" \xc3\xa4.vtu";
  failed.key = { "", "a", "v" };
  failed.code = "E_TIMEOUT";
  failed.timeLimit = 12.5;
  failed.memoryLimit = 4096.0;
  write({ doneEntry("a.vtu"), failed });
  const JournalContent content = readJournals(folder());
  EXPECT_EQ(content.entries, 2u);
  EXPECT_EQ(content.damaged, 0u);
  const JournalEntry & done = content.last.at("a.vtu");
  EXPECT_TRUE(done.done);
  EXPECT_TRUE(done.key == doneEntry("a.vtu").key);
  EXPECT_EQ(done.meshSha256, "mesh-a.vtu");
  EXPECT_EQ(done.reportSha256, "report-a.vtu");
  const JournalEntry & other = content.last.at(failed.name);
  EXPECT_FALSE(other.done);
  EXPECT_EQ(other.code, "E_TIMEOUT");
  EXPECT_EQ(other.timeLimit, 12.5);
  EXPECT_EQ(other.memoryLimit, 4096.0);
}

TEST_F(JournalTest, TheLastEntryOfACaseCountsInAllJournalsOfTheFolder)
{
  JournalEntry early = doneEntry("a.vtu");
  early.meshSha256 = "old";
  write({ early, doneEntry("a.vtu") });
  write({ doneEntry("b.vtu") }, "2-of-5");
  std::ofstream(fs::path(folder()) / "journal.txt") << "not one of ours\n";
  const JournalContent content = readJournals(folder());
  EXPECT_EQ(content.entries, 3u);
  EXPECT_EQ(content.damaged, 0u);
  EXPECT_EQ(content.last.at("a.vtu").meshSha256, "mesh-a.vtu");
  EXPECT_EQ(content.last.count("b.vtu"), 1u);
}

TEST_F(JournalTest, NoJournalIsAnEmptyOne)
{
  EXPECT_TRUE(readJournals(folder()).last.empty());
  EXPECT_TRUE(readJournals(folder() + "/missing").last.empty());
}

TEST_F(JournalTest, ALineThatWasCutDoesNotCountAndDoesNotSpoilTheNextOne)
{
  write({ doneEntry("a.vtu"), doneEntry("b.vtu") });
  fs::resize_file(journal(), fs::file_size(journal()) - 10);
  write({ doneEntry("c.vtu") });
  const JournalContent content = readJournals(folder());
  EXPECT_EQ(content.damaged, 1u);
  EXPECT_EQ(content.last.count("a.vtu"), 1u);
  EXPECT_EQ(content.last.count("b.vtu"), 0u);
  EXPECT_EQ(content.last.count("c.vtu"), 1u);
}

TEST_F(JournalTest, NoChangedByteMakesAWrongEntry)
{
  const std::vector<JournalEntry> entries{ doneEntry("a.vtu"), doneEntry("b.vtu"), doneEntry("c.vtu") };
  write(entries);
  const std::string good = readBytes(journal());
  Random            random(7);
  for (int trial = 0; trial < 1000; ++trial)
  {
    std::string bad = good;
    const auto  place = static_cast<std::size_t>(random.uniform() * static_cast<double>(bad.size()));
    bad[place] = static_cast<char>(bad[place] ^ (1 << (trial % 8)));
    std::ofstream(journal(), std::ios::binary) << bad;
    const JournalContent content = readJournals(folder());
    EXPECT_LE(content.last.size(), 3u);
    for (const auto & [name, entry] : content.last)
    {
      EXPECT_TRUE(entry.key == doneEntry(name).key && entry.meshSha256 == "mesh-" + name) << place;
    }
    EXPECT_GE(content.last.size(), 1u) << place; // a line's end that changed joins two lines
  }
}

TEST_F(JournalTest, AJournalThatCannotBeWrittenIsRefused)
{
  EXPECT_THROW(JournalWriter(folder() + "/missing/journal.jsonl"), IOError);
}
