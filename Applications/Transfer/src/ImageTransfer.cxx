#include "ImageTransfer.h"

#include "CommandErrors.h"
#include "GridTarget.h"
#include "Integrals.h"
#include "SubjectSampler.h"
#include "moserhex/CubeTransfer/CubeAxes.h"
#include "moserhex/CubeTransfer/CubeImage.h"
#include "moserhex/CubeTransfer/FieldFunction.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace moserhex::app
{
namespace
{

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

/** \param axes  of its vectors and tensors */
void
write(const std::string & fileName,
      const FieldVolume & image,
      FieldValues         kind,
      ValueAxes           axes,
      const TransferLog & log)
{
  writeFieldImage(fileName, image, kind, axes);
  log.say(fileName + ": " + std::to_string(image.size[0]) + " x " + std::to_string(image.size[1]) + " x " +
          std::to_string(image.size[2]) + ", " + std::to_string(image.components) +
          (image.components == 1 ? " number each" : " numbers each"));
}

void
toCube(const TransferOptions & options, const TransferLog & log)
{
  TransferImage image = readTransferImage(options, log);
  const HexMesh mesh = readTransferMesh(options.mesh, options);
  if (!options.fractions) // whose numbers are of the same labels for every mesh
  {
    keepLabelsAround(mesh, image);
  }
  const FieldVolume cube = SubjectSampler(image, mesh, options, log).cube();
  write(options.toCube, cube, valuesOf(options, image), options.rotate ? ValueAxes::Cube : image.axes, log);
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

FieldVolume
massesOfCube(const TransferImage & cube, const HexMesh & mesh, const TransferOptions & options, const TransferLog & log)
{
  const std::vector<double> volumes = cubeVolumes(mesh, { cube.volume.size[0], 2, options.threads });
  FieldVolume               masses = massesOf(withBackground(cube, options.background), volumes);
  for (std::size_t c = 0; c < static_cast<std::size_t>(masses.components); ++c)
  {
    log.say(integralName(c, masses.components) + ": " + nineDigits(sumOf(masses, c)));
  }
  return masses;
}

/** The volume of each label of a cube's boxes in the organ; none where the image has none. */
LabelAmounts
labelVolumesOfBoxes(const TransferImage &   cube,
                    const CubeFunction &    labelAt,
                    const HexMesh &         mesh,
                    const TransferOptions & options)
{
  if (!hasShares(cube))
  {
    return {};
  }
  const CubeMeanOptions     rule{ cube.volume.size[0], 2, options.threads }; // a box has one label
  const std::vector<double> labels = labelsOfPlaces(cube, options.background);
  return volumesOf(labelFractions(mesh, labelAt, labels, rule), labels);
}

void
cubeToImage(const TransferOptions & options, const TransferLog & log)
{
  const TransferImage cube = readTransferImage(options, log);
  const CubeSampling  sampling = requireCube(cube.volume, options);
  requireIntegrals(sampling, options);
  const HexMesh     mesh = readTransferMesh(options.mesh, options);
  const VoxelGrid   grid = readTargetGrid(options, mesh, cube.volume.components, log);
  const GridTarget  target(mesh, grid, options, log);
  const FieldValues kind = valuesOf(options, cube);
  const ValueAxes   axes = options.rotate ? ValueAxes::Lps : cube.axes;
  if (options.conserve)
  {
    write(options.toImage, target.densities(massesOfCube(cube, mesh, options, log)), kind, axes, log);
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
    write(options.toImage, target.samples(f, components, options.background), kind, axes, log);
    return;
  }
  const LabelAmounts before =
    sampling == CubeSampling::Cells ? labelVolumesOfBoxes(cube, f, mesh, options) : LabelAmounts();
  write(options.toImage, target.labels(f, cube.labels, before), FieldValues::Labels, axes, log);
}

void
subjectToSubject(const TransferOptions & options, const TransferLog & log)
{
  TransferImage   image = readTransferImage(options, log);
  const HexMesh   from = readTransferMesh(options.mesh, options);
  const HexMesh   to = readTransferMesh(options.toMesh, options);
  const VoxelGrid grid = readTargetGrid(options, to, image.volume.components, log);
  keepLabelsAround(from, image);
  const GridTarget     target(to, grid, options, log);
  const SubjectSampler sampler(image, from, options, log);
  const FieldValues    kind = valuesOf(options, image);
  if (options.conserve)
  {
    const CubeMeans means = sampler.conservedMeans();
    write(options.toImage, target.densities(massesOf(means.image, means.volumes)), kind, image.axes, log);
    return;
  }
  const CubeMap         map(from);
  const SubjectFunction subject(image.volume, image.hasValue, options);
  const CubeFunction    f = [&](const CubePoint & point, double * values) {
    if (subject.evaluate(cubePoint(from, map.place(point.cube)), values) && options.rotate)
    {
      turn(rotationPart(point.jacobian), subject.components(), values);
    }
  };
  const FieldVolume result = options.labels ? target.labels(f, image.labels, sampler.labelVolumes())
                                            : target.samples(f, subject.components(), options.background);
  subject.requireCover(log);
  write(options.toImage, result, kind, image.axes, log);
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
