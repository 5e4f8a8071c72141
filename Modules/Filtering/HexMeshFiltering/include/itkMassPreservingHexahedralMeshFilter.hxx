#ifndef itkMassPreservingHexahedralMeshFilter_hxx
#define itkMassPreservingHexahedralMeshFilter_hxx

#include "itkLevelSetConversion.h"
#include "itkMassPreservingHexahedralMeshFilter.h"

#include "moserhex/Common/Stopwatch.h"

#include <itkEventObject.h>

#include <optional>

namespace itk
{

template <typename TLabelImage, typename TMesh>
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_Options.shells < 2 || m_Options.shells > 64)
  {
    itkExceptionMacro("NumberOfShells is " << m_Options.shells << ", need 2 to 64");
  }
  if (this->GetDensityImage() && m_Options.lastStage != moserhex::MeshingStage::Exact)
  {
    itkExceptionMacro("DensityImage is set, but the last stage is not Exact");
  }
  if (m_Options.refinement.any() && !m_Options.templateMesh)
  {
    itkExceptionMacro("TemplateRefinement is set, but TemplateMesh is not");
  }
}

template <typename TLabelImage, typename TMesh>
template <typename TFilter>
double
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::RunStage(TFilter * filter, double from, double to)
{
  const moserhex::Stopwatch stopwatch;
  filter->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  const auto observer = filter->AddObserver(ProgressEvent(), [this, filter, from, to](const EventObject &) {
    this->UpdateProgress(static_cast<float>(from + (to - from) * filter->GetProgress()));
    if (this->GetAbortGenerateData())
    {
      filter->AbortGenerateDataOn();
    }
  });
  try
  {
    filter->Update();
  }
  catch (...)
  {
    filter->RemoveObserver(observer);
    throw;
  }
  filter->RemoveObserver(observer);
  return stopwatch.seconds();
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingResult
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::MeshFrom(moserhex::SolidMeshingOptions options,
                                                                 ShellMethod                   method,
                                                                 const moserhex::LevelSet &    orderedPhi,
                                                                 const moserhex::LevelSet &    phi,
                                                                 moserhex::MeshingStageReport  orderingStage)
{
  typename OrderingFilterType::Pointer ordering = OrderingFilterType::New();
  ordering->SetInput(ImageFromLevelSet<LevelSetImageType>(orderedPhi));
  ordering->SetMethod(method);
  ordering->SetNumberOfShells(moserhex::shellsToExtract(m_Options));
  orderingStage.seconds += this->RunStage(ordering.GetPointer(), afterConditioning, afterOrdering);
  orderingStage.note = orderingStage.note.empty() ? NameOf(method) : NameOf(method) + (", " + orderingStage.note);

  options.volumeFractions = ordering->GetVolumeFractions();
  const moserhex::LevelSet     order = LevelSetFromImage(ordering->GetOutput());
  moserhex::SolidMeshingResult meshed = RunCoreAlgorithm(
    this,
    [&](const moserhex::ProgressCallback & progress) {
      return moserhex::meshSolid(order, orderedPhi, phi, m_LabelVolume, options, progress);
    },
    afterOrdering,
    1.0);
  const std::vector<std::string> & warnings = ordering->GetReport().warnings;
  meshed.warnings.insert(meshed.warnings.begin(), warnings.begin(), warnings.end());
  meshed.stages.insert(meshed.stages.begin(), orderingStage);
  return meshed;
}

template <typename TLabelImage, typename TMesh>
std::optional<moserhex::LevelSet>
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::SimplerSolid(const moserhex::LabelVolume & label,
                                                                     moserhex::Simplification      simplification)
{
  moserhex::ConditioningOptions options =
    moserhex::simplified(simplification, m_ConditioningReport, m_LabelVolume, 2 * m_Options.shells);
  options.threads = this->GetNumberOfWorkUnits();
  const auto stayOrStop = [this](double) {
    this->UpdateProgress(this->GetProgress());
    return !this->GetAbortGenerateData();
  };
  try
  {
    moserhex::ConditionedSolid simpler = moserhex::conditionLabel(label, options, stayOrStop);
    m_SimplerReport = simpler.report;
    m_SimplerReport->repair = m_ConditioningReport.repair;
    m_SimplerReport->borders = m_ConditioningReport.borders;
    if (!moserhex::isFaithful(simplification, *m_SimplerReport, m_ConditioningReport))
    {
      return std::nullopt;
    }
    return std::move(simpler.levelSet);
  }
  catch (const moserhex::InvalidInput &)
  {
    return std::nullopt; // too thin for it
  }
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingOptions
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::OptionsOfRun()
{
  moserhex::SolidMeshingOptions options = m_Options;
  options.threads = this->GetNumberOfWorkUnits();
  options.density = m_LabelDensity ? &m_LabelDensity->density : options.density;
  return options;
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingOptions
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::OptionsWithSimplerSolid(const moserhex::LabelVolume & label)
{
  moserhex::SolidMeshingOptions options = this->OptionsOfRun();
  if (!options.simplerSolid)
  {
    options.simplerSolid = [this, &label](moserhex::Simplification how) { return this->SimplerSolid(label, how); };
  }
  return options;
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingResult
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::MeshFromUsualShells(
  const moserhex::SolidMeshingOptions & options,
  const moserhex::LevelSet &            phi)
{
  moserhex::MeshingStageReport orderingStage{ "shell ordering", 0.0, {}, {} };
  if (moserhex::shellsToExtract(m_Options) == m_Options.shells)
  {
    return this->MeshFrom(options, this->GetShellMethod(), phi, phi, orderingStage);
  }
  const moserhex::Stopwatch   stopwatch;
  const moserhex::CoarseSolid coarse = RunCoreAlgorithm(
    this,
    [&](const moserhex::ProgressCallback &) { return moserhex::coarseSolid(phi, m_LabelVolume); },
    afterConditioning,
    afterConditioning);
  orderingStage.seconds = stopwatch.seconds();
  orderingStage.note = moserhex::describe(coarse);
  return this->MeshFrom(options, this->GetShellMethod(), coarse.levelSet, phi, orderingStage);
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingResult
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::MeshFromBestShells(
  const moserhex::SolidMeshingOptions & options,
  const moserhex::LevelSet &            phi)
{
  std::optional<moserhex::SolidMeshingResult> usual;
  std::string                                 reason;
  try
  {
    usual = this->MeshFromUsualShells(options, phi);
    if (!usual->equalisation || usual->equalisation->exact)
    {
      return std::move(*usual);
    }
    reason = usual->equalisation->shortcomings.front();
  }
  catch (const NotConvergedError & error)
  {
    if (error.GetCode() == moserhex::ErrorCode::Shape)
    {
      throw;
    }
    reason = error.GetDescription();
  }
  try
  {
    moserhex::SolidMeshingResult other =
      this->MeshFrom(this->OptionsOfRun(), ShellMethod::ChanVese, phi, phi, { "shell ordering", 0.0, {}, {} });
    if (!usual || Badness(other) < Badness(*usual))
    {
      other.warnings.push_back("shells from Chan-Vese fronts, as eikonal ones did not do: " + reason);
      return other;
    }
    reason = other.equalisation->shortcomings.front();
  }
  catch (const NotConvergedError & error)
  {
    if (!usual)
    {
      throw;
    }
    reason = error.GetDescription();
  }
  usual->warnings.push_back("shells from Chan-Vese fronts did not do better: " + reason);
  return std::move(*usual);
}

template <typename TLabelImage, typename TMesh>
std::optional<moserhex::OwnMesh>
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::OwnMesh(const moserhex::LevelSet &    phi,
                                                                const moserhex::LabelVolume & label)
{
  moserhex::SolidMeshingOptions options = this->OptionsWithSimplerSolid(label);
  options.templateMesh.reset();
  options.refinement = {};
  options.turnedFrames = 0; // its indices would mean other directions than the template's
  options.density = nullptr;
  options.allowPartial = false;
  try
  {
    moserhex::SolidMeshingResult result = this->MeshFromUsualShells(options, phi);
    return moserhex::OwnMesh{ std::move(result.mesh), std::move(result.simplerSolid) };
  }
  catch (const NotConvergedError &)
  {
    return std::nullopt;
  }
}

template <typename TLabelImage, typename TMesh>
moserhex::SolidMeshingResult
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::MeshOnTemplate(const moserhex::LevelSet &    phi,
                                                                       const moserhex::LabelVolume & label)
{
  moserhex::SolidMeshingOptions options = this->OptionsOfRun();
  options.ownMesh = [this, &phi, &label] { return this->OwnMesh(phi, label); };
  return RunCoreAlgorithm(
    this,
    [&](const moserhex::ProgressCallback & progress) {
      return moserhex::meshOnTemplate(phi, m_LabelVolume, options, progress);
    },
    afterConditioning,
    1.0);
}

template <typename TLabelImage, typename TMesh>
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::PutDensityOnLabel(const moserhex::LabelVolume & label)
{
  m_LabelDensity.reset();
  if (this->GetDensityImage())
  {
    m_LabelDensity = RunCoreAlgorithm(
      this,
      [&](const moserhex::ProgressCallback &) {
        return moserhex::densityOnLabel(
          ScalarVolumeFromImage(this->GetDensityImage()), label, this->GetNumberOfWorkUnits());
      },
      afterConditioning,
      afterConditioning);
  }
}

template <typename TLabelImage, typename TMesh>
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::GenerateData()
{
  // The stages work on a graft of the input, so that their requests do not travel up this filter's own pipeline.
  typename TLabelImage::Pointer label = TLabelImage::New();
  label->Graft(this->GetInput());

  typename ConditioningFilterType::Pointer conditioning = ConditioningFilterType::New();
  conditioning->SetInput(label);
  conditioning->SetLabel(m_Label);
  conditioning->SetNodesPerSide(2 * m_Options.shells);
  conditioning->SetTopologyPolicy(m_TopologyPolicy);
  conditioning->SetMaximumRepair(m_MaximumRepair);
  const double conditioningSeconds = this->RunStage(conditioning.GetPointer(), 0.0, afterConditioning);
  m_ConditioningReport = conditioning->GetReport();
  m_LabelVolume = conditioning->GetLabelVolume();

  const moserhex::LevelSet phi = LevelSetFromImage(conditioning->GetOutput());
  this->PutDensityOnLabel(conditioning->GetRepairedLabel());
  m_SimplerReport.reset();
  if (m_Options.templateMesh)
  {
    m_Result = this->MeshOnTemplate(phi, conditioning->GetRepairedLabel());
  }
  else
  {
    const moserhex::SolidMeshingOptions options = this->OptionsWithSimplerSolid(conditioning->GetRepairedLabel());
    const bool mayChangeShells = !m_ShellMethod && this->GetShellMethod() != ShellMethod::ChanVese;
    m_Result = mayChangeShells ? this->MeshFromBestShells(options, phi) : this->MeshFromUsualShells(options, phi);
  }

  moserhex::MeshingStageReport conditioningStage{ "conditioning", conditioningSeconds, {}, {} };
  if (m_Result.simplerSolid)
  {
    conditioningStage.note = moserhex::describeSimplification(*m_SimplerReport, m_ConditioningReport);
    m_ConditioningReport = *m_SimplerReport;
    if (m_ConditioningReport.dice < noteworthyDice)
    {
      m_Result.warnings.insert(m_Result.warnings.begin(), conditioningStage.note);
    }
  }
  const std::vector<std::string> warnings = moserhex::warningsOf(m_ConditioningReport);
  m_Result.warnings.insert(m_Result.warnings.begin(), warnings.begin(), warnings.end());
  m_Result.stages.insert(m_Result.stages.begin(), conditioningStage);
  CopyHexMeshToItk(m_Result.mesh, this->GetOutput());
}

template <typename TLabelImage, typename TMesh>
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << static_cast<typename NumericTraits<LabelType>::PrintType>(m_Label) << std::endl;
  os << indent << "NumberOfShells: " << m_Options.shells << std::endl;
  os << indent << "TopologyPolicy: " << (m_TopologyPolicy == moserhex::TopologyPolicy::Repair ? "Repair" : "Reject")
     << std::endl;
  os << indent << "MaximumRepair: " << m_MaximumRepair << std::endl;
  os << indent << "LabelVolume: " << m_LabelVolume << std::endl;
  os << indent << "Stages: " << m_Result.stages.size() << std::endl;
}

} // namespace itk

#endif
