#include "TransferUsage.h"

#include "CommandErrors.h"
#include "PointFile.h"
#include "TransferFiles.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include <cmath>
#include <vector>

namespace moserhex::app
{
namespace
{

/** An option, and what it is for. */
struct OptionUse
{
  const char * name;
  bool         isGiven; ///< other than its default
  bool         hasPart; ///< in what is to be done
  const char * belongsTo;
};

/** Whether means over boxes of the cube are made of a subject's image. */
bool
makesMeans(const TransferOptions & options)
{
  const bool isOfSubject = !options.toCube.empty() || (options.conserve && !options.toMesh.empty());
  return !isOfPoints(options) && isOfSubject && options.sampling != "nodes";
}

/** Every option that is of some directions or with some other options only. */
std::vector<OptionUse>
usesOf(const TransferOptions & options)
{
  const TransferOptions defaults;
  const bool            isImage = !isOfPoints(options);
  const bool            isToCube = !options.toCube.empty();
  const bool            isFromCube = !isToCube && options.toMesh.empty();
  const bool            atNodes = options.sampling == "nodes";
  const bool            isPlain = !options.conserve && !options.rotate;
  return {
    { "--like", !options.like.empty(), isImage && !isToCube, "--to-image" },
    { "--spacing", !options.spacing.empty(), isImage && !isToCube, "--to-image" },
    { "--sampling",
      options.sampling != defaults.sampling,
      isImage && (isToCube || (options.conserve && !isFromCube)),
      "--to-cube for images, and --conserve with --to-mesh" },
    { "--labels", options.labels, isImage && isPlain, "images, and excludes --conserve and --rotate" },
    { "--segment", !options.segment.empty(), options.labels, "--labels" },
    { "--fractions",
      options.fractions,
      options.labels && isToCube && !atNodes,
      "--labels with --to-cube, and needs cells: no --sampling nodes" },
    { "--conserve",
      options.conserve,
      isImage && !options.rotate && !atNodes,
      "images, excludes --rotate, and needs cells: no --sampling nodes" },
    { "--rotate", options.rotate, isImage, "images" },
    { "--values-in", !options.valuesIn.empty(), options.rotate, "--rotate" },
    { "--nearest",
      options.nearest,
      isImage && !(options.conserve && isFromCube),
      "images, and has no part in --conserve from the cube" },
    { "--points",
      options.pointsPerAxis != defaults.pointsPerAxis,
      makesMeans(options),
      "means over cells: images to the cube, or --conserve with --to-mesh" },
    { "--background", options.background != defaults.background, isImage, "images" },
  };
}

/** \throws UsageError  of labels, it is none */
void
requireBackgroundLabel(const TransferOptions & options)
{
  const double value = options.background;
  if (options.labels && !(value >= 0.0 && value <= mostLabelValue && value == std::floor(value)))
  {
    throw UsageError("--background is no label: need a whole number from 0 to " + std::to_string(mostLabelValue));
  }
}

/** \throws UsageError  of an image, before any work is done */
void
requireImageOutput(const TransferOptions & options)
{
  const std::string & output = options.toCube.empty() ? options.toImage : options.toCube;
  if (!isFieldImageName(output))
  {
    throw UsageError(
      fileMessage(output, "images are written as NRRD or NIfTI-1", "give a .nrrd, .nii or .nii.gz name"));
  }
  if (options.toImage.empty())
  {
    return;
  }
  if (options.like.empty() == options.spacing.empty())
  {
    throw UsageError("--to-image needs --like IMAGE or --spacing MM, one of them");
  }
  if (options.spacing.size() == 2)
  {
    throw UsageError("--spacing takes one or three numbers");
  }
}

void
requireFittingOutput(const TransferOptions & options)
{
  if (isOfPoints(options) && !options.toImage.empty())
  {
    throw UsageError(fileMessage(options.input, "a list of points, not an image", "give --to-points or --to-cube"));
  }
  if (!isOfPoints(options) && !options.toPoints.empty())
  {
    throw UsageError(fileMessage(options.input, "not a list of points", "give a .fcsv, .mrk.json, .csv or .tsv file"));
  }
}

} // namespace

bool
isOfPoints(const TransferOptions & options)
{
  return isPointFileName(options.input);
}

void
requirePartOfEveryOption(const TransferOptions & options)
{
  requireFittingOutput(options);
  for (const OptionUse & use : usesOf(options))
  {
    if (use.isGiven && !use.hasPart)
    {
      throw UsageError(std::string(use.name) + " has no part in this: it is of " + use.belongsTo);
    }
  }
  requireBackgroundLabel(options);
  if (!isOfPoints(options))
  {
    requireImageOutput(options);
  }
}

} // namespace moserhex::app
