#include "AtlasCommand.h"

#include "AtlasFiles.h"
#include "CommandErrors.h"
#include "Console.h"
#include "EarlierAtlas.h"
#include "ModeMeshFiles.h"
#include "ModelUse.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <map>

namespace moserhex::app
{
namespace
{

constexpr double analysisPart = 0.6; ///< of the whole run, for progress only

/** K modes or P % of the variance. */
void
takeModes(AtlasCommandOptions & options)
{
  if (!options.reconstructWith.empty() && !options.areModesGiven)
  {
    options.varianceFraction = 1.0; // all that the model has
    return;
  }
  const bool   isPercent = !options.modes.empty() && options.modes.back() == '%';
  const char * end = options.modes.data() + options.modes.size() - (isPercent ? 1 : 0);
  double       percent = 0.0;
  const auto   result = isPercent ? std::from_chars(options.modes.data(), end, percent)
                                  : std::from_chars(options.modes.data(), end, options.maximumModes);
  const bool   isUsable = isPercent ? percent > 0.0 && percent <= 100.0 : options.maximumModes > 0;
  if (result.ec != std::errc() || result.ptr != end || !isUsable)
  {
    throw UsageError("--modes " + options.modes + "; give a number from 1 or a part of the variance such as 95%");
  }
  options.varianceFraction = isPercent ? percent / 100.0 : 1.0;
}

void
takeAlignment(AtlasCommandOptions & options)
{
  static const std::map<std::string, AlignmentKind> kinds{ { "none", AlignmentKind::None },
                                                           { "rigid", AlignmentKind::Rigid },
                                                           { "similarity", AlignmentKind::Similarity } };
  options.alignment = kinds.at(options.alignmentName);
}

void
requireConsistent(const AtlasCommandOptions & options)
{
  const bool isTested = !options.group.empty() || !options.regressor.empty();
  const bool isModelUsed = !options.projectOnto.empty() || !options.reconstructWith.empty();
  if (!options.covariates.empty() && !isTested)
  {
    throw UsageError("--covariates without --group or --regress; say what is tested");
  }
  if ((isTested || !options.images.empty()) && isModelUsed)
  {
    throw UsageError("--group, --regress and --images need an analysis, not --project or --reconstruct");
  }
}

void
printTest(const AtlasTest & test)
{
  const PermutationResult & result = test.result;
  std::printf("%-11s %s: %zu %s, smallest family-wise p %.4g of at least %.4g; %td of %td %s at 0.05, %td by false "
              "discovery\n",
              test.name.c_str(),
              describe(test).c_str(),
              result.permutations,
              result.areAllOrders ? "orders, all there are" : "permutations",
              result.pFamilyWise.minCoeff(),
              result.smallestPossibleP,
              placesAtLevel(result.pFamilyWise),
              result.p.size(),
              placesOf(test),
              placesAtLevel(result.qFalseDiscovery));
}

void
printAtlas(const AtlasResult & result, const AtlasOptions & options, double seconds)
{
  const ShapeModel & shape = result.model.shape;
  std::printf("subjects    %zu, %zu nodes, %.3g mm from the mean after %s alignment (%d steps)\n",
              result.subjects.subjects.size(),
              result.mean.mesh.nodes.size(),
              result.alignment.deviation,
              nameOf(options.alignment),
              result.alignment.report.steps);
  std::printf(
    "mean        %.3f mL, volume variance %.2g, %zu of %zu cells certified; nodes moved %.3g mm, at most %.3g\n",
    result.mean.volume / 1000.0,
    result.mean.varianceAfter,
    result.mean.certified.positive,
    result.mean.mesh.cellCount(),
    result.mean.meanMove,
    result.mean.largestMove);
  std::printf("model       %td modes with %.1f %% of the variance, the first %.1f %%\n",
              shape.modes.cols(),
              100.0 * shape.variances.sum() / shape.totalVariance,
              100.0 * shape.variances[0] / shape.totalVariance);
  if (!result.quality.compactness.empty())
  {
    std::printf("quality     generalisation %.3g mm, specificity %.3g mm with %zu modes\n",
                result.quality.generalisation.back(),
                result.quality.specificity.back(),
                result.quality.compactness.size());
  }
  const auto exact = std::count_if(result.modeMeshes.begin(),
                                   result.modeMeshes.end(),
                                   [](const ModeMeshFigures & mesh) { return mesh.deviations != 0.0; });
  std::printf("mode meshes %td of %zu exact\n", exact, result.modeMeshes.size());
  if (result.images)
  {
    std::printf("images      mean of %zu, %zu left out, %d x %d x %d in the cube\n",
                result.images->subjects,
                result.images->leftOut.size(),
                result.images->mean.size[0],
                result.images->mean.size[1],
                result.images->mean.size[2]);
  }
  for (const AtlasTest & test : result.tests)
  {
    printTest(test);
  }
  std::printf("files       %s, %.1f s\n", options.outputFolder.c_str(), seconds);
}

void
printWarnings(const std::vector<std::string> & warnings)
{
  for (const std::string & warning : warnings)
  {
    printWarning(warning);
  }
}

void
makeAtlas(const AtlasOptions & options)
{
  const Stopwatch stopwatch;
  AtlasResult     result = [&] {
    ProgressPrinter printer(options.quiet);
    AtlasResult     all = analyse(options, [&printer](double fraction) { printer.show(analysisPart * fraction); });
    removeEarlierAtlas(options.outputFolder);
    markAtlasBegun(options.outputFolder);
    writeModeMeshes(
      all, options, [&printer](double fraction) { printer.show(analysisPart + (1.0 - analysisPart) * fraction); });
    return all;
  }();
  printWarnings(result.warnings);
  const auto known = static_cast<std::ptrdiff_t>(result.warnings.size());
  writeAtlas(result, options);
  printWarnings({ result.warnings.begin() + known, result.warnings.end() });
  if (!options.quiet)
  {
    printAtlas(result, options, stopwatch.seconds());
  }
  if (!result.mean.exact)
  {
    throw NoMeshError(ErrorCode::NotExact,
                      options.outputFolder + "/mean.vtu",
                      "the mean is not an exact mesh: " + result.mean.shortcomings.front(),
                      "are the subjects' lattices alike?");
  }
}

} // namespace

const CLI::App *
addAtlasCommand(CLI::App & program, AtlasCommandOptions & options)
{
  CLI::App * command = program.add_subcommand(
    "atlas", "Mean, modes of variation and tests of groups over the meshes of many subjects; or use such a model");
  command
    ->add_option("INPUT",
                 options.inputs,
                 "Meshes (.vtu .vtk .msh .mesh .inp), folders of them, or one table (.csv .tsv) with a column mesh "
                 "and others for --group, --regress and --covariates")
    ->required();
  command->add_option("--output", options.outputFolder, "Folder to write to")->required();
  CLI::Option * project =
    command->add_option("--project", options.projectOnto, "Model (model.json) to get the INPUT meshes' scores of");
  CLI::Option * reconstruct = command
                                ->add_option("--reconstruct",
                                             options.reconstructWith,
                                             "Model (model.json) to make meshes with; INPUT: scores.csv")
                                ->excludes(project);
  CLI::Option * align =
    command
      ->add_option("--align", options.alignmentName, "What is taken out before: nothing, place and turn, or size, too")
      ->check(CLI::IsMember({ "none", "rigid", "similarity" }))
      ->capture_default_str();
  command
    ->add_option("--modes",
                 options.modes,
                 "Modes to keep: a number, or a part of the variance such as 95%; to --reconstruct with [all]")
    ->each([&options](const std::string &) { options.areModesGiven = true; })
    ->capture_default_str()
    ->excludes(project);
  CLI::Option * modeMeshes = command
                               ->add_option("--mode-meshes",
                                            options.modeMeshes,
                                            "Modes whose meshes at +-3 standard deviations are made, at most")
                               ->check(CLI::Range(0, 10000))
                               ->capture_default_str();
  command->add_option(
    "--group", options.group, "Column of two groups, or more that are words, to compare at every node");
  command->add_option("--regress", options.regressor, "Column of numbers to regress every node's place on");
  command->add_option("--covariates", options.covariates, "Columns, by commas, whose influence is taken out of both")
    ->delimiter(',')
    ->allow_extra_args(false);
  CLI::Option * permutations = command->add_option("--permutations", options.permutations, "Permutations of a test")
                                 ->check(CLI::Range(1, 10000000))
                                 ->capture_default_str();
  CLI::Option * samples = command->add_option("--samples", options.samples, "Random shapes for the model's specificity")
                            ->check(CLI::Range(1, 10000000))
                            ->capture_default_str();
  CLI::Option * seed =
    command->add_option("--seed", options.seed, "Of permutations and random shapes")->capture_default_str();
  CLI::Option * images =
    command->add_option("--images", options.images, "Column of image files to take the mean of, in the cube");
  command
    ->add_option("--image-sampling",
                 options.imageSampling,
                 "Of the cube: cells (means), nodes (values), or means of N boxes per axis")
    ->capture_default_str()
    ->needs(images);
  command
    ->add_flag("--normalise-images",
               options.normaliseImages,
               "Bring each image to mean 0 and deviation 1 within the organ first")
    ->needs(images);
  CLI::Option * labelSpacing =
    command->add_option("--label-spacing", options.labelSpacing, "Voxels of the template's labelmap in mm; 0: none")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  for (CLI::Option * ofAnalysis : { align, modeMeshes, permutations, samples, seed, labelSpacing })
  {
    ofAnalysis->excludes(project)->excludes(reconstruct);
  }
  command->add_flag(
    "!--no-sandbox", options.sandbox, "Read files in this process instead of a child with limits of memory and time");
  command->add_option("--threads", options.threads, "Threads to use; the result does not depend on it [all]")
    ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", options.quiet, "Print warnings and errors only");
  return command;
}

void
runAtlasCommand(AtlasCommandOptions options)
{
  takeModes(options);
  takeAlignment(options);
  requireConsistent(options);
  makeFolder(options.outputFolder);
  if (!options.projectOnto.empty())
  {
    printWarnings(projectMeshes(options));
  }
  else if (!options.reconstructWith.empty())
  {
    printWarnings(reconstructMeshes(options));
  }
  else
  {
    makeAtlas(options);
  }
}

} // namespace moserhex::app
