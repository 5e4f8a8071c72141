#include "PointTransfer.h"

#include "CommandErrors.h"
#include "PointFile.h"
#include "TextTable.h"
#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubeMap.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace moserhex::app
{
namespace
{

void
requireNamesOfTables(const TransferOptions & options)
{
  if (!options.toCube.empty() && !isTableName(options.toCube))
  {
    throw UsageError(
      fileMessage(options.toCube, "cube coordinates are written as a table", "give a .csv or .tsv name"));
  }
  if (!options.toPoints.empty() && !isPointFileName(options.toPoints))
  {
    throw UsageError(
      fileMessage(options.toPoints, "not the name of a list of points", "give .fcsv, .mrk.json, .csv or .tsv"));
  }
}

/** Why points have no place in the output, each with its name. */
using Losses = std::vector<std::string>;

/** Sets the cube coordinates of points by their positions; of those outside, none. */
Losses
findInCube(const CubeMap & map, const std::string & meshFile, PointList & list)
{
  Losses losses;
  for (ListedPoint & point : list.points)
  {
    point.cube.reset();
    if (!point.position)
    {
      losses.push_back(oneLine(point.name, 60) + ": no position");
      continue;
    }
    const auto place = map.find(*point.position);
    if (!place)
    {
      losses.push_back(oneLine(point.name, 60) + ": outside of the mesh " + oneLine(meshFile, 80));
      continue;
    }
    point.cube = map.cubeCoordinates(*place);
  }
  return losses;
}

/** Sets the positions of points by their cube coordinates; of those without or outside of the cube, none. */
Losses
findInMesh(const CubeMap & map, PointList & list)
{
  Losses losses;
  for (ListedPoint & point : list.points)
  {
    point.position.reset();
    if (point.cube && point.cube->minCoeff() >= 0.0 && point.cube->maxCoeff() <= 1.0)
    {
      point.position = map.position(map.place(*point.cube));
    }
    else
    {
      losses.push_back(oneLine(point.name, 60) + ": " + (point.cube ? "outside of the cube" : "no cube coordinates"));
    }
  }
  return losses;
}

std::size_t
countOf(const PointList & list, bool inCube)
{
  return static_cast<std::size_t>(
    std::count_if(list.points.begin(), list.points.end(), [inCube](const ListedPoint & point) {
      return inCube ? point.cube.has_value() : point.position.has_value();
    }));
}

PointList
readPointsToTransfer(const TransferOptions & options, const TransferLog & log)
{
  PointList list = readPoints(options.input);
  for (const std::string & warning : list.warnings)
  {
    log.warn(warning);
  }
  if (list.points.empty())
  {
    throw BadInput(ErrorCode::Empty, options.input, "a list without points", "give one with at least one point");
  }
  return list;
}

/** \throws UsageError  the points are in a subject, and no mesh leads out of it */
void
requireCubeCoordinates(const TransferOptions & options, const PointList & list)
{
  if (countOf(list, true) == 0)
  {
    throw UsageError(
      fileMessage(options.input, "no point has cube coordinates c1, c2, c3", "give --to-mesh for points of a subject"));
  }
}

/** Whether the output has points without a place: .fcsv has not. */
bool
keepsLost(const TransferOptions & options)
{
  std::string ending = std::filesystem::path(options.toPoints).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending != ".fcsv";
}

/** \throws BadInput (Geometry)  no point has a place; tells the losses otherwise */
void
requirePlaces(const TransferOptions & options, const Losses & losses, const PointList & list, const TransferLog & log)
{
  if (losses.size() == list.points.size())
  {
    throw BadInput(ErrorCode::Geometry,
                   options.input,
                   "no point has a place in the mesh (" + losses.front() + ")",
                   "give points of the mesh's own scan, in LPS millimetres");
  }
  for (const std::string & loss : losses)
  {
    log.warn(loss + (keepsLost(options) ? ", left empty" : ", left out"));
  }
}

/** What the output cannot hold. */
void
tellOfColumns(const TransferOptions & options, const PointList & list, const TransferLog & log)
{
  if (list.otherColumns.empty() || isTableName(options.toCube) || isTableName(options.toPoints))
  {
    return;
  }
  std::string names;
  for (const std::string & column : list.otherColumns)
  {
    names += (names.empty() ? "" : ", ") + oneLine(column, 30);
  }
  log.warn(fileMessage(options.toPoints, "cannot hold the columns " + names, "write .csv or .tsv to keep them"));
}

} // namespace

void
transferPoints(const TransferOptions & options, const TransferLog & log)
{
  requireNamesOfTables(options);
  PointList  list = readPointsToTransfer(options, log);
  const bool isToCube = !options.toCube.empty();
  const bool isFromCube = !isToCube && options.toMesh.empty();
  if (isFromCube)
  {
    requireCubeCoordinates(options, list);
  }
  const HexMesh mesh = readTransferMesh(options.mesh, options);
  const CubeMap map(mesh);
  requirePlaces(options, isFromCube ? findInMesh(map, list) : findInCube(map, options.mesh, list), list, log);
  if (!options.toMesh.empty())
  {
    const HexMesh other = readTransferMesh(options.toMesh, options);
    (void)findInMesh(CubeMap(other), list); // those without a place are told
  }
  tellOfColumns(options, list, log);
  const std::string & output = isToCube ? options.toCube : options.toPoints;
  writePoints(output, list);
  log.say(output + ": " + std::to_string(countOf(list, isToCube)) + " of " + std::to_string(list.points.size()) +
          " points");
}

} // namespace moserhex::app
