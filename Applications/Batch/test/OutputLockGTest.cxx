// Exact: who may work on a folder.
#include "OutputLock.h"

#include "BatchTest.h"
#include "CommandErrors.h"
#include "Shard.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class OutputLockTest : public BatchTest
{
protected:
  [[nodiscard]] bool
  isFree(const std::string & shard) const
  {
    try
    {
      const OutputLock lock(folder(), shard, 0.0);
      return true;
    }
    catch (const IOError & error)
    {
      EXPECT_EQ(error.code(), ErrorCode::Locked) << error.what();
      EXPECT_NE(std::string(error.what()).find("process " + std::to_string(::getpid())), std::string::npos)
        << error.what();
      return false;
    }
  }
};

} // namespace

TEST_F(OutputLockTest, ASecondRunIsToldWhoHoldsIt)
{
  {
    const OutputLock lock(folder(), "", 0.0);
    EXPECT_FALSE(isFree(""));
    EXPECT_FALSE(isFree("1-of-2"));
  }
  EXPECT_TRUE(isFree(""));
}

TEST_F(OutputLockTest, ShardsDoNotHinderEachOther)
{
  const OutputLock lock(folder(), "1-of-2", 0.0);
  EXPECT_TRUE(isFree("2-of-2"));
  EXPECT_FALSE(isFree("1-of-2"));
  EXPECT_FALSE(isFree(""));
}

TEST_F(OutputLockTest, AKilledHolderLeavesNothingBehind)
{
  int ends[2] = {};
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0)
  {
    const OutputLock lock(folder(), "", 0.0);
    (void)!::write(ends[1], "x", 1);
    ::pause();
  }
  char byte = '\0';
  ASSERT_EQ(::read(ends[0], &byte, 1), 1);
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(isFree(""));
}

TEST_F(OutputLockTest, AFolderThatIsNotThereIsRefused)
{
  EXPECT_THROW(OutputLock(folder() + "/missing", "", 0.0), IOError);
}

TEST(Shard, IsEveryMthCase)
{
  std::vector<BatchCase> cases(7);
  for (std::size_t c = 0; c < cases.size(); ++c)
  {
    cases[c].name = std::to_string(c);
  }
  const Shard shard = parseShard("2/3");
  EXPECT_EQ(shard.name(), "2-of-3");
  shard.keepOwn(cases);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "1");
  EXPECT_EQ(cases[1].name, "4");
  EXPECT_TRUE(parseShard("").isAll());
  EXPECT_TRUE(parseShard("1/1").isAll());
  EXPECT_EQ(parseShard("1/1").name(), "");
}

TEST(Shard, WhatIsNoneIsRefused)
{
  for (const char * text : { "0/3", "4/3", "1", "1/", "/2", "a/b", "1/3/5", "-1/3", "1/9999999" })
  {
    EXPECT_THROW((void)parseShard(text), UsageError) << text;
  }
}
