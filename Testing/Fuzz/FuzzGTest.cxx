// The drivers themselves: what they must not overlook. Short runs of them are tests of their own (CMakeLists.txt).
#include "ChildRun.h"
#include "EndToEnd.h"
#include "MutantRun.h"
#include "Mutator.h"
#include "SeedParts.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <set>

#include <unistd.h>

using namespace moserhex::fuzz;

TEST(Fuzz, SeedsAreTheSameBytesEveryTimeAndAreTaken)
{
  const std::vector<Seed> first = makeSeeds();
  const std::vector<Seed> second = makeSeeds();
  std::set<std::string>   formats;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_TRUE(formats.insert(first[i].format).second) << first[i].format;
    EXPECT_EQ(first[i].file.bytes, second[i].file.bytes) << first[i].format;
    MutantOptions options;
    options.mutants = 0;
    options.pipelineEvery = 1; // of the seed
    EXPECT_TRUE(runMutants(first[i], options).findings.empty()) << first[i].format;
  }
}

TEST(Fuzz, MutantsDifferAndTheirSeedDecidesThem)
{
  const std::string     bytes = "NRRD0004\ntype: short\nsizes: 4 4 4\n\nabcdefgh";
  Mutator               first(7);
  Mutator               second(7);
  std::set<std::string> mutants;
  for (int i = 0; i < 200; ++i)
  {
    const std::string mutant = first.mutant(bytes);
    EXPECT_EQ(mutant, second.mutant(bytes));
    mutants.insert(mutant);
  }
  EXPECT_GT(mutants.size(), 150u);
  EXPECT_NO_THROW((void)first.mutant(""));
}

TEST(Fuzz, PackedBytesComeBack)
{
  const std::string bytes(3000, 'x');
  EXPECT_EQ(gunzipped(gzipped(bytes)), bytes);
  EXPECT_THROW((void)gunzipped("no gzip"), std::runtime_error);
}

TEST(Fuzz, ChildTellsWhatItReturned)
{
  const ChildResult result = runInChild([] { return std::string(100000, 'y'); }, {});
  EXPECT_TRUE(result.finished);
  EXPECT_EQ(result.text, std::string(100000, 'y'));
}

TEST(Fuzz, DeathAndHangOfAChildAreSeen)
{
  const auto die = []() -> std::string {
    ::raise(SIGKILL);
    return "alive";
  };
  EXPECT_FALSE(runInChild(die, {}).finished);
  EXPECT_EQ(runInChild(die, {}).text, "signal 9");
  const auto leave = []() -> std::string { ::_exit(3); };
  EXPECT_EQ(runInChild(leave, {}).text, "exit status 3");
  const auto hang = []() -> std::string {
    ::pause();
    return "awake";
  };
  ChildLimits limits;
  limits.wallSeconds = 0.1;
  EXPECT_EQ(runInChild(hang, limits).text, "over the time limit");
  limits = {};
  limits.cpuSeconds = 1;
  const auto spin = []() -> std::string {
    for (volatile unsigned int n = 0;; n = n + 1)
    {}
  };
  EXPECT_EQ(runInChild(spin, limits).text, "over the time limit");
}

TEST(Fuzz, SeedThatIsRefusedIsAFindingAndKept)
{
  const ScratchFolder folder;
  MutantOptions       options;
  options.mutants = 3;
  options.keepFolder = folder / "kept";
  const MutantTally tally =
    runMutants({ SeedUse::Surface, "broken", { "a.off", "OFF\n" }, { { "b.txt", "beside" } } }, options);
  ASSERT_EQ(tally.findings.size(), 1u);
  EXPECT_NE(tally.findings[0].find("the seed itself"), std::string::npos);
  EXPECT_EQ(tally.refused, 3u);
  EXPECT_TRUE(std::ifstream(folder / "kept/broken-1/a.off").good());
  EXPECT_TRUE(std::ifstream(folder / "kept/broken-1/b.txt").good());
}

TEST(Fuzz, RefusalIsNoFinding)
{
  EXPECT_EQ(readEndToEnd("/nonexistent/a.off", SeedUse::Surface, false).answer, Answer::Refused);
  EXPECT_EQ(readEndToEnd("/nonexistent/a.nrrd", SeedUse::Labelmap, false).answer, Answer::Refused);
  EXPECT_EQ(readEndToEnd("/nonexistent/a.msh", SeedUse::Hexahedra, false).answer, Answer::Refused);
  EXPECT_EQ(readEndToEnd("/nonexistent/a.nrrd", SeedUse::Field, false).answer, Answer::Refused);
  EXPECT_EQ(readEndToEnd("/nonexistent/a.csv", SeedUse::Points, false).answer, Answer::Refused);
}
