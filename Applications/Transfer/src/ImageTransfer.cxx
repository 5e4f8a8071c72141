#include "ImageTransfer.h"

#include "CommandErrors.h"
#include "LabelShares.h"
#include "SubjectFunction.h"
#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubeAxes.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/CubeSamples.h"
#include "moserhex/CubeTransfer/FieldFunction.h"
#include "moserhex/CubeTransfer/GridMasses.h"
#include "moserhex/CubeTransfer/GridSamples.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace moserhex::app
{
namespace
{

/** Boxes of the cube along each axis. \throws UsageError  not a number, or nodes */
int
boxesOf(const TransferOptions & options, const HexMesh & mesh)
{
  return boxesPerAxis("--sampling", options.sampling, mesh.nodesPerSide - 1);
}

/** Mean times volume. */
FieldVolume
massesOf(FieldVolume means, const std::vector<double> & volumes)
{
  for (std::size_t box = 0; box < volumes.size(); ++box)
  {
    std::for_each(means.at(box), means.at(box) + means.components, [&](double & value) { value *= volumes[box]; });
  }
  return means;
}

/** The image with background where its voxels have no data. */
FieldVolume
withBackground(const TransferImage & image, double background)
{
  FieldVolume result = image.volume;
  for (std::size_t voxel = 0; voxel < image.hasValue.size(); ++voxel)
  {
    if (image.hasValue[voxel] == 0)
    {
      std::fill_n(result.at(voxel), result.components, background);
    }
  }
  return result;
}

std::string
numberText(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

double
sumOf(const FieldVolume & image)
{
  return std::accumulate(image.values.begin(), image.values.end(), 0.0);
}

FieldVolume
imageOfCube(const HexMesh &         mesh,
            const TransferImage &   image,
            const SubjectFunction & f,
            const TransferOptions & options,
            const TransferLog &     log)
{
  if (options.sampling == "nodes")
  {
    return cubeNodeSamples(mesh, std::cref(f), f.components(), options.threads);
  }
  const CubeMeanOptions means = meanOptions(options, boxesOf(options, mesh), mesh, image.volume);
  if (options.labels)
  {
    const FieldVolume fractions = labelFractions(mesh, f, image, means).image;
    return options.fractions ? withoutBackground(fractions) : majority(fractions, image.labels);
  }
  const CubeMeans result = cubeMeans(mesh, std::cref(f), f.components(), means);
  if (f.components() == 1)
  {
    const double volume = std::accumulate(result.volumes.begin(), result.volumes.end(), 0.0);
    log.say("integral over the mesh: " + numberText(sumOf(massesOf(result.image, result.volumes))) + ", volume " +
            numberText(volume) + " mm3");
  }
  return result.image;
}

void
write(const std::string & fileName, const FieldVolume & image, const TransferOptions & options, const TransferLog & log)
{
  writeFieldImage(fileName, image, valuesOf(options, image));
  log.say(fileName + ": " + std::to_string(image.size[0]) + " x " + std::to_string(image.size[1]) + " x " +
          std::to_string(image.size[2]) + ", " + std::to_string(image.components) +
          (image.components == 1 ? " number each" : " numbers each"));
}

void
toCube(const TransferOptions & options, const TransferLog & log)
{
  if (options.sampling == "nodes" && (options.conserve || options.fractions))
  {
    throw UsageError("--conserve and --fractions need cells; leave --sampling nodes out");
  }
  if (!options.like.empty() || !options.spacing.empty())
  {
    throw UsageError("--like and --spacing are of --to-image");
  }
  const TransferImage   image = readTransferImage(options, log);
  const HexMesh         mesh = readTransferMesh(options.mesh, options);
  const SubjectFunction f(image.volume, image.hasValue, options);
  const FieldVolume     result = imageOfCube(mesh, image, f, options, log);
  f.requireCover(log);
  write(options.toCube, result, options, log);
}

void
writeMasses(const HexMesh &         mesh,
            const FieldVolume &     masses,
            const VoxelGrid &       grid,
            const TransferOptions & options,
            const TransferLog &     log)
{
  const CubeMap   map(mesh);
  GridMassOptions massOptions;
  massOptions.background = options.background;
  massOptions.threads = options.threads;
  const GridMasses result = gridMasses(map, mesh, masses, grid, massOptions);
  if (result.reached == 0)
  {
    throw BadInput(
      ErrorCode::Geometry, options.like, "the grid does not reach the mesh", "give an image of the subject");
  }
  const double outside = std::accumulate(result.outside.begin(), result.outside.end(), 0.0);
  if (outside != 0.0)
  {
    char text[120];
    std::snprintf(text, sizeof text, "%.6g of the integral %.6g lies beyond the grid", outside, sumOf(masses));
    log.warn(text);
  }
  if (masses.components == 1)
  {
    log.say("integral over the mesh: " + numberText(sumOf(masses)));
  }
  write(options.toImage, result.image, options, log);
}

void
writeSamples(const HexMesh &         mesh,
             const CubeFunction &    f,
             int                     components,
             const VoxelGrid &       grid,
             const TransferOptions & options,
             const TransferLog &     log)
{
  const CubeMap     map(mesh);
  const GridSamples result = gridSamples(map, mesh, f, components, grid, { options.background, options.threads });
  if (result.inside == 0)
  {
    throw BadInput(ErrorCode::Geometry,
                   options.like.empty() ? options.mesh : options.like,
                   "no voxel centre lies in the mesh",
                   "give an image of the subject, or smaller voxels");
  }
  log.say(std::to_string(result.inside) + " voxels in the mesh");
  write(options.toImage, result.image, options, log);
}

CubeSampling
requireCube(const FieldVolume & image, const TransferOptions & options)
{
  try
  {
    return cubeSamplingOf(image);
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(ErrorCode::Geometry, options.input, error.what(), "give --to-mesh if it is the image of a subject");
  }
}

void
cubeToImage(const TransferOptions & options, const TransferLog & log)
{
  const TransferImage cube = readTransferImage(options, log);
  const CubeSampling  sampling = requireCube(cube.volume, options);
  const HexMesh       mesh = readTransferMesh(options.mesh, options);
  const VoxelGrid     grid = readTargetGrid(options, mesh);
  if (options.conserve && sampling == CubeSampling::Nodes)
  {
    throw BadInput(ErrorCode::Precondition,
                   options.input,
                   "samples at nodes have no integral",
                   "make it with --sampling cells, or leave --conserve out");
  }
  if (options.conserve)
  {
    const std::vector<double> volumes = cubeVolumes(mesh, { cube.volume.size[0], 2, options.threads });
    writeMasses(mesh, massesOf(withBackground(cube, options.background), volumes), grid, options, log);
    return;
  }
  const FieldFunction field(cube.volume, cube.hasValue, interpolationOf(options));
  const int           components = cube.volume.components;
  const CubeFunction  f = [&](const CubePoint & point, double * values) {
    if (!field.evaluate(point.cube, values)) // beyond a mask: the whole cube is in the image
    {
      std::fill_n(values, components, options.background);
    }
    else if (options.rotate)
    {
      turn(rotationPart(point.jacobian), components, values);
    }
  };
  writeSamples(mesh, f, components, grid, options, log);
}

void
subjectToSubject(const TransferOptions & options, const TransferLog & log)
{
  const TransferImage   image = readTransferImage(options, log);
  const HexMesh         from = readTransferMesh(options.mesh, options);
  const HexMesh         to = readTransferMesh(options.toMesh, options);
  const VoxelGrid       grid = readTargetGrid(options, to);
  const SubjectFunction subject(image.volume, image.hasValue, options);
  if (options.conserve)
  {
    const CubeMeans means = cubeMeans(
      from, std::cref(subject), subject.components(), meanOptions(options, boxesOf(options, from), from, image.volume));
    subject.requireCover(log);
    writeMasses(to, massesOf(means.image, means.volumes), grid, options, log);
    return;
  }
  const CubeMap      map(from);
  const CubeFunction f = [&](const CubePoint & point, double * values) {
    subject(cubePoint(from, map.place(point.cube)), values);
    if (options.rotate)
    {
      turn(rotationPart(point.jacobian), subject.components(), values);
    }
  };
  writeSamples(to, f, subject.components(), grid, options, log);
  subject.requireCover(log);
}

void
requireImageOptions(const TransferOptions & options)
{
  if (!options.toPoints.empty())
  {
    throw UsageError(fileMessage(options.input, "not a list of points", "give a .fcsv, .mrk.json, .csv or .tsv file"));
  }
  if (options.labels && (options.conserve || options.rotate))
  {
    throw UsageError("--labels excludes --conserve and --rotate");
  }
  if (options.fractions && (!options.labels || options.toCube.empty()))
  {
    throw UsageError("--fractions needs --labels and --to-cube");
  }
  if (!options.valuesIn.empty() && !options.rotate)
  {
    throw UsageError("--values-in is of --rotate");
  }
  if (options.conserve && options.rotate)
  {
    throw UsageError("--conserve excludes --rotate");
  }
}

} // namespace

void
transferImage(const TransferOptions & options, const TransferLog & log)
{
  requireImageOptions(options);
  if (!options.toCube.empty())
  {
    toCube(options, log);
  }
  else if (options.toMesh.empty())
  {
    cubeToImage(options, log);
  }
  else
  {
    subjectToSubject(options, log);
  }
}

} // namespace moserhex::app
