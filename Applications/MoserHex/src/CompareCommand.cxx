#include "CompareCommand.h"

#include "ComparisonFiles.h"
#include "ComparisonSummary.h"
#include "Console.h"
#include "OutputName.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>

namespace moserhex::app
{
namespace
{

/** \throws UsageError  a file to be written is one of the meshes or tables that are read */
void
requireInputsKept(const CompareCommandOptions & options, const TimeSeries & series)
{
  std::vector<std::string> inputs = options.meshes;
  inputs.insert(inputs.end(), options.regions.begin(), options.regions.end());
  inputs.insert(inputs.end(), options.transforms.begin(), options.transforms.end());
  for (const std::string & output : filesOf(series, options.outputFolder))
  {
    for (const std::string & input : inputs)
    {
      requireKept(input, output);
    }
  }
}

} // namespace

CLI::App *
addCompareCommand(CLI::App & program, CompareCommandOptions & options)
{
  CLI::App * command = program.add_subcommand(
    "compare", "Say what has changed between a baseline and its follow-ups: strain, surface motion, thickness");
  command
    ->add_option(
      "MESH", options.meshes, "Lattice meshes of one organ in the order of time, the baseline first (.vtu .vtk ...)")
    ->required();
  command->add_option("--output", options.outputFolder, "Folder to write to")->required();
  command->add_option("--align", options.align, "What is no change: position and direction, size as well, nothing")
    ->check(CLI::IsMember({ "rigid", "similarity", "none" }))
    ->default_str("rigid");
  command
    ->add_option("--transforms",
                 options.transforms,
                 "Files with rigid transforms of ITK, one a follow-up, from the baseline's space to its, separated by "
                 "commas; in place of --align")
    ->delimiter(',')
    ->allow_extra_args(false);
  command
    ->add_option("--regions",
                 options.regions,
                 "octants, halves, shells, or a table (.csv .tsv) with name, imin, imax, jmin, jmax, kmin, kmax in "
                 "cube coordinates, separated by commas")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->capture_default_str();
  command->add_option("--times", options.times, "Months of the meshes, ascending, separated by commas")
    ->delimiter(',')
    ->allow_extra_args(false);
  command
    ->add_option("--names",
                 options.names,
                 "Names of the times, separated by commas [the files' names, with their folders where two are alike]")
    ->delimiter(',')
    ->allow_extra_args(false);
  command->add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
  command->add_option("--threads", options.threads, "Threads to use; the result does not depend on it [all]")
    ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", options.quiet, "Print warnings and errors only");
  return command;
}

void
runCompareCommand(const CompareCommandOptions & options)
{
  TimeSeries series = readTimeSeries(options);
  requireInputsKept(options, series);
  std::vector<RegionSet> sets = chosenRegions(options.regions, series.points.front().lattice.nodesPerSide);
  const Comparison       comparison =
    compareSeries(std::move(series), alignmentName(options), std::move(sets), options.threads);
  for (const std::string & warning : comparison.series.warnings)
  {
    printWarning(warning);
  }
  makeFolder(options.outputFolder);
  writeTimeMeshes(options.outputFolder, comparison);
  writeTextFile((std::filesystem::path(options.outputFolder) / "regions.csv").string(), regionTable(comparison, ','));
  writeComparisonSummary(options.outputFolder, comparison);
  if (!options.quiet)
  {
    const std::filesystem::path folder = options.outputFolder;
    std::printf("%sseries   %s\nregions  %s\nsummary  %s\n",
                describe(comparison).c_str(),
                (folder / "series.pvd").c_str(),
                (folder / "regions.csv").c_str(),
                (folder / "summary.json").c_str());
  }
}

} // namespace moserhex::app
