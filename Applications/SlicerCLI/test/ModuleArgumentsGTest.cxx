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

ModuleArguments
parse(const std::vector<std::string> & words)
{
  return { module(), words };
}

void
expectRefusal(const std::vector<std::string> & words, const std::string & what)
{
  try
  {
    (void)parse(words);
    FAIL() << what;
  }
  catch (const InvalidInput & error)
  {
    EXPECT_EQ(error.code(), ErrorCode::Usage);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

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
