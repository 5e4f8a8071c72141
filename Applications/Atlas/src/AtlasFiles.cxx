#include "AtlasFiles.h"

#include "AtlasPage.h"
#include "MeanLabelmap.h"
#include "NumberText.h"
#include "PageName.h"
#include "Version.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace moserhex::app
{
namespace
{
using Json = nlohmann::ordered_json;
using Cells = std::vector<std::string>;

constexpr double modeDeviations = 3.0;
constexpr double level = 0.05; ///< at which the summary counts nodes

std::string
inFolder(const AtlasOptions & options, const std::string & name)
{
  return options.outputFolder + "/" + name;
}

NamedArray
scalarsOf(const std::string & name, const Eigen::VectorXd & values)
{
  return { name, 1, std::vector<double>(values.data(), values.data() + values.size()) };
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

/** The mean changed along the first modes; their figures for the summary. */
std::vector<ModeMesh>
writeModes(const AtlasResult & result, const AtlasOptions & options)
{
  std::vector<ModeMesh> meshes;
  const std::size_t     modes = std::min(options.modeMeshes, static_cast<std::size_t>(result.model.shape.modes.cols()));
  for (std::size_t mode = 0; mode < modes; ++mode)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      std::array<char, 64> name{};
      std::snprintf(name.data(), name.size(), "mode-%02zu-%s3.vtu", mode + 1, sign > 0.0 ? "plus" : "minus");
      const HexMesh mesh = meshOf(result.model, shapeAlongMode(result.model.shape, mode, sign * modeDeviations));
      HexMeshFields fields;
      const HexMesh mean = meshOf(result.model, result.model.shape.mean);
      NamedArray    move{ "Displacement", 3, {} };
      for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
      {
        const Vector3 d = mesh.nodes[node] - mean.nodes[node];
        move.values.insert(move.values.end(), d.data(), d.data() + 3);
      }
      fields.pointArrays = { move };
      writeHexMesh(inFolder(options, name.data()), mesh, fields);
      const auto volumes = cellVolumes(mesh);
      meshes.push_back({ name.data(),
                         std::accumulate(volumes.begin(), volumes.end(), 0.0),
                         mesh.cellCount() - certifyCells(mesh, {}, options.threads).positive });
    }
  }
  return meshes;
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

/** Cohen's D where there are groups, else the partial correlation. */
const Eigen::VectorXd &
effectSizes(const AtlasTest & test)
{
  return test.groups.empty() ? test.result.partialCorrelation : test.result.standardisedDifference;
}

void
writeTestMesh(const AtlasTest & test, const HexMesh & mean, const AtlasOptions & options)
{
  const Eigen::MatrixXd & slope = test.result.slope;
  HexMeshFields           fields;
  fields.pointArrays = {
    { test.groups.empty() ? "Slope" : "Difference", 3, std::vector<double>(slope.data(), slope.data() + slope.size()) },
    scalarsOf("T2", test.result.statistic),
    scalarsOf("P", test.result.p),
    scalarsOf("PFamilyWise", test.result.pFamilyWise),
    scalarsOf("QFalseDiscovery", test.result.qFalseDiscovery),
    scalarsOf("PartialCorrelation", test.result.partialCorrelation)
  };
  if (!test.groups.empty())
  {
    fields.pointArrays.push_back(scalarsOf("EffectSize", test.result.standardisedDifference));
  }
  writeHexMesh(inFolder(options, test.name + ".vtu"), mean, fields);
}

void
writeTestTable(const AtlasTest & test, const HexMesh & mean, const AtlasOptions & options)
{
  const std::string change = test.groups.empty() ? "slope" : "difference";
  std::string       text = tableLine({ "node",
                                       "i",
                                       "j",
                                       "k",
                                       "x",
                                       "y",
                                       "z",
                                       change + "_x",
                                       change + "_y",
                                       change + "_z",
                                       "t2",
                                       "p",
                                       "p_family_wise",
                                       "q_false_discovery",
                                 test.groups.empty() ? "partial_correlation" : "effect_size" },
                               ',');
  const auto        indices = nodeIndices(mean);
  for (std::size_t node = 0; node < mean.nodes.size(); ++node)
  {
    const auto place = static_cast<Eigen::Index>(node);
    Cells      cells{ std::to_string(node) };
    for (const int index : indices[node].lattice)
    {
      cells.push_back(std::to_string(index));
    }
    for (const Vector3 & vector : { mean.nodes[node], Vector3(test.result.slope.col(place)) })
    {
      for (const double value : { vector[0], vector[1], vector[2] })
      {
        cells.push_back(numberText(value));
      }
    }
    for (const double value : { test.result.statistic[place],
                                test.result.p[place],
                                test.result.pFamilyWise[place],
                                test.result.qFalseDiscovery[place],
                                effectSizes(test)[place] })
    {
      cells.push_back(numberText(value));
    }
    text += tableLine(cells, ',');
  }
  writeTextFile(inFolder(options, test.name + ".csv"), text);
}

Json
testJson(const AtlasTest & test)
{
  Json json{ { "column", test.column },
             { "covariates", test.covariates },
             { "subjects", test.subjects.size() },
             { "permutations", test.result.permutations },
             { "exact", test.result.isExact },
             { "degrees_of_freedom", test.result.degreesOfFreedom },
             { "smallest_p", test.result.p.minCoeff() },
             { "smallest_p_family_wise", test.result.pFamilyWise.minCoeff() },
             { "nodes_p_family_wise_005", (test.result.pFamilyWise.array() <= level).count() },
             { "nodes_q_false_discovery_005", (test.result.qFalseDiscovery.array() <= level).count() },
             { "largest_effect_size", effectSizes(test).maxCoeff() } };
  if (!test.groups.empty())
  {
    json["groups"] = test.groups;
    json["group_sizes"] = test.groupSizes;
  }
  return json;
}

Json
meanJson(const MeanMeshResult & mean)
{
  return { { "volume_ml", mean.volume / 1000.0 },
           { "exact", mean.exact },
           { "volume_variance_before", mean.varianceBefore },
           { "volume_variance", mean.varianceAfter },
           { "certified_cells", mean.certified.positive },
           { "cells", mean.mesh.cellCount() },
           { "reworked", mean.reworked },
           { "mean_move_mm", mean.meanMove },
           { "largest_move_mm", mean.largestMove } };
}

Json
modelJson(const AtlasModel & model, const std::vector<ModeMesh> & meshes)
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
  for (const ModeMesh & mesh : meshes)
  {
    json["meshes"].push_back(
      { { "file", mesh.file }, { "volume_ml", mesh.volume / 1000.0 }, { "uncertified_cells", mesh.uncertified } });
  }
  return json;
}

void
writeSummary(const AtlasResult & result, const AtlasOptions & options, const std::vector<ModeMesh> & meshes)
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
             { "model", modelJson(result.model, meshes) } };
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
writeAtlas(const AtlasResult & result, const AtlasOptions & options)
{
  writeMean(result, options);
  const std::vector<ModeMesh> modes = writeModes(result, options);
  if (options.labelSpacing > 0.0 && result.model.paddingLayers == 0)
  {
    writeLabelImage(inFolder(options, "template.nrrd"),
                    voxelised(result.mean.mesh, options.labelSpacing, options.threads));
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
    writeTestMesh(test, result.mean.mesh, options);
    writeTestTable(test, result.mean.mesh, options);
  }
  writeSummary(result, options, modes);
  if (pagesAreBuilt())
  {
    writeAtlasPage(inFolder(options, "atlas.html"), result);
  }
}

} // namespace moserhex::app
