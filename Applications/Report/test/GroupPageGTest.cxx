// Exact: outliers by their definition, and what is in the page of a group.
#include "GroupPage.h"
#include "PageName.h"
#include "ReportTest.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

GroupContent
groupOf(const std::vector<double> & values)
{
  GroupContent content;
  content.heading = "Meshes in a";
  content.caseName = "case";
  content.columns = { { "volume", "volume (mL)", true, true } };
  for (const double value : values)
  {
    content.rows.push_back({ "c" + std::to_string(content.rows.size()), "done", "", "", { value }, "", "0,0 1,0 1,1" });
  }
  return content;
}

nlohmann::json
dataOf(const std::string & page)
{
  const std::string begin = "id=\"group-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

} // namespace

TEST(Outliers, LieBeyondThreeAndAHalfRobustDeviations)
{
  // Median 10, absolute deviations 0 1 1 2 2 x: their median is 1.5, the limit 3.5 * 1.4826 * 1.5 = 7.78.
  EXPECT_EQ(outliersOf(groupOf({ 9, 11, 8, 12, 10, 17.7, 2.3, 10 }), 0), std::vector<int>(8, 0));
  const std::vector<int> marks = outliersOf(groupOf({ 9, 11, 8, 12, 10, 40, -20, 10 }), 0);
  EXPECT_EQ(marks, (std::vector<int>{ 0, 0, 0, 0, 0, 1, -1, 0 }));
}

TEST(Outliers, AreNoneAmongEqualNumbersAndUnknownOnes)
{
  EXPECT_EQ(outliersOf(groupOf({ 1, 1, 1, 1, 1, 1, 5 }), 0), std::vector<int>(7, 0));
  EXPECT_EQ(outliersOf(groupOf({ 9, 10, 11, 9.5, 1000 }), 0), std::vector<int>(5, 0)); // too few
  EXPECT_EQ(outliersOf(groupOf({ std::nan(""), std::nan("") }), 0), std::vector<int>(2, 0));
}

TEST(Outliers, AreNoneAmongNumbersThatDifferByRounding)
{
  const double e = 2.3e-16;
  EXPECT_EQ(outliersOf(groupOf({ 1, 1 + e, 1 + e, 1, 1 + e, 1, 1 + 100 * e, 1 - e }), 0), std::vector<int>(8, 0));
}

TEST(Outliers, FailedCasesAreNone)
{
  GroupContent content = groupOf({ 9, 10, 11, 9.5, 10, 9, 1000 });
  content.rows.back().status = "failed";
  EXPECT_EQ(outliersOf(content, 0), std::vector<int>(7, 0));
}

TEST(GroupPage, HoldsItsRowsAndNamesWhatToLookAt)
{
  if (!pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
  }
  GroupContent content = groupOf({ 9, 10, 11, 9.5, 1000, 10, 9, std::nan("") });
  content.rows.back().status = "failed";
  content.rows.back().code = "E_THIN";
  content.rows.back().page = "c7.html";
  const std::string    page = groupPage(content);
  const nlohmann::json data = dataOf(page);
  ASSERT_EQ(data["rows"].size(), 8u);
  EXPECT_EQ(data["rows"][4]["marks"][0], 1);
  EXPECT_TRUE(data["rows"][7]["figures"][0].is_null());
  EXPECT_NE(page.find("<strong>c4</strong>: volume (mL) above the others"), std::string::npos);
  EXPECT_NE(page.find("<strong><a href=\"c7.html\">c7</a></strong>: failed E_THIN"), std::string::npos);
  EXPECT_EQ(page, groupPage(content));
}

TEST(GroupPage, EscapesEveryName)
{
  if (!pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
  }
  const std::string hostile = "</script><img src=x onerror='alert(1)'>&\"\xff";
  GroupContent      content = groupOf({ 1, 2 });
  const std::size_t scripts = timesIn(groupPage(content), "</script>");
  content.heading = content.subtitle = content.version = hostile;
  content.columns.front().name = hostile;
  content.warnings = { hostile };
  content.rows[1] = { hostile, "failed", hostile, hostile, { 2 }, hostile, hostile };
  const std::string page = groupPage(content);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(timesIn(page, "</script>"), scripts);
  EXPECT_EQ(dataOf(page)["rows"][1]["code"], hostile.substr(0, hostile.size() - 1) + "\xEF\xBF\xBD");
}

TEST(GroupPage, OfNothingIsAPage)
{
  if (!pagesAreBuilt())
  {
    GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
  }
  EXPECT_NE(groupPage(groupOf({})).find("Nothing stands out"), std::string::npos);
}
