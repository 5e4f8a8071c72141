#include "CheckCommand.h"

#include "CommandErrors.h"
#include "Console.h"
#include "SameFile.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/CheckReport.h"

#include <cstdio>

namespace moserhex::app
{
namespace
{

void
requireUsableOptions(const CheckCommandOptions & options)
{
  if (options.allLabels && options.input.label)
  {
    throw UsageError("--all-labels and --label contradict each other");
  }
  if (sameFile(options.input.file, options.jsonFile))
  {
    throw UsageError(fileMessage(options.input.file, "would be overwritten", "give another name for the JSON file"));
  }
  if (!options.jsonFile.empty())
  {
    const AtomicFile probe(options.jsonFile);
  }
}

/** A repair that is not made: what it would change, or why it would be refused. */
LabelCheck::Repair
planRepair(const LabelVolume & label, double maximumPercent)
{
  LabelCheck::Repair    repair;
  TopologyRepairOptions options;
  options.maximumChange = maximumPercent / 100.0;
  options.labelName = "the label";
  try
  {
    repair.report = repairTopology(label, options).report;
  }
  catch (const InvalidInput & error)
  {
    repair.refusal = error.what();
  }
  return repair;
}

LabelCheck
checkLabel(const std::string & name, const LabelVolume & label, const CheckCommandOptions & options)
{
  LabelCheck check;
  check.name = name;
  check.diagnosis = diagnoseLabel(label, options.threads);
  check.repair = planRepair(label, options.maximumRepairPercent);
  return check;
}

std::vector<LabelCheck>
checkAll(const ChosenSolid & solid, const CheckCommandOptions & options)
{
  std::vector<LabelCheck> checks;
  if (!options.allLabels)
  {
    checks.push_back(checkLabel(solid.name(), labelVolumeOf(*solid.mask, solid.value), options));
    checks.back().labels = solid.labelValues();
    return checks;
  }
  for (const LabelEntry & entry : solid.image.labels)
  {
    checks.push_back(checkLabel(entry.name, labelVolumeOf(*solid.image.image, entry.value), options));
    checks.back().labels = { entry.value };
  }
  return checks;
}

std::string
verdictOf(const LabelCheck & check)
{
  if (check.diagnosis.isBall())
  {
    return "one solid of genus 0";
  }
  return check.repair.refusal.empty() ? "to be repaired" : "refused";
}

std::string
changedPercent(const LabelCheck & check)
{
  char text[32] = "-";
  if (check.repair.refusal.empty())
  {
    std::snprintf(text, sizeof(text), "%.3g", 100.0 * check.repair.report.changedFraction());
  }
  return text;
}

void
printTable(const std::vector<LabelCheck> & checks)
{
  std::printf("%8s %10s %10s %6s %9s %8s %8s %8s %8s  %-22s %s\n",
              "label",
              "voxels",
              "mL",
              "parts",
              "cavities",
              "handles",
              "edges",
              "borders",
              "repair %",
              "verdict",
              "name");
  for (const LabelCheck & check : checks)
  {
    const LabelDiagnosis & found = check.diagnosis;
    std::printf("%8lld %10zu %10.3f %6zu %9zu %8ld %8zu %8d %8s  %-22s %s\n",
                static_cast<long long>(check.labels.front()),
                found.voxels,
                found.volume / 1000.0,
                found.topology.components,
                found.topology.cavities,
                found.topology.handles(),
                found.nonManifoldEdges,
                found.borders.count(),
                changedPercent(check).c_str(),
                verdictOf(check).c_str(),
                check.name.c_str());
  }
}

void
printOne(const LabelCheck & check, const LabelImage & image)
{
  const LabelDiagnosis & found = check.diagnosis;
  const auto             size = image.image->GetLargestPossibleRegion().GetSize();
  const auto             spacing = image.image->GetSpacing();
  std::printf("%-10s %s\n", "file", image.fileName.c_str());
  std::printf("%-10s %lu x %lu x %lu voxels of %.4g x %.4g x %.4g mm\n",
              "image",
              static_cast<unsigned long>(size[0]),
              static_cast<unsigned long>(size[1]),
              static_cast<unsigned long>(size[2]),
              spacing[0],
              spacing[1],
              spacing[2]);
  std::printf("%-10s %s: %zu voxels, %.3f mL\n", "solid", check.name.c_str(), found.voxels, found.volume / 1000.0);
  std::printf("%-10s %d to %d, %d to %d, %d to %d\n",
              "voxels",
              found.firstIndex[0],
              found.lastIndex[0],
              found.firstIndex[1],
              found.lastIndex[1],
              found.firstIndex[2],
              found.lastIndex[2]);
  std::printf("%-10s %s; in the largest part, cavities filled: %s\n",
              "topology",
              describe(found.topology).c_str(),
              describe(found.largestComponent).c_str());
  std::printf("%-10s %zu edges and %zu corners where voxels touch without a common face\n",
              "contacts",
              found.nonManifoldEdges,
              found.nonManifoldVertices);
  std::printf("%-10s %s\n", "borders", found.borders.any() ? found.borders.names().c_str() : "none is touched");
  std::printf("%-10s %.3g mm, of the voxel that lies deepest\n", "depth", found.depth);
  for (const std::string & line : describe(check.repair.report))
  {
    std::printf("%-10s %s\n", "repair", line.c_str());
  }
  if (!check.repair.refusal.empty())
  {
    std::printf("%-10s %s\n", "repair", check.repair.refusal.c_str());
  }
  std::printf("%-10s %s\n", "verdict", verdictOf(check).c_str());
}

} // namespace

void
runCheckCommand(const CheckCommandOptions & options)
{
  requireUsableOptions(options);
  const ChosenSolid solid = readSolid(options.input);
  CheckReport       report;
  report.file = options.input.file;
  report.maximumRepairPercent = options.maximumRepairPercent;
  report.warnings = solid.image.warnings;
  report.checks = checkAll(solid, options);
  if (!options.jsonFile.empty())
  {
    writeCheckReport(options.jsonFile, report);
  }
  for (const std::string & warning : report.warnings)
  {
    printWarning(warning);
  }
  if (options.quiet)
  {
    return;
  }
  if (options.allLabels)
  {
    printTable(report.checks);
  }
  else
  {
    printOne(report.checks.front(), solid.image);
  }
}

} // namespace moserhex::app
