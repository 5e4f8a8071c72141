#include "MeanImage.h"

#include "CommandErrors.h"
#include "RunningMoments.h"
#include "SubjectFunction.h"
#include "moserhex/CubeTransfer/GridSamples.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>

namespace moserhex::app
{
namespace
{

/** A variance below this part of the mean square is none. */
constexpr double roundOff = 1e-14;

TransferOptions
transferOptions(const std::string & image, const AtlasOptions & options)
{
  TransferOptions transfer;
  transfer.input = image;
  transfer.sampling = options.imageSampling;
  transfer.sandbox = options.sandbox;
  transfer.threads = options.threads;
  return transfer;
}

/** Mean and standard deviation of every component over the organ. */
struct OrganMoments
{
  std::vector<double> mean;
  std::vector<double> deviation; ///< 0 where it is constant
};

OrganMoments
momentsInOrgan(const HexMesh & mesh, const SubjectFunction & f, const CubeMeanOptions & options)
{
  const int  components = f.components();
  const auto withSquares = [&f, components](const CubePoint & point, double * values) {
    f(point, values);
    std::transform(values, values + components, values + components, [](double value) { return value * value; });
  };
  const CubeMeans     means = cubeMeans(mesh, withSquares, 2 * components, options);
  const double        volume = std::accumulate(means.volumes.begin(), means.volumes.end(), 0.0);
  std::vector<double> sums(2 * static_cast<std::size_t>(components), 0.0);
  for (std::size_t box = 0; box < means.volumes.size(); ++box)
  {
    const double weight = means.volumes[box] / volume;
    std::transform(sums.begin(), sums.end(), means.image.at(box), sums.begin(), [weight](double sum, double value) {
      return sum + weight * value;
    });
  }
  OrganMoments moments;
  for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
  {
    const double square = sums[c + static_cast<std::size_t>(components)];
    const double variance = square - sums[c] * sums[c];
    moments.mean.push_back(sums[c]);
    moments.deviation.push_back(variance > roundOff * square ? std::sqrt(variance) : 0.0);
  }
  return moments;
}

/** One subject's image in the cube, or why it is left out. */
struct CarriedImage
{
  FieldVolume image;
  FieldValues kind{ FieldValues::Numbers };
  std::string flaw; ///< empty: none
};

CarriedImage
carried(const FieldImage & image, const HexMesh & mesh, const AtlasOptions & options, const TransferOptions & transfer)
{
  const FieldVolume &   volume = image.volume;
  const SubjectFunction f(volume, image.hasValue, transfer);
  const int             cells = mesh.nodesPerSide - 1;
  const bool            atNodes = options.imageSampling == "nodes";
  CarriedImage          result;
  result.kind = image.kind;
  result.image =
    atNodes
      ? cubeNodeSamples(mesh, std::cref(f), f.components(), options.threads)
      : cubeMeans(mesh,
                  std::cref(f),
                  f.components(),
                  meanOptions(transfer, boxesPerAxis("--image-sampling", options.imageSampling, cells), mesh, volume))
          .image;
  OrganMoments moments;
  if (options.normaliseImages)
  {
    moments = momentsInOrgan(mesh, f, meanOptions(transfer, cells, mesh, volume));
  }
  if (f.partBeyond() > 0.0)
  {
    char text[120];
    std::snprintf(
      text, sizeof text, "%.3g %% of the mesh lies beyond the image or on voxels without data", 100.0 * f.partBeyond());
    result.flaw = text;
    return result;
  }
  if (!std::all_of(result.image.values.begin(), result.image.values.end(), [](double v) { return std::isfinite(v); }))
  {
    result.flaw = "the image is not a number somewhere in the organ";
    return result;
  }
  for (std::size_t c = 0; c < moments.mean.size(); ++c)
  {
    if (moments.deviation[c] == 0.0)
    {
      result.flaw = "the image is constant in the organ and cannot be normalised";
      return result;
    }
    for (std::size_t i = c; i < result.image.values.size(); i += moments.mean.size())
    {
      result.image.values[i] = (result.image.values[i] - moments.mean[c]) / moments.deviation[c];
    }
  }
  return result;
}

void
requireSameComponents(const std::string & file, const FieldVolume & image, int components)
{
  if (image.components != components)
  {
    throw BadInput(ErrorCode::PixelType,
                   file,
                   std::to_string(image.components) + " numbers per voxel, the first image has " +
                     std::to_string(components),
                   "give images of one kind");
  }
}

/** The subject's image in the cube; what reading it warned of goes to `warnings`. */
CarriedImage
readAndCarry(const std::string &        file,
             const AtlasSubject &       subject,
             const HexMesh &            mesh,
             const AtlasOptions &       options,
             std::vector<std::string> & warnings)
{
  const FieldImage image = readFieldImage(file, { options.sandbox });
  warnings.insert(warnings.end(), image.warnings.begin(), image.warnings.end());
  try
  {
    return carried(image, mesh, options, transferOptions(file, options));
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), subject.mesh, error.what(), "give a mesh that moserhex quality certifies");
  }
}

Eigen::VectorXd
vectorOf(const std::vector<double> & values)
{
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/** A row for each subject's image, where tests are asked for and can be made. */
std::unique_ptr<SubjectFile>
fileForTests(const FieldVolume & image, std::size_t subjects, const AtlasOptions & options)
{
  const bool isTested = !options.group.empty() || !options.regressor.empty();
  if (!isTested || options.imageSampling != "cells" || image.components > 3)
  {
    return nullptr;
  }
  return std::make_unique<SubjectFile>(options.outputFolder, subjects, image.values.size());
}

/** Rows of subjects without an image, so that the file can be read to its end. */
void
fillUnknown(const MeanImage & images)
{
  for (std::size_t subject = 0; images.values && subject < images.isKnown.size(); ++subject)
  {
    if (!images.isKnown[subject])
    {
      images.values->writeSubject(subject, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(images.values->columns())));
    }
  }
}

} // namespace

void
requireImages(const AtlasSubjects & subjects, const AtlasOptions & options)
{
  if (options.imageSampling != "nodes")
  {
    (void)boxesPerAxis("--image-sampling", options.imageSampling, 1);
  }
  for (const std::optional<std::string> & file : filesOfColumn(subjects, options.images))
  {
    std::error_code ignored;
    if (file && !std::filesystem::exists(*file, ignored))
    {
      throw BadInput(ErrorCode::NoInput, *file, "no such image", "correct the table, or leave its cell empty");
    }
  }
}

MeanImage
meanImage(const AtlasSubjects &               subjects,
          const SubjectMeshes &               meshes,
          const AtlasOptions &                options,
          const std::function<void(double)> & done)
{
  if (meshes.paddingLayers > 0)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   subjects.subjects.front().mesh,
                   "a mesh with padding, whose lattice ends inside the organ",
                   "give meshes made without --padding, or leave --images out");
  }
  const auto     files = filesOfColumn(subjects, options.images);
  MeanImage      result;
  RunningMoments moments;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const AtlasSubject & subject = subjects.subjects[i];
    CarriedImage         image;
    image.flaw = "no image in the table";
    if (files[i])
    {
      const HexMesh mesh{ meshes.nodesPerSide, pointsOf(meshes.nodes->readSubject(i)) };
      image = readAndCarry(*files[i], subject, mesh, options, result.warnings);
    }
    result.isKnown.push_back(image.flaw.empty());
    if (image.flaw.empty())
    {
      if (moments.count() == 0)
      {
        result.mean = image.image;
        result.values = fileForTests(result.mean, files.size(), options);
        result.kind = image.kind;
      }
      requireSameComponents(*files[i], image.image, result.mean.components);
      moments.add(image.image.values);
      if (result.values)
      {
        result.values->writeSubject(i, vectorOf(image.image.values));
      }
    }
    else
    {
      result.leftOut.push_back(subject.name);
      result.warnings.push_back("images: " + subject.name + " is left out: " + image.flaw);
    }
    done(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  if (moments.count() < 2)
  {
    throw BadInput(ErrorCode::Precondition,
                   options.images,
                   std::to_string(moments.count()) + " subjects with an image of the whole organ, need at least 2" +
                     (result.warnings.empty() ? "" : " (" + result.warnings.back() + ")"),
                   "give the images of the meshes' own scans, in LPS millimetres");
  }
  fillUnknown(result);
  result.subjects = moments.count();
  result.deviation = result.mean;
  result.mean.values = moments.mean();
  result.deviation.values = moments.standardDeviation();
  return result;
}

FieldVolume
imageInMesh(const FieldVolume & cube, const HexMesh & mesh, const VoxelGrid & grid, unsigned int threads)
{
  const FieldFunction field(cube, ImageInterpolation::Linear);
  const CubeMap       map(mesh);
  const CubeFunction  f = [&field](const CubePoint & point, double * values) {
    (void)field.evaluate(point.cube, values); // the whole cube is in it
  };
  return gridSamples(map, mesh, f, cube.components, grid, { 0.0, threads }).image;
}

} // namespace moserhex::app
