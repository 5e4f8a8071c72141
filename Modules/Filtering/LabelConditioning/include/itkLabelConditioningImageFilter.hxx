#ifndef itkLabelConditioningImageFilter_hxx
#define itkLabelConditioningImageFilter_hxx

#include "itkLabelConditioningImageFilter.h"
#include "itkLabelVolumeConversion.h"
#include "itkLevelSetConversion.h"

#include <sstream>
#include <utility>

namespace itk
{

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (m_Label == NumericTraits<LabelType>::ZeroValue())
  {
    itkExceptionMacro("Label is 0, the background; set the value of the label");
  }
  if (m_Options.nodesPerSide < 2)
  {
    itkExceptionMacro("NodesPerSide is " << m_Options.nodesPerSide << ", need at least 2");
  }
  if (!(m_Options.spacing >= 0.0))
  {
    itkExceptionMacro("Spacing is " << m_Options.spacing << " mm, need >= 0");
  }
}

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::GenerateOutputInformation()
{
  TOutputImage * output = this->GetOutput();
  if (output != nullptr)
  {
    output->SetLargestPossibleRegion(typename TOutputImage::RegionType{});
  }
}

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::GenerateInputRequestedRegion()
{
  auto * input = const_cast<TLabelImage *>(this->GetInput());
  if (input != nullptr)
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  Superclass::EnlargeOutputRequestedRegion(output);
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::GenerateData()
{
  const TLabelImage *        input = this->GetInput();
  moserhex::ConditionedSolid solid = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
    std::ostringstream name;
    name << "label " << static_cast<typename NumericTraits<LabelType>::PrintType>(m_Label);
    moserhex::ConditioningOptions options = m_Options;
    options.labelName = name.str();
    options.threads = this->GetNumberOfWorkUnits();
    return moserhex::conditionLabel(LabelVolumeFromImage(input, m_Label), options, progress);
  });
  m_Report = solid.report;
  m_RepairedLabel = std::move(solid.label);
  m_LabelVolume = solid.labelVolume;

  const typename TOutputImage::Pointer image = ImageFromLevelSet<TOutputImage>(solid.levelSet);
  this->GraftOutput(image);
}

template <typename TLabelImage, typename TOutputImage>
void
LabelConditioningImageFilter<TLabelImage, TOutputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << static_cast<typename NumericTraits<LabelType>::PrintType>(m_Label) << std::endl;
  os << indent << "NodesPerSide: " << m_Options.nodesPerSide << std::endl;
  os << indent << "Spacing: " << m_Options.spacing << std::endl;
  os << indent << "Smoothing: " << m_Options.smoothing << std::endl;
  os << indent << "SliceAnisotropy: " << m_Options.sliceAnisotropy << std::endl;
  os << indent << "MinimumDice: " << m_Options.minimumDice << std::endl;
  os << indent << "TopologyPolicy: " << (m_Options.topology == moserhex::TopologyPolicy::Repair ? "Repair" : "Reject")
     << std::endl;
  os << indent << "MaximumRepair: " << m_Options.maximumRepair << std::endl;
  os << indent << "LabelVolume: " << m_LabelVolume << std::endl;
}

} // namespace itk

#endif
