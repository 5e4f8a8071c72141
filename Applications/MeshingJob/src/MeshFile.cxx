#include "MeshFile.h"

#include "CasePage.h"
#include "CommandErrors.h"
#include "Guard.h"
#include "MeshRecord.h"
#include "MeshReport.h"
#include "OutputName.h"
#include "PageName.h"
#include "PeakMemory.h"
#include "ScaledJacobians.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/HexMeshIO/InputChecksum.h"
#include "moserhex/HexMeshIO/TransformWriter.h"
#include "moserhex/Quality/CellLabels.h"

#include <itkMultiThreaderBase.h>

#include <exception>
#include <utility>
#include <vector>

namespace moserhex::app
{
namespace
{

/** A file that a run writes. */
struct Output
{
  const char * kind;
  std::string  file; ///< empty: none
};

std::vector<Output>
outputsOf(const MeshCommandOptions & options)
{
  return { { "OUTPUT", options.output },
           { "report", options.reportFile },
           { "page", options.pageFile },
           { "transform", options.transformFile } };
}

/** What can be wrong with the names is found before the work, not after. */
void
requireUsableNames(const MeshCommandOptions & options)
{
  requireHexMeshName(options.output);
  requireUsable(options);
  requireUsed(options);
  requirePagesFor(options.pageFile);
  const std::vector<Output> outputs = outputsOf(options);
  for (auto output = outputs.begin(); output != outputs.end(); ++output)
  {
    for (const std::string & input : inputFiles(options))
    {
      requireKept(input, output->file);
    }
    for (auto other = outputs.begin(); other != output; ++other)
    {
      if (sameFile(output->file, other->file))
      {
        throw UsageError(fileMessage(output->file,
                                     std::string("is both ") + other->kind + " and " + output->kind,
                                     "give one of them another name"));
      }
    }
  }
}

void
requireKnownKind(const InputOptions & input)
{
  if (!isInputName(input.file))
  {
    throw BadInput(ErrorCode::Format,
                   input.file,
                   "the name's ending is not that of a labelmap or a surface",
                   "give .nrrd .nhdr .nii .nii.gz .mha .mhd, or .vtk .vtp .stl .obj .ply .off");
  }
}

void
requireWritable(const std::string & fileName)
{
  const AtomicFile probe(fileName);
}

/** The checksum in the report must be that of what was read. */
void
requireUnchanged(const std::string & fileName, const std::string & sha256)
{
  if (sha256OfInput(fileName) != sha256)
  {
    throw IOError(ErrorCode::InputOutput, fileName, "the file changed during the run", "run again when it is complete");
  }
}

/** Reads, meshes and writes the mesh. What is known by then is in the report, also when it throws. */
void
makeMesh(const MeshCommandOptions &                       options,
         const ProgressCallback &                         progress,
         const std::function<void(const std::string &)> & say,
         MeshedFile &                                     meshed)
{
  RunReport & report = meshed.report;
  report.input.sha256 = sha256OfInput(options.input.file);
  requireKnownKind(options.input);
  say("reading the label");
  meshed.solid = readSolid(options.input);
  addSolid(meshed.solid, report);
  for (const Output & output : outputsOf(options))
  {
    if (!output.file.empty())
    {
      requireWritable(output.file);
    }
  }
  ScalarImage density;
  if (!options.density.empty())
  {
    density = readScalarImage(options.density, { options.input.sandbox });
    report.density = RunReport::Density{ options.density, sha256OfInput(options.density) };
    report.warnings.insert(report.warnings.end(), density.warnings.begin(), density.warnings.end());
  }
  PipelineInputs inputs;
  inputs.density = density.image.GetPointer();
  if (report.templateMesh)
  {
    for (RunReport::File & file : report.templateMesh->files)
    {
      file.sha256 = sha256OfInput(file.name);
    }
    inputs.tied = readTemplate(options);
    report.warnings.insert(report.warnings.end(), inputs.tied->warnings.begin(), inputs.tied->warnings.end());
  }
  say("meshing " + meshed.solid.name());
  meshed.pipeline = runPipeline(meshed.solid, inputs, options, progress);
  addResults(*meshed.pipeline, inputs, report);
  requireUnchanged(options.input.file, report.input.sha256);
  if (report.density)
  {
    requireUnchanged(report.density->file, report.density->sha256);
  }
  for (const RunReport::File & file : report.templateMesh ? report.templateMesh->files : std::vector<RunReport::File>())
  {
    requireUnchanged(file.name, file.sha256);
  }

  say("writing the mesh");
  const HexMesh & mesh = meshed.pipeline->GetHexMesh();
  HexMeshFields   fields = fieldsOf(mesh, meshed.solid, options.threads);
  if (holdsNamedArrays(options.output))
  {
    fields.meshArrays = recordOf(report);
  }
  writeHexMesh(options.output, mesh, fields);
  if (!options.transformFile.empty())
  {
    writeTransform(options.transformFile, meshed.pipeline->GetResult().alignment->motion);
  }
}

/** What a page shows of a run, as far as it came. */
CaseContent
contentOf(const MeshedFile & meshed, unsigned int threads)
{
  CaseContent content;
  content.report = meshed.report;
  content.labels = meshed.solid.labels;
  content.image = meshed.solid.image.image;
  if (!meshed.report.failure)
  {
    content.mesh = &meshed.pipeline->GetHexMesh();
    content.labelOfCells = fieldsOf(*content.mesh, meshed.solid, threads).label;
  }
  return content;
}

/** Writes the reports that were asked for. */
void
writeReports(const MeshCommandOptions & options, const MeshedFile & meshed)
{
  if (!options.reportFile.empty())
  {
    writeRunReport(options.reportFile, meshed.report);
  }
  if (!options.pageFile.empty())
  {
    writeCasePage(options.pageFile, contentOf(meshed, options.threads));
  }
}

/** Writes the reports of a run that ended with the exception being handled. That they cannot be written is not said:
 * the run's own error is what counts. */
void
writeReportsOfFailure(const MeshCommandOptions & options, MeshedFile & meshed)
{
  const Failure failure = describeFailure(std::current_exception());
  if (failure.code == ErrorCode::Usage || failure.code == ErrorCode::Cancelled)
  {
    return;
  }
  meshed.report.failure = RunReport::Failure{ failure.code, failure.message };
  try
  {
    writeReports(options, meshed);
  }
  catch (const std::exception &)
  {
    return;
  }
}

} // namespace

HexMeshFields
fieldsOf(const HexMesh & mesh, const ChosenSolid & solid, unsigned int threads)
{
  HexMeshFields fields;
  fields.scaledJacobian = scaledJacobiansOf(mesh);
  if (solid.labels.size() > 1)
  {
    fields.label = labelsOfCells(mesh, labelValuesOf(*solid.image.image), threads);
  }
  return fields;
}

MeshedFile
meshFile(const MeshCommandOptions &                       userOptions,
         const ProgressCallback &                         progress,
         const std::function<void(const std::string &)> & comment)
{
  const auto say = [&comment](const std::string & what) {
    if (comment)
    {
      comment(what);
    }
  };
  MeshCommandOptions options = userOptions;
  options.threads = options.threads == 0 ? defaultThreadCount() : options.threads;
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(options.threads);
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(options.threads);

  requireUsableNames(options);
  const Stopwatch stopwatch;
  MeshedFile      meshed;
  RunReport &     report = meshed.report;
  report = startReport(options);
  const auto addCosts = [&] {
    report.seconds = stopwatch.seconds();
    report.peakMemory = peakMemory();
  };
  try
  {
    makeMesh(options, progress, say, meshed);
  }
  catch (...)
  {
    addCosts();
    writeReportsOfFailure(options, meshed);
    throw;
  }
  addCosts();
  writeReports(options, meshed);
  return meshed;
}

} // namespace moserhex::app
