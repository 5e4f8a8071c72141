// Exact: what the options of a command line become.
#include "CaseListArguments.h"

#include <CLI/CLI.hpp>

#include <gtest/gtest.h>

#include <algorithm>

using namespace moserhex::app;

namespace
{

CaseListOptions
parse(std::vector<std::string> arguments)
{
  CaseListOptions options;
  CLI::App        command;
  command.add_option("INPUT", options.inputs);
  addCaseListOptions(command, options);
  std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the end
  command.parse(arguments);
  return options;
}

} // namespace

TEST(CaseListArguments, DefaultsAreThoseOfTheStruct)
{
  const CaseListOptions options = parse({});
  EXPECT_EQ(options.ending, ".vtu");
  EXPECT_FALSE(options.allLabels);
  EXPECT_TRUE(options.include.empty());
}

TEST(CaseListArguments, OptionsThatMayBeRepeatedTakeOneValueEach)
{
  const CaseListOptions options = parse({ "--include",
                                          "*_dseg*",
                                          "a",
                                          "--include=*_mask*",
                                          "--exclude",
                                          "tmp*",
                                          "b",
                                          "--keep-columns",
                                          "age,sex",
                                          "c",
                                          "--all-labels",
                                          "--base",
                                          "in",
                                          "--format=.vtk" });
  EXPECT_EQ(options.inputs, (std::vector<std::string>{ "a", "b", "c" }));
  EXPECT_EQ(options.include, (std::vector<std::string>{ "*_dseg*", "*_mask*" }));
  EXPECT_EQ(options.exclude, std::vector<std::string>{ "tmp*" });
  EXPECT_EQ(options.keepColumns, (std::vector<std::string>{ "age", "sex" }));
  EXPECT_TRUE(options.allLabels);
  EXPECT_EQ(options.base, "in");
  EXPECT_EQ(options.ending, ".vtk");
}
