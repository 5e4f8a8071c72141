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

TEST(ModuleDescription, ListsAndMultipleParametersAreKnown)
{
  const ModuleDescription module = parseModuleDescription(
    moduleWith("<point multiple=\"true\" coordinateSystem=\"ras\"><name>p</name><longflag>p</longflag></point>"
               "<region><name>r</name><longflag>r</longflag></region>"
               "<integer-vector><name>v</name><longflag>v</longflag><default>1,2</default></integer-vector>"
               "<geometry type=\"model\" multiple=\"true\"><name>g</name><index>0</index></geometry>"
               "<double-vector><name>out</name><channel>output</channel></double-vector>"));
  const ModuleParameter & point = *module.find("p");
  EXPECT_EQ(point.kind, ValueKind::Real);
  EXPECT_TRUE(point.isMultiple);
  EXPECT_EQ(point.listSize, 3u);
  EXPECT_EQ(point.coordinateSystem, "ras");
  EXPECT_FALSE(module.find("r")->isMultiple);
  EXPECT_EQ(module.find("r")->listSize, 6u);
  EXPECT_EQ(module.find("r")->coordinateSystem, "lps");
  EXPECT_TRUE(module.find("v")->isList);
  EXPECT_EQ(module.find("v")->listSize, 0u);
  EXPECT_TRUE(module.find("g")->isMultiple);
  EXPECT_FALSE(module.find("g")->isList);
  EXPECT_TRUE(module.find("out")->isSimpleOutput());
}

TEST(ModuleDescription, FaultsOfListsAndMultipleParametersAreRefused)
{
  const auto expectRefusal = [](const std::string & parameters, const std::string & what) {
    const std::string refusal = refusalOf(moduleWith(parameters));
    EXPECT_NE(refusal.find(what), std::string::npos) << parameters << "\n-> " << refusal;
  };
  const std::string flags = "<name>a</name><longflag>a</longflag>";
  expectRefusal("<integer-vector>" + flags + "<default>1,x</default></integer-vector>", "\"x\" is not a whole number");
  expectRefusal("<point>" + flags + "<default>1,2</default></point>", "is not 3 numbers");
  expectRefusal("<point coordinateSystem=\"xyz\">" + flags + "</point>", "lps, ras or ijk, not xyz");
  expectRefusal("<integer coordinateSystem=\"lps\">" + flags + "</integer>", "has no attribute coordinateSystem");
  expectRefusal("<integer colour=\"red\">" + flags + "</integer>", "has no attribute colour");
  expectRefusal("<file multiple=\"yes\">" + flags + "</file>", "true or false, not yes");
  expectRefusal("<boolean multiple=\"true\">" + flags + "<default>false</default></boolean>", "no attribute multiple");
  expectRefusal("<string-enumeration multiple=\"true\">" + flags + "</string-enumeration>", "no attribute multiple");
  expectRefusal("<point><name>a</name><index>0</index></point>", "needs a flag, not an index");
  expectRefusal("<file multiple=\"true\"><name>a</name><flag>a</flag></file>", "needs a long flag or an index");
  expectRefusal("<integer multiple=\"true\">" + flags + "<default>1</default></integer>", "has no default");
  expectRefusal(
    "<file multiple=\"true\"><name>a</name><index>0</index></file><file><name>b</name><index>1</index></file>",
    "only the last index may be multiple");
}

TEST(ModuleDescription, HelpNamesEveryParameterWithItsRangeAndDefault)
{
  const std::string help = helpOf(parseModuleDescription(moduleWith(integer)), "Program");
  EXPECT_NE(help.find("usage: Program [options]"), std::string::npos) << help;
  EXPECT_NE(help.find("-n, --count INTEGER\n      How many [2 to 9] (3)"), std::string::npos) << help;
  const std::string many = helpOf(
    parseModuleDescription(moduleWith("<point multiple=\"true\"><name>p</name><longflag>p</longflag></point>"
                                      "<double-vector><name>v</name><longflag>v</longflag></double-vector>"
                                      "<geometry multiple=\"true\"><name>meshes</name><index>0</index></geometry>")),
    "Program");
  EXPECT_NE(many.find("usage: Program [options] meshes ...\n"), std::string::npos) << many;
  EXPECT_NE(many.find("--p X,Y,Z ...\n"), std::string::npos) << many;
  EXPECT_NE(many.find("--v NUMBER,...\n"), std::string::npos) << many;
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
