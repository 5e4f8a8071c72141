#include "QualityCommand.h"

#include "CommandErrors.h"
#include "Console.h"
#include "SameFile.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexCellReader.h"
#include "moserhex/HexMeshIO/QualityReport.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace moserhex::app
{
namespace
{

/** Below this overlap the mesh was hardly made from the label [1]. */
constexpr double smallestUsualDice = 0.1;

void
requireUsableOptions(const QualityCommandOptions & options)
{
  const InputOptions & image = options.labelImage;
  if ((image.label || image.segment || image.threshold) && image.file.empty())
  {
    throw UsageError("--label, --segment or --threshold without --label-image; say which image they are of");
  }
  for (const std::string & input : { options.mesh, image.file })
  {
    if (sameFile(input, options.jsonFile))
    {
      throw UsageError(fileMessage(input, "would be overwritten", "give another name for the JSON file"));
    }
  }
  if (!options.jsonFile.empty())
  {
    const AtomicFile probe(options.jsonFile);
  }
}

QualityReport::Label
compare(const HexCellFile & file, const QualityCommandOptions & options, std::vector<std::string> & warnings)
{
  const ChosenSolid solid = readSolid(options.labelImage);
  warnings.insert(warnings.end(), solid.image.warnings.begin(), solid.image.warnings.end());
  try
  {
    const LabelVolume voxels = labelVolumeOf(*solid.mask, solid.value);
    return {
      options.labelImage.file, solid.labelValues(), solid.name(), compareWithLabel(file.mesh, voxels, options.threads)
    };
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), options.mesh, error.what(), "give the mesh and the labelmap it was made from");
  }
}

QualityReport
measure(const QualityCommandOptions & options)
{
  const HexCellFile file = readHexCells(options.mesh, { options.labelImage.sandbox });
  QualityReport     report;
  report.file = options.mesh;
  report.nodes = file.mesh.nodes.size();
  report.warnings = file.warnings;
  report.quality = summarizeQuality(file.mesh, options.threads);
  if (std::isnan(report.quality.volumeVariance))
  {
    report.warnings.push_back("the mesh has no volume: the variance and all ratios to the mean volume are undefined");
  }
  else if (report.quality.volume < 0.0)
  {
    report.warnings.push_back("the mesh's volume is negative: the cells' nodes are in left-handed order");
  }
  if (!options.labelImage.file.empty())
  {
    report.label = compare(file, options, report.warnings);
    if (report.label->agreement.dice < smallestUsualDice)
    {
      report.warnings.push_back("mesh and label hardly overlap: are both in LPS millimetres, and of the same scan?");
    }
  }
  return report;
}

/** A ratio to a mean volume of 0 is undefined (NaN); one to an edge of no length is infinite, for Verdict the largest
 * number there is. */
std::string
numberText(double value, int digits)
{
  if (std::isnan(value))
  {
    return "undefined";
  }
  if (value >= std::numeric_limits<double>::max())
  {
    return "infinite";
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string
latticeText(const HexQualitySummary & quality)
{
  if (quality.paddingLayers > 0)
  {
    return " (lattice with " + std::to_string(quality.paddingLayers) +
           (quality.paddingLayers == 1 ? " layer of padding)" : " layers of padding)");
  }
  return quality.isLattice ? " (lattice)" : "";
}

void
printClass(const char * name, const HexClassQuality & quality)
{
  if (quality.cells > 0)
  {
    std::printf("%-16s %9zu %12s %10.2f %8.3f %10.3f\n",
                name,
                quality.cells,
                numberText(quality.volumeVariance, 3).c_str(),
                100.0 * static_cast<double>(quality.concaveCells) / static_cast<double>(quality.cells),
                quality.scaledJacobianMin,
                quality.scaledJacobianMedian);
  }
}

void
printClasses(const HexQualitySummary & quality)
{
  std::printf("%-16s %9s %12s %10s %8s %10s\n", "cells", "number", "vol. var.", "concave %", "SJ min", "SJ median");
  if (quality.isLattice)
  {
    printClass("corner", quality.corners);
    printClass("edge", quality.edges);
    printClass("rest", quality.rest);
  }
  printClass("all",
             { quality.cells,
               quality.concaveCells,
               quality.volumeVariance,
               quality.scaledJacobian.minimum,
               quality.scaledJacobian.median });
}

void
printDistribution(const char * name, const Distribution & distribution)
{
  std::printf("%-24s", name);
  for (const double value :
       { distribution.minimum, distribution.p01, distribution.median, distribution.p99, distribution.maximum })
  {
    std::printf(" %9s", numberText(value, 4).c_str());
  }
  std::printf("\n");
}

void
printReport(const QualityReport & report)
{
  const HexQualitySummary & quality = report.quality;
  printClasses(quality);
  std::printf("\n%-24s %9s %9s %9s %9s %9s\n", "", "min", "p01", "median", "p99", "max");
  printDistribution("scaled Jacobian", quality.scaledJacobian);
  printDistribution("min det J / mean volume", quality.minimumJacobian);
  printDistribution("aspect ratio", quality.aspectRatio);
  printDistribution("taper", quality.taper);
  printDistribution("skew", quality.skew);
  if (report.label)
  {
    printDistribution("nodes to label (mm)", report.label->agreement.boundaryNodes);
    printDistribution("faces to label (mm)", report.label->agreement.faceCentres);
  }

  std::printf("\ndet J > 0 in the whole cell: %zu certified, %zu are not, %zu undecided\n",
              quality.certified.positive,
              quality.certified.notPositive,
              quality.certified.undecided);
  std::printf("mesh: %zu nodes, %zu cells%s, %.3f mL, volume ratio %s to %s\n",
              report.nodes,
              quality.cells,
              latticeText(quality).c_str(),
              quality.volume / 1000.0,
              numberText(quality.ratioMin, 4).c_str(),
              numberText(quality.ratioMax, 4).c_str());
  if (report.label)
  {
    std::printf("%s: %.3f mL, volume error %.3g, Dice %.4f\n",
                report.label->name.c_str(),
                report.label->agreement.labelVolume / 1000.0,
                report.label->agreement.volumeError,
                report.label->agreement.dice);
  }
}

} // namespace

void
runQualityCommand(const QualityCommandOptions & options)
{
  requireUsableOptions(options);
  const QualityReport report = measure(options);
  if (!options.jsonFile.empty())
  {
    writeQualityReport(options.jsonFile, report);
  }
  for (const std::string & warning : report.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    printReport(report);
  }
}

} // namespace moserhex::app
