// Exact: options to text and back.
#include "MeshArguments.h"

#include "CommandErrors.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex::app;

namespace
{

using Values = std::vector<std::pair<std::string, std::string>>;

/** None as by default. */
MeshCommandOptions
otherOptions()
{
  MeshCommandOptions options;
  options.input.label = 7;
  options.input.segment = "--a 'b' \"c\", [d]=e ";
  options.input.threshold = 0.1 + 0.2;
  options.input.sandbox = false;
  options.shells = 4;
  options.padding = 1;
  options.way = "faithful";
  options.frame = "ridge";
  options.density = "a b/d.nrrd";
  options.allowPartial = true;
  options.shellMethod = "eikonal";
  options.topology = "reject";
  options.maximumRepairPercent = 1.0 / 3.0;
  return options;
}

/** The options of a command line over others. */
MeshCommandOptions
set(const std::vector<std::string> & arguments, MeshCommandOptions options = {})
{
  Values values;
  for (const std::string & argument : arguments)
  {
    const std::size_t equal = argument.find('=');
    values.emplace_back(argument.substr(2, equal - 2), argument.substr(equal + 1));
  }
  setMeshingOptions(values, options);
  return options;
}

std::string
refusal(const Values & values)
{
  MeshCommandOptions options;
  try
  {
    setMeshingOptions(values, options);
  }
  catch (const UsageError & error)
  {
    return error.what();
  }
  return "no error";
}

bool
gives(const std::vector<std::string> & arguments, const std::string & name)
{
  const std::string beginning = "--" + name + "=";
  return std::any_of(arguments.begin(), arguments.end(), [&beginning](const std::string & argument) {
    return argument.compare(0, beginning.size(), beginning) == 0;
  });
}

} // namespace

TEST(MeshArguments, EveryOptionIsGiven)
{
  MeshCommandOptions options = otherOptions();
  options.templateMesh = "t.vtu"; // contradicts some of the others
  options.landmarks = "l.csv";
  options.templateLandmarks = "tl.csv";
  options.image = "i.nrrd";
  options.templateImage = "ti.nrrd";
  options.localGrowth = true;
  const std::vector<std::string> arguments = meshingArguments(options);
  for (const std::string & name : meshingOptionNames())
  {
    EXPECT_TRUE(gives(arguments, name)) << name;
  }
  EXPECT_EQ(arguments.size(), meshingOptionNames().size());
}

TEST(MeshArguments, NamesAreLongOnesWithoutDashesAndNoHelp)
{
  const std::vector<std::string> & names = meshingOptionNames();
  for (const std::string name : { "shells", "label", "no-sandbox", "allow-partial", "max-repair", "density" })
  {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_EQ(std::count(names.begin(), names.end(), "help"), 0);
}

TEST(MeshArguments, OptionsComeBackAsTheyWere)
{
  const MeshCommandOptions options = otherOptions();
  const MeshCommandOptions again = set(meshingArguments(options));
  EXPECT_EQ(again.input.label, options.input.label);
  EXPECT_EQ(again.input.segment, options.input.segment);
  EXPECT_EQ(again.input.threshold, options.input.threshold);
  EXPECT_EQ(again.input.sandbox, options.input.sandbox);
  EXPECT_EQ(again.shells, options.shells);
  EXPECT_EQ(again.padding, options.padding);
  EXPECT_EQ(again.way, options.way);
  EXPECT_EQ(again.frame, options.frame);
  EXPECT_EQ(again.density, options.density);
  EXPECT_EQ(again.allowPartial, options.allowPartial);
  EXPECT_EQ(again.shellMethod, options.shellMethod);
  EXPECT_EQ(again.topology, options.topology);
  EXPECT_EQ(again.maximumRepairPercent, options.maximumRepairPercent);
  EXPECT_EQ(meshingArguments(again), meshingArguments(options));
}

TEST(MeshArguments, StagesComeBackAsTheyWere)
{
  MeshCommandOptions options;
  options.stage = "moser";
  EXPECT_EQ(set(meshingArguments(options)).stage, "moser");
}

TEST(MeshArguments, TemplatesComeBackAsTheyWereAndExcludeWhatTheyCannotHave)
{
  MeshCommandOptions options;
  options.templateMesh = "a b/t.vtu";
  options.align = "none";
  const MeshCommandOptions again = set(meshingArguments(options));
  EXPECT_EQ(again.templateMesh, options.templateMesh);
  EXPECT_EQ(again.align, options.align);
  EXPECT_EQ(meshingArguments(again), meshingArguments(options));
  options.align = "to the label.tfm";
  options.landmarks = "l.csv";
  options.templateLandmarks = "tl.csv";
  options.image = "i.nrrd";
  options.templateImage = "ti.nrrd";
  const MeshCommandOptions refined = set(meshingArguments(options));
  EXPECT_EQ(refined.align, options.align);
  EXPECT_EQ(refined.landmarks, options.landmarks);
  EXPECT_EQ(refined.templateLandmarks, options.templateLandmarks);
  EXPECT_EQ(refined.image, options.image);
  EXPECT_EQ(refined.templateImage, options.templateImage);
  EXPECT_EQ(meshingArguments(refined), meshingArguments(options));
  for (const auto & [name, value] :
       Values{ { "padding", "1" }, { "way", "fast" }, { "frame", "ridge" }, { "stage", "moser" } })
  {
    EXPECT_NE(refusal({ { "template", "t.vtu" }, { name, value } }).find("--template"), std::string::npos) << name;
  }
  EXPECT_EQ(refusal({ { "template", "t.vtu" }, { "density", "d.nrrd" } }), "no error");
  EXPECT_NE(
    refusal({ { "template", "t.vtu" }, { "density", "d.nrrd" }, { "image", "i.nrrd" }, { "template-image", "t.nrrd" } })
      .find("--density"),
    std::string::npos);
}

TEST(MeshArguments, DefaultsAreGivenTooSoThatOthersDoNotCount)
{
  MeshCommandOptions flagged;
  flagged.input.sandbox = false;
  flagged.allowPartial = true;
  flagged.shells = 4;
  const MeshCommandOptions again = set(meshingArguments({}), flagged);
  EXPECT_EQ(meshingArguments(again), meshingArguments({}));
  EXPECT_TRUE(again.input.sandbox);
  EXPECT_FALSE(again.allowPartial);
  EXPECT_FALSE(again.input.label);
  EXPECT_FALSE(again.way);
}

TEST(MeshArguments, OptionsThatAreNotNamedStay)
{
  MeshCommandOptions options = otherOptions();
  setMeshingOptions({ { "shells", "6" } }, options);
  EXPECT_EQ(options.shells, 6);
  EXPECT_EQ(options.padding, 1);
  EXPECT_FALSE(options.input.sandbox);
}

TEST(MeshArguments, WrongValuesAreRefusedWithTheOptionsName)
{
  for (const auto & [name, value] : Values{ { "shells", "1" },
                                            { "shells", "x" },
                                            { "label", "3.5" },
                                            { "label", "99999999999" },
                                            { "threshold", "half" },
                                            { "padding", "-1" },
                                            { "max-repair", "101" },
                                            { "topology", "mend" },
                                            { "stage", "II" },
                                            { "way", "slow" },
                                            { "frame", "x" },
                                            { "align", "x" },
                                            { "shell-method", "x" },
                                            { "no-sandbox", "maybe" },
                                            { "allow-partial", "maybe" },
                                            { "segment", "" } })
  {
    EXPECT_NE(refusal({ { name, value } }).find("--" + name), std::string::npos) << name << ": " << value;
  }
}

TEST(MeshArguments, OtherOptionsAndContradictionsAreRefused)
{
  EXPECT_NE(refusal({ { "report", "r.json" } }).find("no option of mesh is called report"), std::string::npos);
  EXPECT_NE(refusal({ { "help", "" } }).find("no option of mesh is called help"), std::string::npos);
  EXPECT_NE(refusal({ { "shells=3 --label", "3" } }).find("no option"), std::string::npos);
  EXPECT_NE(refusal({ { "padding", "1" }, { "stage", "moser" } }).find("--padding needs"), std::string::npos);
  EXPECT_NE(refusal({ { "shells", "3" }, { "shells", "4" } }).find("--shells"), std::string::npos);
}
