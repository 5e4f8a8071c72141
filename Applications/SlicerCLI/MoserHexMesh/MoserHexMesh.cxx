// The Slicer module MoserHexMesh: options and outputs only; the work is meshFile().
#include "MeshFile.h"
#include "ModuleProgram.h"
#include "MoserHexMeshXml.h"
#include "PageName.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexSurfaceWriter.h"

#include <cstdio>
#include <iomanip>
#include <limits>
#include <sstream>

namespace
{

using namespace moserhex;
using namespace moserhex::slicer;

app::MeshCommandOptions
optionsOf(const ModuleArguments & arguments)
{
  app::MeshCommandOptions options;
  options.input.file = arguments.text("inputLabelmap");
  if (arguments.integer("labelValue") != 0)
  {
    options.input.label = arguments.integer("labelValue");
  }
  if (arguments.has("segment"))
  {
    options.input.segment = arguments.text("segment");
  }
  options.output = arguments.text("outputMesh");
  const std::string report = arguments.text("report");
  (app::isPageName(report) ? options.pageFile : options.reportFile) = report;
  options.shells = static_cast<int>(arguments.integer("shells"));
  options.padding = static_cast<int>(arguments.integer("padding"));
  options.topology = arguments.text("topology");
  options.maximumRepairPercent = arguments.real("maximumRepair");
  options.allowPartial = arguments.flag("allowPartial");
  options.way = arguments.text("way");
  options.frame = arguments.text("frame");
  options.shellMethod = arguments.text("shellMethod");
  options.density = arguments.text("density");
  options.threads = static_cast<unsigned int>(arguments.integer("threads"));
  return options;
}

/** Digits that give the same number back. */
std::string
textOf(double value)
{
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  return text.str();
}

std::string
tableOf(const RunReport & report)
{
  std::string table = "stage\tseconds\tvolume variance\tconcave %\tscaled Jacobian min\tscaled Jacobian median\n";
  for (const StageRecord & stage : report.stages)
  {
    table += stage.name + "\t" + textOf(stage.seconds);
    if (stage.quality)
    {
      table += "\t" + textOf(stage.quality->volumeVariance) + "\t" + textOf(stage.quality->concavePercent) + "\t" +
               textOf(stage.quality->scaledJacobianMinimum) + "\t" + textOf(stage.quality->scaledJacobianMedian) + "\n";
    }
    else
    {
      table += "\t\t\t\t\n";
    }
  }
  return table;
}

SimpleOutputs
measurementsOf(const RunReport & report)
{
  const StageRecord & last = report.stages.back();
  return { { "labelVolume", textOf(report.input.volume) },
           { "meshVolume", textOf(report.mesh.volume) },
           { "cells", std::to_string(report.mesh.cells) },
           { "volumeVariance", textOf(report.exact->variance) },
           { "smallestScaledJacobian", textOf(last.quality->scaledJacobianMinimum) },
           { "medianScaledJacobian", textOf(last.quality->scaledJacobianMedian) },
           { "surfaceDistance", textOf(report.surface->maximum) },
           { "warnings", std::to_string(report.warnings.size()) },
           { "exact", report.exact->reached ? "yes" : "no" } };
}

SimpleOutputs
run(const ModuleArguments & arguments, ModuleProgress & progress)
{
  constexpr double        afterMesh = 0.98;
  app::MeshCommandOptions options = optionsOf(arguments);
  const auto              show = [&progress](double fraction) {
    progress.show(afterMesh * fraction);
    return true;
  };
  const app::MeshedFile meshed =
    app::meshFile(options, show, [&](const std::string & what) { progress.comment(what); });
  progress.comment("writing tables");
  if (arguments.has("outputSurface"))
  {
    writeHexSurface(arguments.text("outputSurface"), meshed.pipeline->GetHexMesh());
  }
  if (arguments.has("qualityTable"))
  {
    writeTextFile(arguments.text("qualityTable"), tableOf(meshed.report));
  }
  for (const std::string & warning : meshed.report.warnings)
  {
    std::printf("warning: %s\n", oneLine(warning, 190).c_str());
  }
  return measurementsOf(meshed.report);
}

} // namespace

int
main(int argc, char ** argv)
{
  return runModule(argc, argv, moserHexMeshXml, run);
}
