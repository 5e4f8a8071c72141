// Exact: what the description of a module says, and what is wrong with one.
#include "ModuleDescription.h"
#include "ModuleProgram.h"
#include "ModuleValues.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::slicer;

namespace
{

std::string
moduleWith(const std::string & parameters)
{
  return "<?xml version=\"1.0\"?>\n<executable><title>T</title><description>D</description>"
         "<parameters advanced=\"true\"><label>Group</label><description>About</description>" +
         parameters + "</parameters></executable>";
}

std::string
refusalOf(const std::string & xml)
{
  try
  {
    (void)parseModuleDescription(xml);
  }
  catch (const InvalidInput & error)
  {
    return error.what();
  }
  return "";
}

const std::string integer =
  "<integer><name>n</name><flag>-n</flag><longflag>count</longflag><description>How "
  "many</description><label>Count</label><default>3</default><constraints><minimum>2</minimum>"
  "<maximum>9</maximum><step>1</step></constraints></integer>";

} // namespace

TEST(ModuleDescription, HoldsWhatTheXmlSays)
{
  const ModuleDescription module = parseModuleDescription(moduleWith(
    integer + "<image type=\"label\"><name>in</name><index>0</index><description>&lt;x&gt;</description>"
              "<channel>input</channel></image><geometry fileExtensions=\".vtk, .vtu\"><name>out</name><index>1</index>"
              "<channel>output</channel></geometry><string-enumeration><name>way</name><longflag>way</longflag>"
              "<default>b</default><element>a</element><element>b</element></string-enumeration>"
              "<double><name>volume</name><default>0</default><channel>output</channel></double>"));
  EXPECT_EQ(module.title, "T");
  ASSERT_EQ(module.groups.size(), 1u);
  EXPECT_TRUE(module.groups[0].isAdvanced);
  EXPECT_EQ(module.groups[0].label, "Group");
  const ModuleParameter & n = *module.find("n");
  EXPECT_EQ(n.kind, ValueKind::Integer);
  EXPECT_EQ(n.flag, "n");
  EXPECT_EQ(n.longFlag, "count");
  EXPECT_EQ(n.minimum, 2.0);
  EXPECT_EQ(n.maximum, 9.0);
  EXPECT_EQ(module.find("in")->description, "<x>");
  EXPECT_EQ(module.find("out")->fileExtensions, (std::vector<std::string>{ ".vtk", ".vtu" }));
  EXPECT_TRUE(module.find("out")->isOutput);
  EXPECT_FALSE(module.find("out")->isSimpleOutput());
  EXPECT_EQ(module.find("way")->choices, (std::vector<std::string>{ "a", "b" }));
  EXPECT_TRUE(module.find("volume")->isSimpleOutput());
  EXPECT_EQ(module.find("nothing"), nullptr);
}

TEST(ModuleDescription, FaultsAreRefusedAndNamed)
{
  const auto expectRefusal = [](const std::string & parameters, const std::string & what) {
    const std::string refusal = refusalOf(moduleWith(parameters));
    EXPECT_NE(refusal.find(what), std::string::npos) << parameters << "\n-> " << refusal;
  };
  EXPECT_NE(refusalOf("<executable><title>").find("line 1"), std::string::npos);
  EXPECT_NE(refusalOf("<module/>").find("need <executable>"), std::string::npos);
  expectRefusal("<colour><name>c</name></colour>", "unknown parameter <colour>");
  expectRefusal("<string><name>a-b</name><longflag>x</longflag></string>", "a-b");
  expectRefusal("<string><name>a</name><longflag>a-b</longflag></string>", "a-b");
  expectRefusal("<string><name>a</name><longflag>xml</longflag></string>", "long flag xml is taken");
  expectRefusal("<string><name>a</name></string>", "neither flag nor index");
  expectRefusal("<boolean><name>a</name><longflag>a</longflag><default>true</default></boolean>", "must be false");
  expectRefusal(integer + integer, "name n is taken twice");
  expectRefusal("<integer><name>a</name><longflag>a</longflag><default>x</default></integer>", "not a whole number");
  expectRefusal("<image><name>a</name><index>1</index></image>", "indices must count from 0");
  expectRefusal("<image><name>a</name><index>-1</index></image>", "not a number from 0");
  expectRefusal("<string-enumeration><name>a</name><longflag>a</longflag><default>z</default><element>y</element>"
                "</string-enumeration>",
                "z is not one of y");
}

TEST(ModuleDescription, HelpNamesEveryParameterWithItsRangeAndDefault)
{
  const std::string help = helpOf(parseModuleDescription(moduleWith(integer)), "Program");
  EXPECT_NE(help.find("usage: Program [options]"), std::string::npos) << help;
  EXPECT_NE(help.find("-n, --count INTEGER\n      How many [2 to 9] (3)"), std::string::npos) << help;
}

TEST(ModuleValues, NumbersAreReadWholeOrNotAtAll)
{
  EXPECT_EQ(integerOf("-12"), -12);
  EXPECT_EQ(integerOf("+12"), 12);
  EXPECT_FALSE(integerOf("12.5"));
  EXPECT_FALSE(integerOf("12 "));
  EXPECT_FALSE(integerOf(""));
  EXPECT_FALSE(integerOf("99999999999999999999"));
  EXPECT_EQ(realOf("2.5e-1"), 0.25);
  EXPECT_FALSE(realOf("2,5"));
  EXPECT_FALSE(realOf("nan"));
  EXPECT_FALSE(realOf("inf"));
}
