// Exact: a table against what it must hold.
#include "moserhex/Common/ErrorCode.h"

#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

using namespace moserhex;

TEST(ErrorCode, EveryCodeHasANameOfItsOwn)
{
  std::set<std::string> names;
  for (int code = 0; code <= static_cast<int>(lastErrorCode); ++code)
  {
    const std::string name = nameOf(static_cast<ErrorCode>(code));
    EXPECT_EQ(name.compare(0, 2, "E_"), 0) << name;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(ErrorCode, EveryCodeEndsACommandWithOneOfTheDocumentedStatuses)
{
  for (int code = 0; code <= static_cast<int>(lastErrorCode); ++code)
  {
    const std::set<int> documented{ 2, 3, 4, 70, 74, 75, 130 };
    EXPECT_EQ(documented.count(exitStatusOf(static_cast<ErrorCode>(code))), 1u) << code;
  }
}

TEST(ErrorCode, FirstAndLastEntriesStandWhereTheEnumerationHasThem)
{
  EXPECT_STREQ(nameOf(ErrorCode::Usage), "E_USAGE");
  EXPECT_STREQ(nameOf(ErrorCode::Precondition), "E_PRECONDITION");
  EXPECT_STREQ(nameOf(ErrorCode::Cancelled), "E_CANCELLED");
  EXPECT_EQ(exitStatusOf(ErrorCode::Usage), 2);
  EXPECT_EQ(exitStatusOf(ErrorCode::InputOutput), 74);
}

TEST(ErrorCode, ErrorsCarryTheirCode)
{
  EXPECT_EQ(InvalidInput("x").code(), ErrorCode::Precondition);
  EXPECT_EQ(InvalidInput(ErrorCode::Topology, "x").code(), ErrorCode::Topology);
  EXPECT_EQ(NotConverged("x", {}).code(), ErrorCode::NotConverged);
  EXPECT_EQ(Cancelled().code(), ErrorCode::Cancelled);
}
