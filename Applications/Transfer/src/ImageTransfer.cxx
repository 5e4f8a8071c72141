#include "ImageTransfer.h"

#include "CommandErrors.h"
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

constexpr std::size_t mostFractions = 256;

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

/** Of every box the part of its volume in each label, 0 first. */
CubeMeans
labelFractions(const HexMesh &         mesh,
               const SubjectFunction & f,
               const TransferImage &   image,
               const CubeMeanOptions & options)
{
  if (image.labels.size() >= mostFractions)
  {
    throw UsageError("--labels: " + std::to_string(image.labels.size()) + " labels, at most " +
                     std::to_string(mostFractions - 1) + " by cells; take --sampling nodes");
  }
  std::vector<double> labels{ 0.0 };
  std::transform(image.labels.begin(), image.labels.end(), std::back_inserter(labels), [](const LabelEntry & entry) {
    return static_cast<double>(entry.value);
  });
  const auto indicators = [&f, &labels](const CubePoint & point, double * values) {
    double label = 0.0;
    f(point, &label);
    std::transform(labels.begin(), labels.end(), values, [label](double other) { return label == other ? 1.0 : 0.0; });
  };
  return cubeMeans(mesh, indicators, static_cast<int>(labels.size()), options);
}

/** The label with the largest part of each box, of equal ones the smallest. */
FieldVolume
majority(const FieldVolume & fractions, const std::vector<LabelEntry> & labels)
{
  FieldVolume result{ fractions, 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    const double * const first = fractions.at(box);
    const auto           largest = std::max_element(first, first + fractions.components) - first;
    result.values.push_back(largest == 0 ? 0.0 : labels[static_cast<std::size_t>(largest - 1)].value);
  }
  return result;
}

/** Without the first component, the background's. */
FieldVolume
withoutBackground(const FieldVolume & fractions)
{
  FieldVolume result{ fractions, fractions.components - 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    result.values.insert(result.values.end(), fractions.at(box) + 1, fractions.at(box) + fractions.components);
  }
  return result;
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
  const SubjectFunction f(image.volume, options);
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
    writeMasses(mesh, massesOf(cube.volume, volumes), grid, options, log);
    return;
  }
  const FieldFunction field(cube.volume, interpolationOf(options));
  const int           components = cube.volume.components;
  const CubeFunction  f = [&](const CubePoint & point, double * values) {
    (void)field.evaluate(point.cube, values); // the whole cube is in it
    if (options.rotate)
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
  const SubjectFunction subject(image.volume, options);
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
