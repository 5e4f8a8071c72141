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
  if (m_DensityImage && m_Options.lastStage != moserhex::MeshingStage::Exact)
  {
    itkExceptionMacro("DensityImage is set, but the last stage is not Exact");
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
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::GenerateData()
{
  constexpr double afterConditioning = 0.15;
  constexpr double afterOrdering = 0.3;

  // The stages work on a graft of the input, so that their requests do not travel up this filter's own pipeline.
  typename TLabelImage::Pointer label = TLabelImage::New();
  label->Graft(this->GetInput());

  typename ConditioningFilterType::Pointer conditioning = ConditioningFilterType::New();
  conditioning->SetInput(label);
  conditioning->SetLabel(m_Label);
  conditioning->SetNodesPerSide(2 * m_Options.shells);
  const double conditioningSeconds = this->RunStage(conditioning.GetPointer(), 0.0, afterConditioning);
  m_ConditioningReport = conditioning->GetReport();
  m_LabelVolume = conditioning->GetLabelVolume();

  const moserhex::LevelSet     phi = LevelSetFromImage(conditioning->GetOutput());
  moserhex::MeshingStageReport orderingStage{ "shell ordering", 0.0, {}, {} };
  const auto                   meshFrom = [&](ShellMethod method, const moserhex::LevelSet & orderedPhi) {
    typename OrderingFilterType::Pointer ordering = OrderingFilterType::New();
    ordering->SetInput(ImageFromLevelSet<LevelSetImageType>(orderedPhi));
    ordering->SetMethod(method);
    ordering->SetNumberOfShells(moserhex::shellsToExtract(m_Options));
    orderingStage.seconds += this->RunStage(ordering.GetPointer(), afterConditioning, afterOrdering);
    orderingStage.note = orderingStage.note.empty() ? NameOf(method) : NameOf(method) + (", " + orderingStage.note);

    moserhex::SolidMeshingOptions options = m_Options;
    options.threads = this->GetNumberOfWorkUnits();
    options.volumeFractions = ordering->GetVolumeFractions();
    const moserhex::LevelSet order = LevelSetFromImage(ordering->GetOutput());
    m_Result = RunCoreAlgorithm(
      this,
      [&](const moserhex::ProgressCallback & progress) {
        std::optional<moserhex::LabelDensity> onLabel;
        if (m_DensityImage)
        {
          onLabel = moserhex::densityOnLabel(ScalarVolumeFromImage(m_DensityImage.GetPointer()),
                                             LabelVolumeFromImage(label.GetPointer(), m_Label),
                                             options.threads);
          options.density = &onLabel->density;
        }
        moserhex::SolidMeshingResult result =
          moserhex::meshSolid(order, orderedPhi, phi, m_LabelVolume, options, progress);
        if (onLabel)
        {
          result.warnings.insert(result.warnings.begin(), onLabel->warnings.begin(), onLabel->warnings.end());
        }
        return result;
      },
      afterOrdering,
      1.0);
    const std::vector<std::string> & warnings = ordering->GetReport().warnings;
    m_Result.warnings.insert(m_Result.warnings.begin(), warnings.begin(), warnings.end());
  };
  try
  {
    if (moserhex::shellsToExtract(m_Options) < m_Options.shells)
    {
      const moserhex::Stopwatch   stopwatch;
      const moserhex::CoarseSolid coarse = RunCoreAlgorithm(
        this,
        [&](const moserhex::ProgressCallback &) { return moserhex::coarseSolid(phi, m_LabelVolume); },
        afterConditioning,
        afterConditioning);
      orderingStage.seconds = stopwatch.seconds();
      orderingStage.note = moserhex::describe(coarse);
      meshFrom(this->GetShellMethod(), coarse.levelSet);
    }
    else
    {
      meshFrom(this->GetShellMethod(), phi);
    }
  }
  catch (const NotConvergedError & error)
  {
    if (m_ShellMethod || this->GetShellMethod() == ShellMethod::ChanVese)
    {
      throw;
    }
    const std::string reason = error.GetDescription();
    orderingStage = { "shell ordering", 0.0, {}, {} };
    meshFrom(ShellMethod::ChanVese, phi);
    m_Result.warnings.push_back("shells from Chan-Vese fronts, as eikonal ones did not do: " + reason);
  }

  const std::vector<std::string> warnings = moserhex::warningsOf(m_ConditioningReport);
  m_Result.warnings.insert(m_Result.warnings.begin(), warnings.begin(), warnings.end());
  const moserhex::MeshingStageReport first[2] = { { "conditioning", conditioningSeconds, {}, {} }, orderingStage };
  m_Result.stages.insert(m_Result.stages.begin(), first, first + 2);
  CopyHexMeshToItk(m_Result.mesh, this->GetOutput());
}

template <typename TLabelImage, typename TMesh>
void
MassPreservingHexahedralMeshFilter<TLabelImage, TMesh>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << static_cast<typename NumericTraits<LabelType>::PrintType>(m_Label) << std::endl;
  os << indent << "NumberOfShells: " << m_Options.shells << std::endl;
  os << indent << "LabelVolume: " << m_LabelVolume << std::endl;
  os << indent << "Stages: " << m_Result.stages.size() << std::endl;
}

} // namespace itk

#endif
