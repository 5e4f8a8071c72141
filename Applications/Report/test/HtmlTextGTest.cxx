// Exact: texts.
#include "HtmlText.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <limits>

using namespace moserhex::app;

TEST(EscapeHtml, LeavesNothingThatMeansSomething)
{
  EXPECT_EQ(escapeHtml("<b a=\"1\" c='2'>&amp;"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
  EXPECT_EQ(escapeHtml("Größe\t1\n2"), "Größe\t1\n2");
}

TEST(EscapeHtml, ReplacesWhatIsNoText)
{
  EXPECT_EQ(escapeHtml("a\xff"), "a\xEF\xBF\xBD");
  EXPECT_EQ(escapeHtml("a\x01\x7f"
                       "b"),
            "a\xEF\xBF\xBD\xEF\xBF\xBD"
            "b");
}

TEST(EscapeScriptJson, IsReadAsTheSameAndEndsNoElement)
{
  const nlohmann::json json{ { "a", "</script><!-- & \"" } };
  const std::string    text = escapeScriptJson(json.dump());
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text), json);
}

TEST(Base64, IsThatOfRfc4648)
{
  const std::string  text = "foobar";
  const char * const expected[] = { "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy" };
  for (std::size_t size = 0; size <= text.size(); ++size)
  {
    EXPECT_EQ(base64(text.data(), size), expected[size]);
  }
  EXPECT_EQ(base64("\xfb\xff", 2), "+/8=");
}

TEST(UrlOfPath, EncodesWhatWouldMeanSomething)
{
  EXPECT_EQ(urlOfPath("a b/c#d?e%f:g.html"), "a%20b/c%23d%3Fe%25f%3Ag.html");
  EXPECT_EQ(urlOfPath("ö"), "%C3%B6");
}

TEST(Numbers, AreForPeople)
{
  EXPECT_EQ(shortNumber(0.123456), "0.123");
  EXPECT_EQ(shortNumber(1e-26, 2), "1e-26");
  EXPECT_EQ(fixedNumber(12.345678, 2), "12.35");
  EXPECT_EQ(shortNumber(std::numeric_limits<double>::quiet_NaN()), "n/a");
  EXPECT_EQ(fixedNumber(std::numeric_limits<double>::infinity(), 1), "n/a");
}

TEST(ShortFileName, KeepsTheEnd)
{
  EXPECT_EQ(shortFileName("folder/a.nrrd"), "a.nrrd");
  EXPECT_EQ(shortFileName(std::string(100, 'x') + ".nrrd", 12), "...xxxx.nrrd");
}
