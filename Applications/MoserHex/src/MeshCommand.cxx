#include "MeshCommand.h"

#include "Console.h"
#include "SameFile.h"
#include "Version.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"
#include "moserhex/HexMeshIO/Sha256.h"
#include "moserhex/HexMeshIO/SurfaceReader.h"
#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"
#include "moserhex/Quality/HexQuality.h"

#include <itkMassPreservingHexahedralMeshFilter.h>
#include <itkMultiThreaderBase.h>

#include <cstdio>
#include <filesystem>
#include <map>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

using FilterType = itk::MassPreservingHexahedralMeshFilter<LabelImageType, itk::LatticeHexMesh>;

/** What can be wrong with the names is found before the work, not after. */
void
requireUsableNames(const MeshCommandOptions & options)
{
  if (!isHexMeshName(options.output))
  {
    throw UsageError(
      fileMessage(options.output, "not a mesh file's name", "give an OUTPUT that ends with .vtu or .vtk"));
  }
  if (!isLabelImageName(options.input) && !isSurfaceName(options.input))
  {
    throw BadInput(ErrorCode::Format,
                   options.input,
                   "the name's ending is not that of a labelmap or a surface",
                   "give .nrrd .nii .nii.gz .mha .mhd, or .vtk .vtp .stl .obj .ply .off");
  }
  if (!options.density.empty() && options.stage != "exact")
  {
    throw UsageError("--density needs --stage exact");
  }
  if (options.way && options.stage != "exact")
  {
    throw UsageError("--way needs --stage exact; the other stages are always made the faithful way");
  }
  if (sameFile(options.density, options.output) || sameFile(options.density, options.reportFile))
  {
    throw UsageError(fileMessage(options.density, "would be overwritten", "give another name for the output"));
  }
  if (sameFile(options.input, options.output) || sameFile(options.input, options.reportFile))
  {
    throw UsageError(fileMessage(options.input, "would be overwritten", "give another name for the output"));
  }
  if (sameFile(options.output, options.reportFile))
  {
    throw UsageError(fileMessage(options.output, "is both OUTPUT and report", "give the report another name"));
  }
}

void
requireWritable(const std::string & fileName)
{
  const AtomicFile probe(fileName);
}

/** The labelmap of the input: as it is, or a closed surface voxelised as label 1. */
LabelImage
readInput(const std::string & fileName)
{
  if (isLabelImageName(fileName))
  {
    return readLabelImage(fileName);
  }
  const SurfaceFile surface = readSurface(fileName);
  try
  {
    const LabelVolume voxels = voxelise(surface.mesh);
    LabelImage        image;
    image.fileName = fileName;
    image.image = labelImageOf(voxels);
    image.labels = { { 1, voxelCount(voxels), "" } };
    image.warnings = surface.warnings;
    return image;
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), fileName, error.what(), "give a surface of a compact solid");
  }
}

FilterType::ShellMethod
shellMethodOf(const std::string & name)
{
  static const std::map<std::string, FilterType::ShellMethod> methods{
    { "chan-vese", FilterType::ShellMethod::ChanVese },
    { "snapshots", FilterType::ShellMethod::Snapshots },
    { "eikonal", FilterType::ShellMethod::Eikonal },
  };
  return methods.at(name);
}

MeshingStage
stageOf(const std::string & name)
{
  static const std::map<std::string, MeshingStage> stages{
    { "initial", MeshingStage::Initial },
    { "smoothed", MeshingStage::Smoothed },
    { "moser", MeshingStage::Moser },
    { "exact", MeshingStage::Exact },
  };
  return stages.at(name);
}

std::string
wayOf(const MeshCommandOptions & options)
{
  return options.way.value_or("fast");
}

/** ITK's exceptions carry the filter's name before the message proper. */
std::string
descriptionOf(const itk::ExceptionObject & error)
{
  return error.GetDescription();
}

/** ITK's NIfTI reader turns values that are not finite into 0: one who looks for that 0 in the file finds none. */
std::string
remedyForDensity(const std::string & fileName, const std::string & description)
{
  const bool maybeNotFinite =
    fileName.find(".nii") != std::string::npos && description.find("holds 0 ") != std::string::npos;
  return maybeNotFinite ? "make it positive (NaN and infinity in NIfTI files are read as 0)"
                        : "give a positive image that covers the label";
}

/** The one call of the pipeline: labelmap in, filter with its results out. */
FilterType::Pointer
runPipeline(const LabelImage &         input,
            LabelValue                 label,
            const ScalarImageType *    density,
            const MeshCommandOptions & options)
{
  const auto      filter = FilterType::New();
  ProgressPrinter progress(options.quiet);
  filter->SetInput(input.image);
  filter->SetLabel(label);
  filter->SetNumberOfShells(options.shells);
  filter->SetLastStage(stageOf(options.stage));
  filter->SetWay(wayOf(options) == "faithful" ? MeshingWay::Faithful : MeshingWay::Fast);
  filter->SetAllowPartial(options.allowPartial);
  filter->SetFrame(options.frame == "ridge" ? LatticeFrame::Ridge : LatticeFrame::Anatomical);
  filter->SetDensityImage(density);
  if (options.shellMethod != "auto")
  {
    filter->SetShellMethod(shellMethodOf(options.shellMethod));
  }
  filter->SetNumberOfWorkUnits(options.threads);
  filter->AddObserver(itk::ProgressEvent(), [&progress, &filter](const itk::EventObject &) {
    progress.show(static_cast<double>(filter->GetProgress()));
  });
  try
  {
    filter->Update();
  }
  catch (const itk::InvalidInputError & error)
  {
    const std::string description = descriptionOf(error);
    if (error.GetCode() == ErrorCode::Density)
    {
      throw BadInput(error.GetCode(), options.density, description, remedyForDensity(options.density, description));
    }
    throw BadInput(error.GetCode(), options.input, description, "correct the label in an editor");
  }
  catch (const itk::NotConvergedError & error)
  {
    // allow-partial lets a mesh pass that is not exact; it is no help where a stage before that failed.
    const bool isMeshed = error.GetCode() == ErrorCode::NotExact;
    throw NoMeshError(error.GetCode(),
                      options.input,
                      descriptionOf(error),
                      isMeshed ? "try other --shells, or --allow-partial" : "try another number of shells");
  }
  catch (const itk::ExceptionObject & error)
  {
    throw NoMeshError(ErrorCode::Internal, options.input, descriptionOf(error), "please report this");
  }
  catch (const std::bad_alloc &)
  {
    throw NoMeshError(ErrorCode::OutOfMemory, options.input, "not enough memory", "use fewer shells or crop the image");
  }
  filter->RemoveAllObservers();
  return filter;
}

RunReport::Input
describeInput(const LabelImage & image, const LabelEntry & entry)
{
  RunReport::Input input;
  input.file = image.fileName;
  input.sha256 = sha256OfFile(image.fileName);
  input.label = entry.value;
  input.labelName = entry.name;
  for (int axis = 0; axis < 3; ++axis)
  {
    input.spacing[axis] = image.image->GetSpacing()[static_cast<unsigned int>(axis)];
  }
  input.voxels = entry.voxels;
  input.volume = static_cast<double>(entry.voxels) * input.spacing.prod();
  return input;
}

void
describeResult(const SolidMeshingResult & result, const std::vector<MeshingStageReport> & stages, RunReport & report)
{
  for (const MeshingStageReport & stage : stages)
  {
    StageRecord record{ stage.name, stage.seconds, {}, stage.note };
    if (stage.quality)
    {
      record.quality = StageQuality{ stage.quality->volumeVariance,
                                     stage.quality->concavePercent,
                                     stage.quality->scaledJacobian.minimum,
                                     stage.quality->scaledJacobian.median };
      report.mesh.volume = stage.quality->volume;
    }
    report.stages.push_back(record);
  }
  report.mesh.nodes = result.mesh.nodes.size();
  report.mesh.cells = result.mesh.cellCount();
  report.surface = RunReport::Surface{ result.boundary.rms, result.boundary.maximum };
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

HexMeshFields
fieldsOf(const HexMesh & mesh)
{
  HexMeshFields fields;
  fields.scaledJacobian.reserve(mesh.cellCount());
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    fields.scaledJacobian.push_back(hexCellQuality(cellCorners(mesh, cell)).scaledJacobian);
  }
  return fields;
}

void
printSummary(const RunReport & report, const MeshCommandOptions & options)
{
  printQualityTable(report);
  std::printf("\nlabel %lld: %.3f mL; mesh: %zu nodes, %zu cells, %.3f mL",
              static_cast<long long>(report.input.label),
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
                report.density ? "masses" : "volumes",
                report.exact->variance,
                report.exact->certified ? "every cell certified" : "cells not certified");
  }
  std::printf("\nmesh    %s\n", options.output.c_str());
  if (!options.reportFile.empty())
  {
    std::printf("report  %s\n", options.reportFile.c_str());
  }
}

} // namespace

void
runMeshCommand(const MeshCommandOptions & userOptions)
{
  const Stopwatch    stopwatch;
  MeshCommandOptions options = userOptions;
  options.threads = options.threads == 0 ? defaultThreadCount() : options.threads;
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(options.threads);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(options.threads);

  requireUsableNames(options);
  const LabelImage   image = readInput(options.input);
  const LabelEntry & entry = chooseLabel(image, options.label);
  requireWritable(options.output);
  if (!options.reportFile.empty())
  {
    requireWritable(options.reportFile);
  }

  RunReport report;
  report.input = describeInput(image, entry);
  report.parameters = { options.shells,      options.stage,
                        options.shellMethod, options.stage == "exact" ? wayOf(options) : "",
                        options.frame,       options.density };
  report.threads = options.threads;
  report.versions = libraryVersions();
  report.versions.moserhex = version;
  report.versions.git = gitDescription;
  report.warnings = image.warnings;

  ScalarImage density;
  if (!options.density.empty())
  {
    density = readScalarImage(options.density);
    report.warnings.insert(report.warnings.end(), density.warnings.begin(), density.warnings.end());
  }
  const auto                 filter = runPipeline(image, entry.value, density.image.GetPointer(), options);
  const SolidMeshingResult & result = filter->GetResult();
  describeResult(result, filter->GetStages(), report);
  if (filter->GetLabelDensity())
  {
    const LabelDensity & onLabel = *filter->GetLabelDensity();
    report.density = RunReport::Density{ options.density,
                                         sha256OfFile(options.density),
                                         onLabel.meanDensity,
                                         onLabel.mass,
                                         onLabel.mass / static_cast<double>(report.mesh.cells) };
  }
  report.mesh.file = options.output;

  writeHexMesh(options.output, result.mesh, fieldsOf(result.mesh));
  report.seconds = stopwatch.seconds();
  if (!options.reportFile.empty())
  {
    writeRunReport(options.reportFile, report);
  }
  for (const std::string & warning : report.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    printSummary(report, options);
  }
}

} // namespace moserhex::app
