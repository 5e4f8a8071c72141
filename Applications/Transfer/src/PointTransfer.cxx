#include "PointTransfer.h"

#include "CommandErrors.h"
#include "PointFile.h"
#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubeMap.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{

void
requirePointOptions(const TransferOptions & options)
{
  if (!options.toImage.empty())
  {
    throw UsageError(fileMessage(options.input, "a list of points, not an image", "give --to-points or --to-cube"));
  }
  const bool isTable = options.toCube.empty() ||
                       options.toCube.find(".csv", options.toCube.size() - 4) != std::string::npos ||
                       options.toCube.find(".tsv", options.toCube.size() - 4) != std::string::npos;
  if (!isTable)
  {
    throw UsageError(
      fileMessage(options.toCube, "cube coordinates are written as a table", "give a .csv or .tsv name"));
  }
  if (!options.toPoints.empty() && !isPointFileName(options.toPoints))
  {
    throw UsageError(
      fileMessage(options.toPoints, "not the name of a list of points", "give .fcsv, .mrk.json, .csv or .tsv"));
  }
  if (options.labels || options.conserve || options.rotate || !options.valuesIn.empty() || options.nearest ||
      !options.like.empty() || !options.spacing.empty())
  {
    throw UsageError("--labels, --conserve, --rotate, --values-in, --nearest, --like and --spacing are for images");
  }
}

/** Sets the cube coordinates of points by their positions; of those outside, none. */
void
findInCube(const CubeMap & map, const std::string & meshFile, const TransferLog & log, PointList & list)
{
  for (ListedPoint & point : list.points)
  {
    point.cube.reset();
    if (!point.position)
    {
      log.warn(oneLine(point.name, 60) + ": no position, left empty");
      continue;
    }
    const auto place = map.find(*point.position);
    if (!place)
    {
      log.warn(oneLine(point.name, 60) + ": outside of the mesh " + oneLine(meshFile, 80) + ", left empty");
      continue;
    }
    point.cube = map.cubeCoordinates(*place);
  }
}

/** Sets the positions of points by their cube coordinates; of those without or outside of the cube, none. */
void
findInMesh(const CubeMap & map, const TransferLog & log, PointList & list)
{
  for (ListedPoint & point : list.points)
  {
    point.position.reset();
    if (point.cube && point.cube->minCoeff() >= 0.0 && point.cube->maxCoeff() <= 1.0)
    {
      point.position = map.position(map.place(*point.cube));
    }
    else
    {
      log.warn(oneLine(point.name, 60) + ": " + (point.cube ? "outside of the cube" : "no cube coordinates") +
               ", left empty");
    }
  }
}

std::size_t
countOf(const PointList & list, bool inCube)
{
  return static_cast<std::size_t>(
    std::count_if(list.points.begin(), list.points.end(), [inCube](const ListedPoint & point) {
      return inCube ? point.cube.has_value() : point.position.has_value();
    }));
}

} // namespace

void
transferPoints(const TransferOptions & options, const TransferLog & log)
{
  requirePointOptions(options);
  PointList     list = readPoints(options.input);
  const HexMesh mesh = readTransferMesh(options.mesh, options);
  const CubeMap map(mesh);
  const bool    isToCube = !options.toCube.empty();
  if (isToCube || !options.toMesh.empty())
  {
    findInCube(map, options.mesh, log, list);
  }
  if (!options.toMesh.empty())
  {
    const HexMesh other = readTransferMesh(options.toMesh, options);
    findInMesh(CubeMap(other), {}, list); // findInCube has
  }
  else if (!isToCube)
  {
    findInMesh(map, log, list);
  }
  const std::string & output = isToCube ? options.toCube : options.toPoints;
  writePoints(output, list);
  log.say(output + ": " + std::to_string(countOf(list, isToCube)) + " of " + std::to_string(list.points.size()) +
          " points");
}

} // namespace moserhex::app
