#include "MeshRun.h"

#include "CommandErrors.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <map>
#include <new>

namespace moserhex::app
{
namespace
{

PipelineType::ShellMethod
shellMethodOf(const std::string & name)
{
  static const std::map<std::string, PipelineType::ShellMethod> methods{
    { "chan-vese", PipelineType::ShellMethod::ChanVese },
    { "snapshots", PipelineType::ShellMethod::Snapshots },
    { "eikonal", PipelineType::ShellMethod::Eikonal },
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

/** ITK's NIfTI reader turns values that are not finite into 0: one who looks for that 0 in the file finds none. */
std::string
remedyForDensity(const std::string & fileName, const std::string & description)
{
  const bool maybeNotFinite =
    fileName.find(".nii") != std::string::npos && description.find("holds 0 ") != std::string::npos;
  return maybeNotFinite ? "make it positive (NaN and infinity in NIfTI files are read as 0)"
                        : "give a positive image that covers the label";
}

const char *
remedyForSolid(const ChosenSolid & solid, const MeshCommandOptions & options, ErrorCode code)
{
  if (solid.labels.size() > 1)
  {
    return "choose one label with --label";
  }
  if (code == ErrorCode::Topology)
  {
    return options.topology == "repair" ? "correct it, or raise --max-repair" : "correct it, or --topology repair";
  }
  return code == ErrorCode::Thin ? "use a finer image" : "correct the label in an editor";
}

[[noreturn]] void
throwOutOfMemory(const MeshCommandOptions & options)
{
  throw NoMeshError(
    ErrorCode::OutOfMemory, options.input.file, "not enough memory", "use fewer shells or crop the image");
}

TemplateAlignment
templateAlignmentOf(const std::string & name)
{
  static const std::map<std::string, TemplateAlignment> alignments{
    { "none", TemplateAlignment::None },
    { "rigid", TemplateAlignment::Rigid },
  };
  return alignments.at(name);
}

void
requireTemplate(const HexMesh & mesh, const MeshCommandOptions & options)
{
  if (mesh.nodesPerSide != 2 * options.shells || mesh.paddingLayers > 0)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   options.templateMesh,
                   "a template of " + std::to_string(mesh.nodesPerSide) + " nodes a side and " +
                     std::to_string(mesh.paddingLayers) + " layers of padding",
                   "give one of --shells " + std::to_string(options.shells) + " without padding");
  }
}

} // namespace

PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const ScalarImageType *    density,
            const MeshCommandOptions & options,
            const ProgressCallback &   progress,
            const HexMesh *            templateMesh)
{
  const auto filter = PipelineType::New();
  filter->SetInput(solid.mask);
  filter->SetLabel(solid.value);
  filter->SetNumberOfShells(options.shells);
  filter->SetLastStage(stageOf(options.stage));
  filter->SetWay(wayOf(options) == "faithful" ? MeshingWay::Faithful : MeshingWay::Fast);
  filter->SetTopologyPolicy(options.topology == "reject" ? TopologyPolicy::Reject : TopologyPolicy::Repair);
  filter->SetMaximumRepair(options.maximumRepairPercent / 100.0);
  filter->SetAllowPartial(options.allowPartial);
  filter->SetFrame(options.frame == "ridge" ? LatticeFrame::Ridge : LatticeFrame::Anatomical);
  filter->SetPaddingLayers(options.padding);
  if (!options.templateMesh.empty())
  {
    HexMesh mesh =
      templateMesh != nullptr ? *templateMesh : readHexMesh(options.templateMesh, { options.input.sandbox });
    requireTemplate(mesh, options);
    filter->SetTemplateMesh(std::move(mesh));
    filter->SetTemplateAlignment(templateAlignmentOf(options.align));
  }
  filter->SetDensityImage(density);
  if (options.shellMethod != "auto")
  {
    filter->SetShellMethod(shellMethodOf(options.shellMethod));
  }
  filter->SetNumberOfWorkUnits(options.threads);
  filter->AddObserver(itk::ProgressEvent(), [&progress, &filter](const itk::EventObject &) {
    if (progress && !progress(static_cast<double>(filter->GetProgress())))
    {
      filter->AbortGenerateDataOn();
    }
  });
  try
  {
    filter->Update();
  }
  catch (const itk::InvalidInputError & error)
  {
    const std::string description = error.GetDescription();
    if (error.GetCode() == ErrorCode::Density)
    {
      throw BadInput(error.GetCode(), options.density, description, remedyForDensity(options.density, description));
    }
    throw BadInput(error.GetCode(), options.input.file, description, remedyForSolid(solid, options, error.GetCode()));
  }
  catch (const itk::NotConvergedError & error)
  {
    // allow-partial lets a mesh pass that is not exact; it is no help where a stage before that failed.
    const bool isMeshed = error.GetCode() == ErrorCode::NotExact;
    throw NoMeshError(error.GetCode(),
                      options.input.file,
                      std::string(error.GetDescription()),
                      isMeshed ? "try other --shells, or --allow-partial" : "try another number of shells");
  }
  catch (const itk::ProcessAborted &)
  {
    throw Cancelled();
  }
  catch (const itk::MemoryAllocationError &)
  {
    throwOutOfMemory(options);
  }
  catch (const itk::ExceptionObject & error)
  {
    throw NoMeshError(
      ErrorCode::Internal, options.input.file, std::string(error.GetDescription()), "please report this");
  }
  catch (const std::bad_alloc &)
  {
    throwOutOfMemory(options);
  }
  filter->RemoveAllObservers();
  return filter;
}

} // namespace moserhex::app
