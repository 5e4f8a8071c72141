#include "moserhex/HexMeshIO/RunReport.h"

#include "TopologyJson.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <itkVersion.h>
#include <vtkVersion.h>

#include <nlohmann/json.hpp>

namespace moserhex
{
namespace
{

using Json = nlohmann::ordered_json;

Json
stageJson(const StageRecord & stage)
{
  Json json{ { "name", stage.name }, { "seconds", stage.seconds } };
  if (stage.quality)
  {
    json["volume_variance"] = stage.quality->volumeVariance;
    json["concave_percent"] = stage.quality->concavePercent;
    json["sj_min"] = stage.quality->scaledJacobianMinimum;
    json["sj_median"] = stage.quality->scaledJacobianMedian;
    json["sj_mean"] = stage.quality->scaledJacobianMean;
  }
  if (!stage.note.empty())
  {
    json["note"] = stage.note;
  }
  return json;
}

Json
inputJson(const RunReport::Input & input)
{
  Json json{ { "file", input.file } };
  if (!input.sha256.empty())
  {
    json["sha256"] = input.sha256;
  }
  if (input.labels.empty())
  {
    return json;
  }
  json["label"] = input.labels.size() == 1 ? Json(input.labels.front()) : Json();
  json["labels"] = input.labels;
  if (!input.labelName.empty())
  {
    json["label_name"] = input.labelName;
  }
  json["spacing"] = { input.spacing.x(), input.spacing.y(), input.spacing.z() };
  json["voxels"] = input.voxels;
  json["volume_mm3"] = input.volume;
  return json;
}

Json
parametersJson(const RunReport::Parameters & parameters)
{
  Json json{ { "shells", parameters.shells },     { "padding", parameters.padding },
             { "stage", parameters.stage },       { "shell_method", parameters.shellMethod },
             { "way", parameters.way },           { "frame", parameters.frame },
             { "density", parameters.density },   { "local_growth", parameters.localGrowth },
             { "topology", parameters.topology }, { "max_repair_percent", parameters.maximumRepair } };
  json["threshold"] = parameters.threshold ? Json(*parameters.threshold) : Json();
  json["segment"] = parameters.segment ? Json(*parameters.segment) : Json();
  return json;
}

Json
conditioningJson(const RunReport::Conditioning & conditioning)
{
  return { { "components", conditioning.components },
           { "cavities", conditioning.cavities },
           { "handles", conditioning.handles },
           { "changes", changesJson(conditioning.changes, conditioning.voxelVolume) },
           { "voxels_added", conditioning.voxelsAdded },
           { "voxels_removed", conditioning.voxelsRemoved },
           { "added_mm3", static_cast<double>(conditioning.voxelsAdded) * conditioning.voxelVolume },
           { "removed_mm3", static_cast<double>(conditioning.voxelsRemoved) * conditioning.voxelVolume },
           { "changed_percent", conditioning.changedPercent },
           { "sigma_mm", conditioning.sigma },
           { "dice", conditioning.dice } };
}

Json
densityJson(const RunReport::Density & density)
{
  Json json{ { "file", density.file }, { "sha256", density.sha256 } };
  if (density.mean > 0.0)
  {
    json["mean"] = density.mean;
    json["mass"] = density.mass;
    json["mass_per_cell"] = density.massPerCell;
  }
  return json;
}

void
addResidual(const std::string & name, const std::optional<RunReport::Residual> & residual, Json & json)
{
  if (residual)
  {
    json[name + "_before"] = residual->before;
    json[name + "_after"] = residual->after;
  }
}

/** Rows of the matrix that takes (x, y, z, 1). */
Json
matrixJson(const AffineTransform & motion)
{
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
  {
    rows.push_back({ motion.matrix(row, 0), motion.matrix(row, 1), motion.matrix(row, 2), motion.translation[row] });
  }
  rows.push_back({ 0.0, 0.0, 0.0, 1.0 });
  return rows;
}

Json
templateJson(const RunReport::Template & tied)
{
  Json json{ { "alignment", tied.alignment } };
  if (!tied.start.empty())
  {
    json["start"] = tied.start;
  }
  for (const RunReport::File & file : tied.files)
  {
    if (file.role == "mesh")
    {
      json["file"] = file.name;
      json["sha256"] = file.sha256;
      continue;
    }
    json[file.role] = { { "file", file.name }, { "sha256", file.sha256 } };
  }
  if (tied.aligned)
  {
    json["turned_degrees"] = tied.aligned->angle;
    json["moved_mm"] = tied.aligned->translation;
    json["template_to_label"] = matrixJson(tied.aligned->motion);
    json["surface_rms_before_mm"] = tied.aligned->rmsBefore;
  }
  if (tied.placed)
  {
    json["scale"] = tied.placed->scale;
    json["surface_rms_after_mm"] = tied.placed->rms;
    json["surface_median_after_mm"] = tied.placed->median;
  }
  addResidual("landmark_rms_mm", tied.landmarks, json);
  addResidual("image_difference", tied.imageDifference, json);
  if (tied.growth)
  {
    json["local_growth"] = { { "smallest", tied.growth->smallest },
                             { "largest", tied.growth->largest },
                             { "limited_cells", tied.growth->limited } };
  }
  return json;
}

Json
meshJson(const RunReport & report)
{
  Json json{ { "file", report.mesh.file } };
  if (!report.failure)
  {
    json["nodes"] = report.mesh.nodes;
    json["cells"] = report.mesh.cells;
    json["volume_mm3"] = report.mesh.volume;
    if (!report.mesh.outline.empty())
    {
      json["outline"] = report.mesh.outline;
    }
  }
  return json;
}

Json
exactJson(const RunReport & report)
{
  Json json{ { "reached", report.exact->reached },
             { "certified", report.exact->certified },
             { "uncertified_cells", report.exact->uncertifiedCells },
             { "variance", report.exact->variance },
             { "shortcomings", report.exact->shortcomings } };
  if (report.density)
  {
    json["mass_quadrature_error"] = report.exact->massQuadratureError;
  }
  return json;
}

/** Leaves out what differs from run to run. */
void
removeCosts(Json & json)
{
  for (Json & stage : json["stages"])
  {
    stage.erase("seconds");
  }
  for (const char * key : { "threads", "seconds", "peak_memory_mib" })
  {
    json.erase(key);
  }
}

} // namespace

EqualMeasure
equalMeasureOf(const RunReport & report)
{
  if (report.density)
  {
    return { "mass", "masses" };
  }
  return report.templateMesh && report.templateMesh->growth
           ? EqualMeasure{ "volume over its growth", "volumes over their growth" }
           : EqualMeasure{ "volume", "volumes" };
}

RunReport::Versions
libraryVersions()
{
  RunReport::Versions versions;
  versions.itk = itk::Version::GetITKVersion();
  versions.vtk = vtkVersion::GetVTKVersion();
  versions.eigen = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                   std::to_string(EIGEN_MINOR_VERSION);
  return versions;
}

std::string
toJson(const RunReport & report)
{
  Json json{ { "status", report.failure ? "failed" : "meshed" } };
  if (report.failure)
  {
    json["error"] = { { "code", nameOf(report.failure->code) }, { "message", report.failure->message } };
  }
  json["coordinate_system"] = "LPS";
  json["units"] = "mm";
  json["input"] = inputJson(report.input);
  json["parameters"] = parametersJson(report.parameters);
  if (report.conditioning)
  {
    json["conditioning"] = conditioningJson(*report.conditioning);
  }
  if (report.density)
  {
    json["density"] = densityJson(*report.density);
  }
  json["stages"] = Json::array();
  for (const StageRecord & stage : report.stages)
  {
    json["stages"].push_back(stageJson(stage));
  }
  json["mesh"] = meshJson(report);
  if (report.surface)
  {
    json["surface"] = { { "rms_mm", report.surface->rms }, { "max_mm", report.surface->maximum } };
  }
  if (report.templateMesh)
  {
    json["template"] = templateJson(*report.templateMesh);
  }
  if (report.frame)
  {
    json["frame"] = { { "turned_degrees", report.frame->angle },
                      { "edge_score_before", report.frame->scoreBefore },
                      { "edge_score_after", report.frame->scoreAfter } };
  }
  if (report.latticeTurn)
  {
    const Vector3 & turn = *report.latticeTurn;
    json["lattice_turn_degrees"] = { turn[0], turn[1], turn[2] };
  }
  if (report.exact)
  {
    json["exact"] = exactJson(report);
  }
  json["warning_count"] = report.warnings.size();
  json["warnings"] = Json(report.warnings);
  json["versions"] = { { "moserhex", report.versions.moserhex },
                       { "git", report.versions.git },
                       { "itk", report.versions.itk },
                       { "vtk", report.versions.vtk },
                       { "eigen", report.versions.eigen } };
  json["threads"] = report.threads;
  json["seconds"] = report.seconds;
  if (report.peakMemory)
  {
    json["peak_memory_mib"] = *report.peakMemory;
  }
  if (report.reproducible)
  {
    removeCosts(json);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeRunReport(const std::string & fileName, const RunReport & report)
{
  writeTextFile(fileName, toJson(report));
}

} // namespace moserhex
