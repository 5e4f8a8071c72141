#include "MeshReport.h"

#include "Console.h"
#include "MeshRecord.h"
#include "Silhouette.h"
#include "TemplateWarnings.h"
#include "Version.h"

#include <cstdio>

namespace moserhex::app
{
namespace
{

RunReport::Conditioning
describeConditioning(const ConditioningReport & conditioning)
{
  const TopologyRepairReport & repair = conditioning.repair;
  RunReport::Conditioning      record;
  record.components = repair.before.components;
  record.cavities = repair.before.cavities;
  record.handles = repair.before.handles();
  record.changes = repair.changes;
  record.voxelsAdded = repair.voxelsAdded;
  record.voxelsRemoved = repair.voxelsRemoved;
  record.voxelVolume = repair.voxelVolume;
  record.changedPercent = 100.0 * repair.changedFraction();
  record.sigma = conditioning.sigma;
  record.dice = conditioning.dice;
  return record;
}

void
describeTies(const SolidMeshingResult & result, RunReport::Template & tied)
{
  if (result.alignment)
  {
    const SurfaceAlignmentResult & alignment = *result.alignment;
    tied.aligned =
      RunReport::Alignment{ alignment.motion.angle(), alignment.shift, alignment.rmsBefore, alignment.motion };
  }
  if (result.templateFit)
  {
    tied.placed =
      RunReport::Placement{ result.templateFit->scale, result.templateFit->rms, result.templateFit->median };
  }
  tied.start = result.drawnFromOwnMesh ? "own" : "template";
  if (result.refinement && result.refinement->landmarkError)
  {
    tied.landmarks =
      RunReport::Residual{ result.refinement->landmarkError->before, result.refinement->landmarkError->after };
  }
  if (result.refinement && result.refinement->imageDifference)
  {
    tied.imageDifference =
      RunReport::Residual{ result.refinement->imageDifference->before, result.refinement->imageDifference->after };
  }
  if (result.refinement && result.refinement->growth)
  {
    const LocalGrowth & growth = *result.refinement->growth;
    tied.growth = RunReport::Growth{ growth.smallest, growth.largest, growth.limited };
  }
}

void
describeMesh(const SolidMeshingResult & result, const std::vector<MeshingStageReport> & stages, RunReport & report)
{
  for (const MeshingStageReport & stage : stages)
  {
    StageRecord record{ stage.name, stage.seconds, {}, stage.note };
    if (stage.quality)
    {
      record.quality = StageQuality{ stage.quality->volumeVariance,
                                     stage.quality->concavePercent,
                                     stage.quality->scaledJacobian.minimum,
                                     stage.quality->scaledJacobian.median,
                                     stage.quality->scaledJacobian.mean };
      report.mesh.volume = stage.quality->volume;
    }
    report.stages.push_back(record);
  }
  report.mesh.nodes = result.mesh.nodes.size();
  report.mesh.cells = result.mesh.cellCount();
  report.mesh.outline = silhouette(result.mesh);
  report.surface = RunReport::Surface{ result.boundary.rms, result.boundary.maximum };
  if (report.templateMesh)
  {
    describeTies(result, *report.templateMesh);
    const std::vector<std::string> warnings =
      templateWarnings(*result.templateFit, *report.templateMesh, report.mesh.volume);
    report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  }
  if (result.frame)
  {
    report.frame = RunReport::Frame{ result.frame->angle, result.frame->before.score, result.frame->after.score };
  }
  if (result.equalisation)
  {
    RunReport::Exact exact;
    exact.reached = result.equalisation->exact;
    exact.certified = result.equalisation->uncertifiedCells == 0;
    exact.uncertifiedCells = result.equalisation->uncertifiedCells;
    exact.variance = result.equalisation->variance;
    exact.massQuadratureError = result.mass ? result.mass->quadratureError : 0.0;
    exact.shortcomings = result.equalisation->shortcomings;
    report.exact = exact;
  }
  report.warnings.insert(report.warnings.end(), result.warnings.begin(), result.warnings.end());
}

/** How the lattice is turned off the patient's axes: a tied one as its template. */
std::optional<Vector3>
turnOf(const PipelineType & pipeline, const PipelineInputs & inputs)
{
  if (inputs.tied)
  {
    return inputs.tied->latticeTurn;
  }
  const Vector3 turn = rotationVector(latticeTurn(pipeline.GetResult()));
  return turn.norm() > 0.0 ? std::optional<Vector3>(turn) : std::nullopt;
}

} // namespace

RunReport
startReport(const MeshCommandOptions & options)
{
  RunReport report;
  report.input.file = options.input.file;
  report.parameters.shells = options.shells;
  report.parameters.padding = options.padding;
  report.parameters.stage = options.stage;
  report.parameters.shellMethod = options.shellMethod;
  report.parameters.way = options.stage == "exact" ? wayOf(options) : "";
  report.parameters.frame = options.frame;
  report.parameters.density = options.density;
  report.parameters.localGrowth = options.localGrowth;
  if (!options.templateMesh.empty())
  {
    report.templateMesh = RunReport::Template{};
    report.templateMesh->alignment = isAlignedByFile(options) ? "file" : options.align;
    report.templateMesh->files = templateFiles(options);
  }
  report.parameters.topology = options.topology;
  report.parameters.maximumRepair = options.maximumRepairPercent;
  report.parameters.threshold = options.input.threshold;
  report.parameters.segment = options.input.segment;
  report.threads = options.threads;
  report.versions = libraryVersions();
  report.versions.moserhex = version;
  report.versions.git = gitDescription;
  report.mesh.file = options.output;
  report.reproducible = options.reproducible;
  return report;
}

void
addSolid(const ChosenSolid & solid, RunReport & report)
{
  RunReport::Input & input = report.input;
  input.labels = solid.labelValues();
  input.labelName = solid.labels.size() == 1 ? solid.labels.front().name : "";
  for (int axis = 0; axis < 3; ++axis)
  {
    input.spacing[axis] = solid.mask->GetSpacing()[static_cast<unsigned int>(axis)];
  }
  input.voxels = solid.voxels;
  input.volume = static_cast<double>(solid.voxels) * input.spacing.prod();
  report.warnings.insert(report.warnings.end(), solid.image.warnings.begin(), solid.image.warnings.end());
}

void
addResults(const PipelineType & pipeline, const PipelineInputs & inputs, RunReport & report)
{
  report.latticeTurn = turnOf(pipeline, inputs);
  report.conditioning = describeConditioning(pipeline.GetConditioningReport());
  describeMesh(pipeline.GetResult(), pipeline.GetStages(), report);
  if (pipeline.GetLabelDensity())
  {
    const LabelDensity & onLabel = *pipeline.GetLabelDensity();
    RunReport::Density & density = report.density ? *report.density : report.density.emplace();
    density.mean = onLabel.meanDensity;
    density.mass = onLabel.mass;
    density.massPerCell = onLabel.mass / static_cast<double>(report.mesh.cells);
  }
}

void
printSummary(const RunReport & report, const ChosenSolid & solid, const MeshCommandOptions & options)
{
  printQualityTable(report);
  std::printf("\n%s: %.3f mL; mesh: %zu nodes, %zu cells, %.3f mL",
              solid.name().c_str(),
              report.input.volume / 1000.0,
              report.mesh.nodes,
              report.mesh.cells,
              report.mesh.volume / 1000.0);
  if (report.surface)
  {
    std::printf("; surface within %.2f mm (rms %.2f)", report.surface->maximum, report.surface->rms);
  }
  if (report.density)
  {
    std::printf("\ndensity: mean %.6g in the label, mass %.6g, %.6g in every cell (unit of the image x mm3)",
                report.density->mean,
                report.density->mass,
                report.density->massPerCell);
  }
  if (report.frame)
  {
    std::printf("\nframe: turned by %.1f degrees, edge score %.3g -> %.3g",
                report.frame->angle,
                report.frame->scoreBefore,
                report.frame->scoreAfter);
  }
  if (report.exact)
  {
    std::printf("\n%s: variance of the %s %.1e, %s",
                report.exact->reached ? "exact" : "NOT EXACT",
                equalMeasureOf(report).plural,
                report.exact->variance,
                report.exact->certified ? "every cell certified" : "cells not certified");
  }
  std::printf("\nmesh    %s\n", options.output.c_str());
  if (!options.reportFile.empty())
  {
    std::printf("report  %s\n", options.reportFile.c_str());
  }
  if (!options.pageFile.empty())
  {
    std::printf("page    %s\n", options.pageFile.c_str());
  }
  if (!options.transformFile.empty())
  {
    std::printf("transform %s\n", options.transformFile.c_str());
  }
}

} // namespace moserhex::app
