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
#include "moserhex/CubeTransfer/RefinedMeans.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace moserhex::app
{
namespace
{

constexpr double integralTolerance = 1e-6; ///< of a density, which --conserve keeps

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
sumOf(const FieldVolume & image, std::size_t component)
{
  double sum = 0.0;
  for (std::size_t voxel = 0; voxel < image.gridVoxels(); ++voxel)
  {
    sum += image.at(voxel)[component];
  }
  return sum;
}

/** "integral over the mesh", of which number where there are several. */
std::string
integralName(std::size_t component, int components)
{
  return "integral over the mesh" + (components == 1 ? "" : " of number " + std::to_string(component + 1));
}

void
tellIntegrals(const RefinedMeans & result, const TransferOptions & options, const TransferLog & log)
{
  const double volume = std::accumulate(result.means.volumes.begin(), result.means.volumes.end(), 0.0);
  for (std::size_t c = 0; c < result.integrals.size(); ++c)
  {
    char text[120];
    std::snprintf(text, sizeof text, ": %.9g +- %.2g, volume %.9g mm3", result.integrals[c], result.errors[c], volume);
    log.say(integralName(c, result.means.image.components) + text);
  }
  if (result.relativeError > integralTolerance)
  {
    char text[160];
    std::snprintf(text,
                  sizeof text,
                  ": the integral is known to %.2g only, of %.0e wanted: the image has steps or noise; "
                  "more --points may help",
                  result.relativeError,
                  integralTolerance);
    log.warn(oneLine(options.input, 60) + text);
  }
}

/** Means whose integral over the mesh is known to 1e-6, or a warning says how far it is. */
CubeMeans
conservedMeans(const HexMesh &         mesh,
               const TransferImage &   image,
               const SubjectFunction & f,
               const TransferOptions & options,
               const TransferLog &     log)
{
  const CubeMeanOptions rule = meanOptions(options, boxesOf(options, mesh), mesh, image.volume);
  CubeMeans             first = cubeMeans(mesh, std::cref(f), f.components(), rule);
  f.requireCover(log);
  const SubjectFunction finer(image.volume, image.hasValue, options); // what f counts is the mesh, evenly
  RefinementOptions     refinement;
  refinement.tolerance = integralTolerance;
  refinement.threads = options.threads;
  RefinedMeans result = refinedMeans(mesh, std::cref(finer), std::move(first), rule.pointsPerAxis, refinement);
  tellIntegrals(result, options, log);
  return std::move(result.means);
}

/** The volume of each label in the organ. */
LabelAmounts
labelVolumes(const HexMesh &         mesh,
             const CubeFunction &    labelAt,
             const TransferImage &   image,
             const CubeMeanOptions & rule,
             const TransferOptions & options)
{
  const std::vector<double> labels = labelsOfPlaces(image, options.background);
  return volumesOf(labelFractions(mesh, labelAt, labels, rule), labels);
}

FieldVolume
nodesOfCube(const HexMesh &         mesh,
            const TransferImage &   image,
            const SubjectFunction & f,
            const TransferOptions & options,
            const TransferLog &     log)
{
  FieldVolume result = cubeNodeSamples(mesh, std::cref(f), f.components(), options.threads);
  f.requireCover(log);
  if (options.labels && hasShares(image))
  {
    const SubjectFunction labelAt(image.volume, image.hasValue, options);
    const LabelAmounts    before = labelVolumes(
      mesh, std::cref(labelAt), image, meanOptions(options, mesh.nodesPerSide - 1, mesh, image.volume), options);
    const std::vector<double> one(result.values.size(), 1.0);
    reportLabels(image.labels,
                 before,
                 { amountsOf(result.values, one), "nodes", "node of the cube", "take --sampling N, or --fractions" },
                 log);
  }
  return result;
}

FieldVolume
labelsOfCube(const HexMesh &         mesh,
             const TransferImage &   image,
             const SubjectFunction & f,
             const TransferOptions & options,
             const TransferLog &     log)
{
  const int                 boxes = boxesOf(options, mesh);
  const std::vector<double> labels = labelsOfPlaces(image, options.background);
  if (options.fractions && labels.size() == 1)
  {
    throw BadInput(ErrorCode::EmptyLabel, options.input, "no label, so no fractions", "leave --fractions out");
  }
  const CubeMeans fractions =
    labelFractions(mesh, std::cref(f), labels, meanOptions(options, boxes, mesh, image.volume));
  f.requireCover(log);
  const LabelAmounts before = volumesOf(fractions, labels);
  FieldVolume        result = majority(fractions.image, labels);
  if (options.fractions)
  {
    reportLabels(image.labels, before, { before, "mm3 in the cube", "", "" }, log);
    return withoutZero(fractions.image);
  }
  reportLabels(image.labels,
               before,
               { amountsOf(result.values, fractions.volumes),
                 "mm3 in the cube",
                 "box of the cube",
                 "take --sampling N above " + std::to_string(boxes) + ", or --fractions" },
               log);
  return result;
}

FieldVolume
meansOfCube(const HexMesh &         mesh,
            const TransferImage &   image,
            const SubjectFunction & f,
            const TransferOptions & options,
            const TransferLog &     log)
{
  CubeMeans result =
    cubeMeans(mesh, std::cref(f), f.components(), meanOptions(options, boxesOf(options, mesh), mesh, image.volume));
  f.requireCover(log);
  if (f.components() == 1)
  {
    const double volume = std::accumulate(result.volumes.begin(), result.volumes.end(), 0.0);
    log.say("integral over the mesh: " + numberText(sumOf(massesOf(result.image, result.volumes), 0)) + ", volume " +
            numberText(volume) + " mm3");
  }
  return std::move(result.image);
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
    return nodesOfCube(mesh, image, f, options, log);
  }
  if (options.labels)
  {
    return labelsOfCube(mesh, image, f, options, log);
  }
  return options.conserve ? conservedMeans(mesh, image, f, options, log).image
                          : meansOfCube(mesh, image, f, options, log);
}

void
write(const std::string & fileName, const FieldVolume & image, FieldValues kind, const TransferLog & log)
{
  writeFieldImage(fileName, image, kind);
  log.say(fileName + ": " + std::to_string(image.size[0]) + " x " + std::to_string(image.size[1]) + " x " +
          std::to_string(image.size[2]) + ", " + std::to_string(image.components) +
          (image.components == 1 ? " number each" : " numbers each"));
}

void
toCube(const TransferOptions & options, const TransferLog & log)
{
  const TransferImage   image = readTransferImage(options, log);
  const HexMesh         mesh = readTransferMesh(options.mesh, options);
  const SubjectFunction f(image.volume, image.hasValue, options);
  write(options.toCube, imageOfCube(mesh, image, f, options, log), valuesOf(options, image), log);
}

/** Spreads masses over the grid, and tells what of each component lies beyond it. */
void
writeMasses(const HexMesh &         mesh,
            const FieldVolume &     masses,
            const VoxelGrid &       grid,
            FieldValues             kind,
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
  for (std::size_t c = 0; c < result.outside.size(); ++c)
  {
    if (result.outside[c] != 0.0)
    {
      char text[120];
      std::snprintf(text, sizeof text, "%.6g of the ", result.outside[c]);
      log.warn(text + integralName(c, masses.components) + ", " + numberText(sumOf(masses, c)) +
               ", lies beyond the grid");
    }
  }
  write(options.toImage, result.image, kind, log);
}

/** A function of the cube on the voxels of a grid. \throws BadInput (Geometry)  no voxel lies in the mesh */
FieldVolume
samplesOn(const VoxelGrid &       grid,
          const HexMesh &         mesh,
          const CubeFunction &    f,
          int                     components,
          double                  background,
          const TransferOptions & options,
          const TransferLog &     log)
{
  const CubeMap map(mesh);
  GridSamples   result = gridSamples(map, mesh, f, components, grid, { background, options.threads });
  if (result.inside == 0)
  {
    throw BadInput(ErrorCode::Geometry,
                   options.like.empty() ? options.mesh : options.like,
                   "no voxel centre lies in the mesh",
                   "give an image of the subject, or smaller voxels");
  }
  log.say(std::to_string(result.inside) + " voxels in the mesh");
  return std::move(result.image);
}

/** Labels on the voxels of a grid, reported. \param before  volumes in the organ that they come from */
FieldVolume
labelsOn(const VoxelGrid &       grid,
         const HexMesh &         mesh,
         const CubeFunction &    labelAt,
         const TransferImage &   image,
         const LabelAmounts &    before,
         const TransferOptions & options,
         const TransferLog &     log)
{
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN(); // beyond the mesh, where no label has a place
  FieldVolume      result = samplesOn(grid, mesh, labelAt, 1, nowhere, options, log);
  if (!before.empty())
  {
    const std::vector<double> volumes(result.values.size(), grid.voxelVolume());
    reportLabels(image.labels,
                 before,
                 { amountsOf(result.values, volumes), "mm3 in the image", "voxel", "take smaller voxels" },
                 log);
  }
  std::replace_if(
    result.values.begin(), result.values.end(), [](double label) { return std::isnan(label); }, options.background);
  return result;
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

/** \throws BadInput (Precondition)  --conserve of samples at nodes */
void
requireIntegrals(CubeSampling sampling, const TransferOptions & options)
{
  if (options.conserve && sampling == CubeSampling::Nodes)
  {
    throw BadInput(ErrorCode::Precondition,
                   options.input,
                   "samples at nodes have no integral",
                   "make it with --sampling cells, or leave --conserve out");
  }
}

void
cubeMassesToImage(const TransferImage &   cube,
                  const HexMesh &         mesh,
                  const VoxelGrid &       grid,
                  const TransferOptions & options,
                  const TransferLog &     log)
{
  const std::vector<double> volumes = cubeVolumes(mesh, { cube.volume.size[0], 2, options.threads });
  const FieldVolume         masses = massesOf(withBackground(cube, options.background), volumes);
  for (std::size_t c = 0; c < static_cast<std::size_t>(masses.components); ++c)
  {
    log.say(integralName(c, masses.components) + ": " + numberText(sumOf(masses, c)));
  }
  writeMasses(mesh, masses, grid, valuesOf(options, cube), options, log);
}

void
cubeToImage(const TransferOptions & options, const TransferLog & log)
{
  const TransferImage cube = readTransferImage(options, log);
  const CubeSampling  sampling = requireCube(cube.volume, options);
  requireIntegrals(sampling, options);
  const HexMesh   mesh = readTransferMesh(options.mesh, options);
  const VoxelGrid grid = readTargetGrid(options, mesh);
  if (options.conserve)
  {
    cubeMassesToImage(cube, mesh, grid, options, log);
    return;
  }
  const FieldFunction field(cube.volume, cube.hasValue, interpolationOf(options));
  const int           components = cube.volume.components;
  const CubeFunction  f = [&](const CubePoint & point, double * values) {
    if (!field.evaluate(point.cube, values)) // without data: the whole cube is in the image
    {
      std::fill_n(values, components, options.background);
    }
    else if (options.rotate)
    {
      turn(rotationPart(point.jacobian), components, values);
    }
  };
  if (!options.labels)
  {
    write(options.toImage,
          samplesOn(grid, mesh, f, components, options.background, options, log),
          valuesOf(options, cube),
          log);
    return;
  }
  const bool      byBoxes = sampling == CubeSampling::Cells && hasShares(cube);
  CubeMeanOptions rule;
  rule.samplesPerAxis = cube.volume.size[0]; // a box has one label
  rule.pointsPerAxis = 2;
  rule.threads = options.threads;
  const LabelAmounts before = byBoxes ? labelVolumes(mesh, f, cube, rule, options) : LabelAmounts();
  write(options.toImage, labelsOn(grid, mesh, f, cube, before, options, log), FieldValues::Labels, log);
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
    const CubeMeans means = conservedMeans(from, image, subject, options, log);
    writeMasses(to, massesOf(means.image, means.volumes), grid, valuesOf(options, image), options, log);
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
  FieldVolume result;
  if (options.labels && hasShares(image))
  {
    const SubjectFunction labelAt(image.volume, image.hasValue, options); // what subject counts is the output
    const LabelAmounts    before = labelVolumes(
      from, std::cref(labelAt), image, meanOptions(options, from.nodesPerSide - 1, from, image.volume), options);
    result = labelsOn(grid, to, f, image, before, options, log);
  }
  else
  {
    result = samplesOn(grid, to, f, subject.components(), options.background, options, log);
  }
  subject.requireCover(log);
  write(options.toImage, result, valuesOf(options, image), log);
}

} // namespace

void
transferImage(const TransferOptions & options, const TransferLog & log)
{
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
