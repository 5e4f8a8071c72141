// Exact: what a command line means.
#include "ModuleArguments.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::slicer;

namespace
{

const ModuleDescription &
module()
{
  static const ModuleDescription description = parseModuleDescription(
    "<executable><parameters><image><name>in</name><index>0</index></image>"
    "<geometry fileExtensions=\".vtk\"><name>out</name><index>1</index><channel>output</channel></geometry>"
    "<integer><name>n</name><flag>-n</flag><longflag>count</longflag><default>3</default>"
    "<constraints><minimum>-2</minimum><maximum>9</maximum></constraints></integer>"
    "<double><name>x</name><longflag>x</longflag><default>0.5</default></double>"
    "<boolean><name>b</name><flag>b</flag><longflag>bool</longflag><default>false</default></boolean>"
    "<string><name>s</name><longflag>text</longflag></string></parameters></executable>");
  return description;
}

/** A module of the kind that follows: points and a transform for a mesh, and the meshes of many subjects. */
const ModuleDescription &
moduleOfMany()
{
  static const ModuleDescription description = parseModuleDescription(
    "<executable><parameters>"
    "<point multiple=\"true\" coordinateSystem=\"ras\"><name>landmarks</name><longflag>landmark</longflag></point>"
    "<point><name>seed</name><flag>s</flag><longflag>seed</longflag></point>"
    "<region><name>box</name><longflag>box</longflag></region>"
    "<pointfile multiple=\"true\" fileExtensions=\".fcsv\"><name>lists</name><longflag>list</longflag></pointfile>"
    "<transform type=\"linear\"><name>transform</name><longflag>transform</longflag></transform>"
    "<directory><name>folder</name><longflag>folder</longflag></directory>"
    "<integer-vector><name>size</name><longflag>size</longflag><default>1,2</default>"
    "<constraints><minimum>0</minimum><maximum>9</maximum></constraints></integer-vector>"
    "<float-vector><name>weights</name><longflag>weights</longflag></float-vector>"
    "<double-vector><name>times</name><longflag>times</longflag><default>0.5</default></double-vector>"
    "<string-vector><name>names</name><longflag>names</longflag><default>a,b</default></string-vector>"
    "<integer multiple=\"true\"><name>labels</name><flag>l</flag><longflag>label</longflag>"
    "<constraints><minimum>1</minimum></constraints></integer>"
    "<table><name>table</name><index>0</index><channel>output</channel></table>"
    "<geometry multiple=\"true\"><name>meshes</name><index>1</index></geometry>"
    "</parameters></executable>");
  return description;
}

ModuleArguments
parse(const std::vector<std::string> & words)
{
  return { module(), words };
}

ModuleArguments
parseMany(std::vector<std::string> words)
{
  words.insert(words.end(), { "t.tsv", "a.vtk" });
  return { moduleOfMany(), words };
}

void
expectRefusal(const ModuleDescription & description, const std::vector<std::string> & words, const std::string & what)
{
  try
  {
    (void)ModuleArguments(description, words);
    FAIL() << what;
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Usage);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

void
expectRefusal(const std::vector<std::string> & words, const std::string & what)
{
  expectRefusal(module(), words, what);
}

void
expectRefusalOfMany(std::vector<std::string> words, const std::string & what)
{
  words.insert(words.end(), { "t.tsv", "a.vtk" });
  expectRefusal(moduleOfMany(), words, what);
}

using Points = std::vector<std::array<double, 3>>;
using Texts = std::vector<std::string>;
using Integers = std::vector<long long>;
using Reals = std::vector<double>;

} // namespace

TEST(ModuleArguments, DefaultsHoldWhereNothingIsGiven)
{
  const ModuleArguments arguments = parse({ "a.nrrd", "b.vtk" });
  EXPECT_EQ(arguments.request(), ModuleRequest::Run);
  EXPECT_EQ(arguments.text("in"), "a.nrrd");
  EXPECT_EQ(arguments.text("out"), "b.vtk");
  EXPECT_EQ(arguments.integer("n"), 3);
  EXPECT_EQ(arguments.real("x"), 0.5);
  EXPECT_FALSE(arguments.flag("b"));
  EXPECT_FALSE(arguments.has("s"));
  EXPECT_EQ(arguments.returnParameterFile(), "");
}

TEST(ModuleArguments, ValuesComeAfterASpaceOrAnEqualsSign)
{
  const ModuleArguments spaced = parse(
    { "--returnparameterfile", "r.txt", "--count", "-2", "--x", "1e2", "-b", "--text", "a b", "a.nrrd", "b.VTK" });
  EXPECT_EQ(spaced.integer("n"), -2);
  EXPECT_EQ(spaced.real("x"), 100.0);
  EXPECT_TRUE(spaced.flag("b"));
  EXPECT_EQ(spaced.text("s"), "a b");
  EXPECT_EQ(spaced.returnParameterFile(), "r.txt");
  const ModuleArguments joined = parse({ "--count=4", "-b=false", "a.nrrd", "--text=x=y", "b.vtk" });
  EXPECT_EQ(joined.integer("n"), 4);
  EXPECT_FALSE(joined.flag("b"));
  EXPECT_EQ(joined.text("s"), "x=y");
  EXPECT_EQ(parse({ "-n", "5", "a.nrrd", "b.vtk" }).integer("n"), 5);
}

TEST(ModuleArguments, WhatFollowsTwoDashesIsAnArgument)
{
  EXPECT_EQ(parse({ "--", "-rf.nrrd", "b.vtk" }).text("in"), "-rf.nrrd");
  EXPECT_EQ(parse({ "--ignore_rest", "--xml", "b.vtk" }).text("in"), "--xml");
}

TEST(ModuleArguments, RequestsNeedNoArguments)
{
  EXPECT_EQ(parse({ "--xml" }).request(), ModuleRequest::Xml);
  EXPECT_EQ(parse({ "-h" }).request(), ModuleRequest::Help);
  EXPECT_EQ(parse({ "--version" }).request(), ModuleRequest::Version);
  EXPECT_EQ(parse({ "--logo" }).request(), ModuleRequest::Logo);
  EXPECT_EQ(parse({ "--processinformationaddress", "0", "--echo", "a.nrrd", "b.vtk" }).request(), ModuleRequest::Run);
}

TEST(ModuleArguments, FaultsAreRefused)
{
  expectRefusal({ "a.nrrd" }, "out is missing");
  expectRefusal({ "a.nrrd", "b.vtk", "c" }, "too many arguments: c");
  expectRefusal({ "a.nrrd", "b.vtu" }, "does not end with .vtk");
  expectRefusal({ "--count", "10", "a.nrrd", "b.vtk" }, "--count: 10 is not -2 to 9");
  expectRefusal({ "--count", "4.5", "a.nrrd", "b.vtk" }, "whole number");
  expectRefusal({ "--x", "nan", "a.nrrd", "b.vtk" }, "not a number");
  expectRefusal({ "a.nrrd", "b.vtk", "--count" }, "needs a value");
  expectRefusal({ "--count=1", "--count=2", "a.nrrd", "b.vtk" }, "given twice");
  expectRefusal({ "--bool=maybe", "a.nrrd", "b.vtk" }, "takes true or false");
  expectRefusal({ "--colour", "1", "a.nrrd", "b.vtk" }, "no option --colour");
}

TEST(ModuleArguments, ShortAndLongFlagAreOneParameter)
{
  expectRefusal({ "--count=1", "-n", "2", "a.nrrd", "b.vtk" }, "-n is given twice");
}

TEST(ModuleArguments, VectorsAreListsWithCommasAndHaveDefaults)
{
  const ModuleArguments defaults = parseMany({});
  EXPECT_EQ(defaults.integers("size"), (Integers{ 1, 2 }));
  EXPECT_EQ(defaults.reals("weights"), Reals{});
  EXPECT_EQ(defaults.reals("times"), Reals{ 0.5 });
  EXPECT_EQ(defaults.texts("names"), (Texts{ "a", "b" }));
  EXPECT_FALSE(defaults.has("weights"));
  const ModuleArguments given =
    parseMany({ "--size", "3,0,9", "--weights=-1,2.5e-1", "--times", "", "--names", "x,\"y,z\"," });
  EXPECT_EQ(given.integers("size"), (Integers{ 3, 0, 9 }));
  EXPECT_EQ(given.reals("weights"), (Reals{ -1.0, 0.25 }));
  EXPECT_EQ(given.reals("times"), Reals{});
  EXPECT_EQ(given.texts("names"), (Texts{ "x", "y,z", "" }));
}

TEST(ModuleArguments, MultipleParametersAreGivenOneByOneOrWithCommas)
{
  EXPECT_EQ(parseMany({}).integers("labels"), Integers{});
  EXPECT_EQ(parseMany({ "--label", "3", "-l", "1", "--label=2,5" }).integers("labels"), (Integers{ 3, 1, 2, 5 }));
  EXPECT_EQ(parseMany({ "--list", "a.fcsv", "--list", "b c.fcsv" }).texts("lists"), (Texts{ "a.fcsv", "b c.fcsv" }));
}

TEST(ModuleArguments, LastIndexTakesAllArgumentsThatAreLeft)
{
  const ModuleArguments arguments(moduleOfMany(), { "t.tsv", "a.vtk", "--size", "1", "b.vtk", "\"c,d.vtk\"" });
  EXPECT_EQ(arguments.text("table"), "t.tsv");
  EXPECT_EQ(arguments.texts("meshes"), (Texts{ "a.vtk", "b.vtk", "c,d.vtk" }));
  expectRefusal(moduleOfMany(), { "t.tsv" }, "meshes is missing");
}

TEST(ModuleArguments, PointsAreLpsWhateverTheModuleAskedFor)
{
  const ModuleArguments arguments =
    parseMany({ "--landmark", "1,2,3", "-s", "1,2,3", "--landmark", "-4.5,0.5,6", "--box", "0,0,0,1,2,3" });
  EXPECT_EQ(arguments.points("landmarks"), (Points{ { -1.0, -2.0, 3.0 }, { 4.5, -0.5, 6.0 } }));
  EXPECT_EQ(arguments.points("seed"), (Points{ { 1.0, 2.0, 3.0 } }));
  EXPECT_EQ(arguments.reals("box"), (Reals{ 0.0, 0.0, 0.0, 1.0, 2.0, 3.0 }));
  EXPECT_EQ(parseMany({}).points("seed"), Points{});
}

TEST(ModuleArguments, FilesTransformsAndFoldersAreTexts)
{
  const ModuleArguments arguments = parseMany({ "--transform", "t.h5", "--folder", "/a b,c/" });
  EXPECT_EQ(arguments.text("transform"), "t.h5");
  EXPECT_EQ(arguments.text("folder"), "/a b,c/"); // no list: commas are its own
}

TEST(ModuleArguments, EveryElementIsChecked)
{
  expectRefusalOfMany({ "--size", "1,10" }, "--size: 10 is not 0 to 9");
  expectRefusalOfMany({ "--size", "1,,2" }, "\"\" is not a whole number");
  expectRefusalOfMany({ "--size", "1,2.5" }, "\"2.5\" is not a whole number");
  expectRefusalOfMany({ "--size=1", "--size=2" }, "given twice");
  expectRefusalOfMany({ "--weights", "1 2" }, "not a number");
  expectRefusalOfMany({ "--label", "1", "--label", "0" }, "0 is not 1 or more");
  expectRefusalOfMany({ "--label", "" }, "an empty value");
  expectRefusalOfMany({ "--seed", "1,2" }, "is not 3 numbers");
  expectRefusalOfMany({ "--seed", "1,2,3", "--seed", "1,2,3" }, "given twice");
  expectRefusalOfMany({ "--landmark", "1,2,nan" }, "not a number");
  expectRefusalOfMany({ "--landmark", "" }, "is not 3 numbers");
  expectRefusalOfMany({ "--box", "1,2,3" }, "is not 6 numbers");
  expectRefusalOfMany({ "--list", "a.fcsv,,b.fcsv" }, "an empty value");
}
