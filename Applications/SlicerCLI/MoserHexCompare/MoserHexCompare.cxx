// The Slicer module MoserHexCompare: options and outputs only; the work is compareSeries().
#include "ComparisonSummary.h"
#include "ModuleProgram.h"
#include "MoserHexCompareXml.h"
#include "OutputName.h"
#include "TextTable.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace moserhex;
using namespace moserhex::slicer;

app::CompareCommandOptions
optionsOf(const ModuleArguments & arguments)
{
  app::CompareCommandOptions options;
  options.meshes = { arguments.text("baseline"), arguments.text("followUp") };
  options.regions = { arguments.text("regions") };
  if (arguments.has("transform"))
  {
    options.transforms = { arguments.text("transform") };
  }
  else
  {
    options.align = arguments.text("align");
  }
  return options;
}

/** \throws UsageError  the model's file cannot hold arrays, an output is an input, or both outputs are one file */
void
requireUsableNames(const app::CompareCommandOptions & options, const ModuleArguments & arguments)
{
  const std::string model = arguments.text("outputModel");
  const std::string table = arguments.text("regionTable");
  if (!holdsNamedArrays(model))
  {
    throw app::UsageError(fileMessage(model, "cannot hold what is measured", "give a .vtk or .vtu file"));
  }
  std::vector<std::string> inputs = options.meshes;
  inputs.insert(inputs.end(), options.transforms.begin(), options.transforms.end());
  for (const std::string & input : inputs)
  {
    app::requireKept(input, model);
    app::requireKept(input, table);
  }
  if (app::sameFile(model, table))
  {
    throw app::UsageError(fileMessage(table, "is both model and table", "give the table another name"));
  }
}

/** Slicer reads tables by their ending, too. */
char
separatorOf(const std::string & table)
{
  return std::filesystem::path(table).extension() == ".csv" ? ',' : '\t';
}

SimpleOutputs
measurementsOf(const app::Comparison & comparison)
{
  const app::TimeComparison &  last = comparison.times.back();
  const WeightedDistribution & surface = app::ofOrgan(comparison.rows.back(), "signed_distance");
  const WeightedDistribution & loss = app::ofOrgan(comparison.rows.back(), "baseline_signed_distance");
  const WeightedDistribution & stretch = app::ofOrgan(comparison.rows.back(), "largest_stretch");
  return { { "baselineVolume", app::numberText(comparison.series.points.front().volume) },
           { "followUpVolume", app::numberText(comparison.series.points.back().volume) },
           { "volumeChange", app::numberText(app::volumeChange(comparison.series, 1)) },
           { "surfaceOut05", app::numberText(std::min(surface.p05, loss.p05)) },
           { "surfaceOut50", app::numberText(surface.median) },
           { "surfaceOut95", app::numberText(surface.p95) },
           { "largestStretch95", app::numberText(stretch.p95) },
           { "warnings", std::to_string(comparison.series.warnings.size()) },
           { "uniformGrowth", app::isUniformGrowth(last.cells) ? "yes" : "no" } };
}

SimpleOutputs
run(const ModuleArguments & arguments, ModuleProgress & progress)
{
  constexpr double                 afterReading = 0.4;
  constexpr double                 afterComparing = 0.7;
  const app::CompareCommandOptions options = optionsOf(arguments);
  requireUsableNames(options, arguments);
  progress.comment("reading the meshes");
  app::TimeSeries             series = app::readTimeSeries(options);
  std::vector<app::RegionSet> sets = app::chosenRegions(options.regions, series.points.front().lattice.nodesPerSide);
  progress.show(afterReading);
  progress.comment("comparing");
  const app::Comparison comparison =
    app::compareSeries(std::move(series), app::alignmentName(options), std::move(sets), options.threads);
  progress.show(afterComparing);
  progress.comment("writing");
  app::writeTimeMesh(arguments.text("outputModel"), comparison, 1);
  if (arguments.has("regionTable"))
  {
    const std::string table = arguments.text("regionTable");
    writeTextFile(table, app::regionTable(comparison, separatorOf(table)));
  }
  for (const std::string & warning : comparison.series.warnings)
  {
    std::printf("warning: %s\n", oneLine(warning, 190).c_str());
  }
  return measurementsOf(comparison);
}

} // namespace

int
main(int argc, char ** argv)
{
  return runModule(argc, argv, moserHexCompareXml, run);
}
