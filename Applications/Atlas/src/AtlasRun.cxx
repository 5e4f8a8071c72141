#include "AtlasRun.h"

#include "EarlierAtlas.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <cmath>

namespace moserhex::app
{
namespace
{

void
requireEnough(const AtlasSubjects & subjects)
{
  if (subjects.subjects.size() < 2)
  {
    throw BadInput(
      ErrorCode::Precondition, subjects.subjects.front().mesh, "one subject, need at least 2", "give more meshes");
  }
}

/** Finds inputs that the output would replace. */
void
requireInputsStay(const AtlasSubjects & subjects, const AtlasOptions & options)
{
  std::vector<std::string> files = options.inputs;
  for (const AtlasSubject & subject : subjects.subjects)
  {
    files.push_back(subject.mesh);
  }
  if (!options.images.empty())
  {
    for (const std::optional<std::string> & image : filesOfColumn(subjects, options.images))
    {
      if (image)
      {
        files.push_back(*image);
      }
    }
  }
  requireNotOverwritten(files, options.outputFolder);
}

/** A mesh of fewer nodes cannot be made exact. */
void
requireInnerNodes(const AtlasSubjects & subjects, const SubjectMeshes & meshes)
{
  if (meshes.nodesPerSide < 3)
  {
    throw BadInput(ErrorCode::Precondition,
                   subjects.subjects.front().mesh,
                   std::to_string(meshes.nodesPerSide) + " nodes a side, need at least 3",
                   "mesh with more shells");
  }
}

ProcrustesResult
align(const SubjectFile & nodes, const AtlasOptions & options)
{
  ProcrustesOptions procrustes;
  procrustes.kind = options.alignment;
  procrustes.threads = options.threads;
  return generalisedProcrustes(
    nodes.subjects(), [&](std::size_t subject) { return pointsOf(nodes.readSubject(subject)); }, procrustes);
}

/** Puts the aligned subjects in the place of those that were read. \return distances to the mean */
std::vector<double>
replaceByAligned(SubjectFile & nodes, const ProcrustesResult & alignment, unsigned int threads)
{
  const Eigen::VectorXd mean = coordinatesOf(alignment.mean);
  std::vector<double>   distances(nodes.subjects());
  parallelFor(nodes.subjects(), threads, [&](std::size_t subject) {
    const Positions       points = pointsOf(nodes.readSubject(subject));
    const Eigen::VectorXd aligned = coordinatesOf(transformed(points, alignment.transforms[subject]));
    distances[subject] = (aligned - mean).norm() / std::sqrt(static_cast<double>(points.size()));
    nodes.writeSubject(subject, aligned);
  });
  return distances;
}

/** The model, the scores in standard deviations, and how good the model is. */
void
fitModel(AtlasResult & result, const SubjectFile & aligned, const AtlasOptions & options)
{
  ShapeModelOptions model;
  model.maximumModes = options.maximumModes;
  model.varianceFraction = options.maximumModes > 0 ? 1.0 : options.varianceFraction;
  model.threads = options.threads;
  ShapeModelResult fit;
  try
  {
    fit = fitShapeModel(aligned, model);
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), result.subjects.subjects.front().mesh, error.what(), "give meshes that differ");
  }
  const Eigen::Index kept = fit.model.modes.cols();
  result.scores = fit.scores.leftCols(kept) * fit.model.variances.cwiseSqrt().cwiseInverse().asDiagonal();
  result.model.shape = std::move(fit.model);
  if (aligned.subjects() >= 3)
  {
    ModelQualityOptions quality;
    quality.maximumModes = static_cast<std::size_t>(kept);
    quality.samples = options.samples;
    quality.seed = options.seed;
    quality.threads = options.threads;
    result.quality = modelQuality(fit.scores, aligned.columns() / 3, quality);
  }
}

/** \throws BadInput  the mean is no solid, so that there is no mesh of it */
EqualVolumeShape
meanMesh(const HexMesh & mean, const AtlasSubjects & subjects, unsigned int threads)
{
  try
  {
    return equalVolumeShape(mean, { EqualVolumeWay::Free, threads });
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(),
                   subjects.subjects.front().mesh,
                   std::string("the subjects' mean is no solid (") + error.what() + ")",
                   "do they lie alike? use --align rigid");
  }
}

/** The tests, of the images' means over the cells; a warning where they cannot be made. */
void
testImages(AtlasResult & result, const AtlasOptions & options)
{
  if (!result.images || result.tests.empty())
  {
    return;
  }
  const MeanImage & images = *result.images;
  if (!images.values)
  {
    result.warnings.push_back("images: not tested; that needs --image-sampling cells, and 1 to 3 numbers a voxel");
    return;
  }
  try
  {
    const TestedPlaces places{ true, static_cast<std::size_t>(images.mean.components), images.isKnown };
    for (const PlannedTest & test : planAtlasTests(result.subjects, options, places))
    {
      result.tests.push_back(runAtlasTest(test, *images.values, options));
    }
  }
  catch (const BadInput & error)
  {
    result.warnings.push_back(std::string("images: not tested; ") + error.what());
  }
}

/** Of tests that leave subjects or covariates out, of an alignment that did not end, of a mean that is not exact. */
void
addWarnings(AtlasResult & result)
{
  if (!result.alignment.report.converged)
  {
    result.warnings.push_back("alignment: " + result.alignment.report.note);
  }
  for (const AtlasTest & test : result.tests)
  {
    const std::size_t left = result.subjects.subjects.size() - test.subjects.size();
    if (left > 0)
    {
      result.warnings.push_back(test.name + ": " + std::to_string(left) + " subjects without a value are left out");
    }
    for (const std::string & covariate : test.covariatesLeftOut)
    {
      result.warnings.push_back(test.name + ": the covariate " + covariate +
                                " is left out: it is constant, or follows from those before it");
    }
  }
  for (const std::string & shortcoming : result.mean.shortcomings)
  {
    result.warnings.push_back("mean mesh: " + shortcoming);
  }
}

} // namespace

AtlasResult
analyse(const AtlasOptions & options, const std::function<void(double)> & progress)
{
  AtlasResult result;
  result.subjects = listAtlasSubjects(options.inputs, options.outputFolder);
  requireEnough(result.subjects);
  const std::vector<PlannedTest> tests = planAtlasTests(result.subjects, options);
  if (!options.images.empty())
  {
    requireImages(result.subjects, options);
  }
  requireInputsStay(result.subjects, options);
  SubjectMeshes meshes =
    readSubjectMeshes(result.subjects, options, [&](double fraction) { progress(0.3 * fraction); });
  requireInnerNodes(result.subjects, meshes);
  result.figures = meshes.figures;
  result.warnings = result.subjects.warnings;
  result.warnings.insert(result.warnings.end(), meshes.warnings.begin(), meshes.warnings.end());

  if (!options.images.empty())
  {
    result.images =
      meanImage(result.subjects, meshes, options, [&](double fraction) { progress(0.3 + 0.2 * fraction); });
    result.warnings.insert(result.warnings.end(), result.images->warnings.begin(), result.images->warnings.end());
  }
  result.alignment = align(*meshes.nodes, options);
  result.distances = replaceByAligned(*meshes.nodes, result.alignment, options.threads);
  progress(0.55);
  fitModel(result, *meshes.nodes, options);
  result.model.nodesPerSide = meshes.nodesPerSide;
  result.model.paddingLayers = meshes.paddingLayers;
  result.model.alignment = options.alignment;
  result.model.size = result.alignment.size;
  result.model.subjects = meshes.nodes->subjects();
  result.covariances = pointCovariances(*meshes.nodes, options.threads);
  progress(0.6);
  result.mean = meanMesh(meshOf(result.model, result.model.shape.mean), result.subjects, options.threads);
  progress(0.7);
  for (const PlannedTest & test : tests)
  {
    result.tests.push_back(runAtlasTest(test, *meshes.nodes, options));
  }
  testImages(result, options);
  progress(1.0);
  addWarnings(result);
  return result;
}

std::string
modeColumn(std::size_t mode)
{
  return "mode_" + std::to_string(mode + 1);
}

} // namespace moserhex::app
