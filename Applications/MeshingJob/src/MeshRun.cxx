#include "MeshRun.h"

#include "CommandErrors.h"

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

TemplateAlignment
alignmentOf(const std::string & name)
{
  static const std::map<std::string, TemplateAlignment> alignments{
    { "rigid", TemplateAlignment::Rigid },
    { "affine", TemplateAlignment::Affine },
    { "none", TemplateAlignment::None },
  };
  return alignments.at(name);
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

/** The file that an error is about, and what to do about it. */
struct Fault
{
  std::string file;
  std::string remedy;
};

/** A file's name, or what it holds where arrays are given instead. */
std::string
named(const std::string & file, const char * content)
{
  return file.empty() ? content : file;
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

Fault
faultOf(ErrorCode code, const std::string & description, const ChosenSolid & solid, const MeshCommandOptions & options)
{
  switch (code)
  {
    case ErrorCode::Density:
      return { options.density, remedyForDensity(options.density, description) };
    case ErrorCode::Template:
      return isAlignedByFile(options)
               ? Fault{ options.align, "give the transform from the template's space to the label's" }
               : Fault{ options.templateMesh, "give a mesh of this organ in the label's space, or --align rigid" };
    case ErrorCode::TemplateImage:
      return { named(options.templateImage, "template_image"), "give an image of the template's whole organ" };
    case ErrorCode::TemplateLandmarks:
      return { named(options.templateLandmarks, "template_landmarks"), "is it in the template's space, LPS or RAS?" };
    case ErrorCode::Image:
      return { named(options.image, "image"), "give an image of the label's whole organ" };
    case ErrorCode::Landmarks:
      return { named(options.landmarks, "landmarks"), "is it in the label's space, LPS or RAS?" };
    default:
      return { options.input.file, remedyForSolid(solid, options, code) };
  }
}

[[noreturn]] void
throwOutOfMemory(const MeshCommandOptions & options)
{
  throw NoMeshError(ErrorCode::OutOfMemory,
                    options.input.file,
                    "not enough memory",
                    "use fewer shells, a smaller image, or a larger machine");
}

void
tie(const TemplateInputs & tied, const MeshCommandOptions & options, PipelineType & filter)
{
  filter.SetTemplateMesh(tied.mesh);
  filter.SetTemplateRefinement(tied.refinement);
  if (tied.nodesAtSolid)
  {
    filter.SetTemplateNodes(*tied.nodesAtSolid);
    return;
  }
  filter.SetTemplateAlignment(alignmentOf(options.align));
}

} // namespace

PipelineType::Pointer
runPipeline(const ChosenSolid &        solid,
            const PipelineInputs &     inputs,
            const MeshCommandOptions & options,
            const ProgressCallback &   progress)
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
  if (inputs.tied)
  {
    tie(*inputs.tied, options, *filter);
  }
  filter->SetDensityImage(inputs.density);
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
    const Fault       fault = faultOf(error.GetCode(), description, solid, options);
    throw BadInput(error.GetCode(), fault.file, description, fault.remedy);
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
