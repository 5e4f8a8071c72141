#include "AtlasFiles.h"

#include "AtlasPage.h"
#include "AtlasTestFiles.h"
#include "MeanLabelmap.h"
#include "PageName.h"
#include "Version.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FieldImageWriter.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace moserhex::app
{
namespace
{
using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

std::string
inFolder(const AtlasOptions & options, const std::string & name)
{
  return options.outputFolder + "/" + name;
}

/** Node by node: root of the covariance's trace, and the covariance as a symmetric tensor. */
std::vector<NamedArray>
variationArrays(const std::vector<Matrix3> & covariances)
{
  NamedArray deviation{ "StandardDeviation", 1, {} };
  NamedArray tensor{ "Covariance", 6, {} };
  for (const Matrix3 & c : covariances)
  {
    deviation.values.push_back(std::sqrt(c.trace()));
    tensor.values.insert(tensor.values.end(), { c(0, 0), c(1, 1), c(2, 2), c(0, 1), c(1, 2), c(0, 2) });
  }
  return { deviation, tensor };
}

void
writeMean(const AtlasResult & result, const AtlasOptions & options)
{
  HexMeshFields fields;
  fields.pointArrays = variationArrays(result.covariances);
  writeHexMesh(inFolder(options, "mean.vtu"), result.mean.mesh, fields);
}

/** The mean image and its deviation in the cube. */
void
writeCubeImages(const MeanImage & images, const AtlasOptions & options)
{
  writeFieldImage(inFolder(options, "mean_image_cube.nrrd"), images.mean, images.kind);
  writeFieldImage(inFolder(options, "sd_image_cube.nrrd"), images.deviation);
}

/** The mean's labelmap and, on its voxels, the mean image; a warning where the mean has no such labelmap. */
void
writeTemplate(AtlasResult & result, const AtlasOptions & options)
{
  LabelVolume labels;
  try
  {
    labels = voxelised(result.mean.mesh, options.labelSpacing, options.threads);
  }
  catch (const InvalidInput & error)
  {
    result.warnings.push_back("template.nrrd is not written: " + std::string(error.what()) +
                              "; change --label-spacing");
    return;
  }
  writeLabelImage(inFolder(options, "template.nrrd"), labels);
  if (result.images)
  {
    const FieldVolume image = imageInMesh(result.images->mean, result.mean.mesh, labels, options.threads);
    writeFieldImage(inFolder(options, "mean_image.nrrd"), image, result.images->kind);
  }
}

void
writeQuality(const AtlasResult & result, const AtlasOptions & options)
{
  const ModelQuality & quality = result.quality;
  std::string          text = tableLine({ "modes",
                                          "compactness",
                                          "generalisation_mm",
                                          "generalisation_error_mm",
                                          "specificity_mm",
                                          "specificity_error_mm" },
                               ',');
  for (std::size_t m = 0; m < quality.compactness.size(); ++m)
  {
    text += tableLine({ std::to_string(m + 1),
                        numberText(quality.compactness[m]),
                        numberText(quality.generalisation[m]),
                        numberText(quality.generalisationError[m]),
                        numberText(quality.specificity[m]),
                        numberText(quality.specificityError[m]) },
                      ',');
  }
  writeTextFile(inFolder(options, "model_quality.csv"), text);
}

Json
meanJson(const EqualVolumeShape & mean)
{
  return { { "volume_ml", mean.volume / 1000.0 },
           { "exact", mean.exact },
           { "volume_variance_before", mean.varianceBefore },
           { "volume_variance", mean.varianceAfter },
           { "certified_cells", mean.certified.positive },
           { "cells", mean.mesh.cellCount() },
           { "reworked", mean.way != EqualVolumeWay::Projection },
           { "mean_move_mm", mean.meanMove },
           { "largest_move_mm", mean.largestMove },
           { "boundary_distance_mm", mean.boundaryDistance } };
}

Json
modelJson(const AtlasModel & model, const std::vector<ModeMeshFigures> & meshes)
{
  Json   json{ { "modes", model.shape.modes.cols() }, { "total_variance_mm2", model.shape.totalVariance } };
  double held = 0.0;
  json["variance_explained"] = Json::array();
  json["cumulative"] = Json::array();
  for (const double variance :
       std::vector<double>(model.shape.variances.data(), model.shape.variances.data() + model.shape.variances.size()))
  {
    held += variance;
    json["variance_explained"].push_back(variance / model.shape.totalVariance);
    json["cumulative"].push_back(held / model.shape.totalVariance);
  }
  json["meshes"] = Json::array();
  for (const ModeMeshFigures & mesh : meshes)
  {
    Json entry{ { "file", mesh.file },
                { "standard_deviations", mesh.deviations },
                { "exact", mesh.deviations != 0.0 } };
    if (mesh.deviations != 0.0)
    {
      entry["volume_ml"] = mesh.volume / 1000.0;
      entry["volume_variance"] = mesh.volumeVariance;
      entry["boundary_distance_mm"] = mesh.boundaryDistance;
    }
    entry["attempts"] = mesh.attempts;
    json["meshes"].push_back(entry);
  }
  return json;
}

Json
imagesJson(const MeanImage & images, const AtlasOptions & options)
{
  return { { "column", options.images },
           { "sampling", options.imageSampling },
           { "normalised", options.normaliseImages },
           { "subjects", images.subjects },
           { "left_out", images.leftOut } };
}

void
writeSummary(const AtlasResult & result, const AtlasOptions & options)
{
  Json json{ { "moserhex", version },
             { "coordinate_system", "LPS" },
             { "units", "mm" },
             { "subjects", result.subjects.subjects.size() },
             { "nodes_per_side", result.model.nodesPerSide },
             { "seed", options.seed },
             { "alignment",
               { { "kind", nameOf(options.alignment) },
                 { "steps", result.alignment.report.steps },
                 { "converged", result.alignment.report.converged },
                 { "deviation_mm", result.alignment.deviation },
                 { "mean_centroid_size_mm", result.alignment.size } } },
             { "mean", meanJson(result.mean) },
             { "model", modelJson(result.model, result.modeMeshes) } };
  if (result.images)
  {
    json["images"] = imagesJson(*result.images, options);
  }
  json["tests"] = Json::object();
  for (const AtlasTest & test : result.tests)
  {
    json["tests"][test.name] = testJson(test);
  }
  json["warnings"] = result.warnings;
  writeTextFile(inFolder(options, "atlas.json"), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace

void
writeScores(const std::string &                 fileName,
            const AtlasSubjects &               subjects,
            const std::vector<SubjectFigures> & figures,
            const std::string &                 distanceName,
            const std::vector<double> &         distances,
            const Eigen::MatrixXd &             scores)
{
  Cells header{ "subject", "mesh", "volume_ml", "centroid_size_mm", distanceName };
  for (Eigen::Index mode = 0; mode < scores.cols(); ++mode)
  {
    header.push_back(modeColumn(static_cast<std::size_t>(mode)));
  }
  std::string text = tableLine(header, ',');
  for (std::size_t i = 0; i < subjects.subjects.size(); ++i)
  {
    Cells cells{ subjects.subjects[i].name,
                 subjects.subjects[i].mesh,
                 numberText(figures[i].volume / 1000.0),
                 numberText(figures[i].centroidSize),
                 numberText(distances[i]) };
    for (Eigen::Index mode = 0; mode < scores.cols(); ++mode)
    {
      cells.push_back(numberText(scores(static_cast<Eigen::Index>(i), mode)));
    }
    text += tableLine(cells, ',');
  }
  writeTextFile(fileName, text);
}

void
writeAtlas(AtlasResult & result, const AtlasOptions & options)
{
  writeMean(result, options);
  if (result.images)
  {
    writeCubeImages(*result.images, options);
  }
  writeScores(inFolder(options, "scores.csv"),
              result.subjects,
              result.figures,
              "distance_to_mean_mm",
              result.distances,
              result.scores);
  writeAtlasModel(inFolder(options, "model.json"), result.model);
  writeQuality(result, options);
  for (const AtlasTest & test : result.tests)
  {
    writeAtlasTest(options.outputFolder, test, result.mean.mesh);
  }
  if (options.labelSpacing > 0.0 && result.model.paddingLayers > 0)
  {
    result.warnings.emplace_back(
      "template.nrrd: not written, as the lattice of a mesh with padding ends inside the organ");
  }
  else if (options.labelSpacing > 0.0)
  {
    writeTemplate(result, options);
  }
  writeSummary(result, options);
  if (pagesAreBuilt())
  {
    writeAtlasPage(inFolder(options, "atlas.html"), result, options);
  }
}

} // namespace moserhex::app
