#ifndef itkChanVeseArrivalImageFilter_hxx
#define itkChanVeseArrivalImageFilter_hxx

#include "itkChanVeseArrivalImageFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{

template <typename TImage>
ChanVeseArrivalImageFilter<TImage>::ChanVeseArrivalImageFilter()
{
  this->AddRequiredInputName("FeatureImage");
  this->AddRequiredInputName("WeightImage");
  m_Function = FunctionType::New();
  this->SetDifferenceFunction(m_Function);
  this->SetUseImageSpacing(false); // lengths in nodes
  this->SetIsoSurfaceValue(0);
  this->SetNumberOfLayers(2); // what curvature needs
  this->SetInterpolateSurfaceLocation(false);
  this->SetNumberOfIterations(1500);
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  if (!(m_ReachedFraction > 0.0 && m_ReachedFraction <= 1.0))
  {
    itkExceptionMacro("ReachedFraction = " << m_ReachedFraction << ", need (0,1]");
  }
  if (!(m_CurvatureWeight >= 0.0) || !(m_HeavisideWidth > 0.0))
  {
    itkExceptionMacro("CurvatureWeight = " << m_CurvatureWeight << " (need >= 0), HeavisideWidth = " << m_HeavisideWidth
                                           << " (need > 0)");
  }
  if (m_StallIterations < 1 || this->GetNumberOfIterations() < 1)
  {
    itkExceptionMacro("StallIterations = " << m_StallIterations << " (need >= 1), NumberOfIterations = "
                                           << this->GetNumberOfIterations() << " (need >= 1)");
  }
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::Initialize()
{
  Superclass::Initialize();
  m_Function->SetFeatureImage(this->GetFeatureImage());
  m_Function->SetWeightImage(this->GetWeightImage());
  m_Function->SetHeavisideWidth(m_HeavisideWidth);
  m_Function->SetCurvatureWeight(static_cast<PixelType>(m_CurvatureWeight));

  const ImageType * feature = this->GetFeatureImage();
  const PixelType * beta = feature->GetBufferPointer();
  const auto        count = feature->GetBufferedRegion().GetNumberOfPixels();
  m_FeatureCount = static_cast<SizeValueType>(std::count_if(beta, beta + count, [](PixelType b) { return b > 0.5; }));
  if (m_FeatureCount == 0)
  {
    itkExceptionMacro("the feature image has 0 pixels with a value above 0.5, need at least 1");
  }
  m_Previous.clear();
  m_Time = 0.0;
  m_TimeStep = 0.0;
  m_LargestCount = 0;
  m_IterationsWithoutGrowth = 0;
  m_Converged = false;
  m_PassedFraction = 0.0;
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::RecordArrivals()
{
  const PixelType * phi = this->GetOutput()->GetBufferPointer();
  const PixelType * beta = this->GetFeatureImage()->GetBufferPointer();
  const auto        count = this->GetOutput()->GetBufferedRegion().GetNumberOfPixels();
  const bool        first = m_Previous.empty();
  if (first)
  {
    m_Arrival.assign(count, std::numeric_limits<PixelType>::infinity());
    m_Previous.assign(phi, phi + count);
  }
  SizeValueType inside = 0;
  for (SizeValueType pixel = 0; pixel < count; ++pixel)
  {
    if (phi[pixel] < 0)
    {
      inside += beta[pixel] > 0.5 ? 1 : 0;
      if (m_Arrival[pixel] == std::numeric_limits<PixelType>::infinity())
      {
        const double before = m_Previous[pixel];
        const double part = before > 0 ? before / (before - phi[pixel]) : 0.0;
        m_Arrival[pixel] = first ? phi[pixel] : static_cast<PixelType>(m_Time + part * m_TimeStep);
      }
    }
    m_Previous[pixel] = phi[pixel];
  }
  m_Time += m_TimeStep;
  m_IterationsWithoutGrowth = inside > m_LargestCount ? 0 : m_IterationsWithoutGrowth + 1;
  m_LargestCount = std::max(m_LargestCount, inside);
  m_PassedFraction = static_cast<double>(inside) / static_cast<double>(m_FeatureCount);
  m_Converged = m_PassedFraction >= m_ReachedFraction;
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::InitializeIteration()
{
  Superclass::InitializeIteration();
  this->RecordArrivals();
  m_Function->UpdateMeans(this->GetOutput());
}

template <typename TImage>
auto
ChanVeseArrivalImageFilter<TImage>::CalculateChange() -> TimeStepType
{
  m_TimeStep = Superclass::CalculateChange();
  return m_TimeStep;
}

template <typename TImage>
bool
ChanVeseArrivalImageFilter<TImage>::Halt()
{
  this->UpdateProgress(static_cast<float>(std::min(1.0, m_PassedFraction / m_ReachedFraction)));
  return m_Converged || m_IterationsWithoutGrowth >= m_StallIterations ||
         this->GetElapsedIterations() >= this->GetNumberOfIterations();
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::PostProcessOutput()
{
  this->RecordArrivals(); // the last step
  m_MeanInside = m_Function->GetMeanInside();
  m_MeanOutside = m_Function->GetMeanOutside();
  std::copy(m_Arrival.begin(), m_Arrival.end(), this->GetOutput()->GetBufferPointer());
  std::vector<PixelType>().swap(m_Arrival);
  std::vector<PixelType>().swap(m_Previous);
}

template <typename TImage>
void
ChanVeseArrivalImageFilter<TImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureWeight: " << m_CurvatureWeight << std::endl;
  os << indent << "HeavisideWidth: " << m_HeavisideWidth << std::endl;
  os << indent << "ReachedFraction: " << m_ReachedFraction << std::endl;
  os << indent << "StallIterations: " << m_StallIterations << std::endl;
  os << indent << "Converged: " << m_Converged << std::endl;
  os << indent << "PassedFraction: " << m_PassedFraction << std::endl;
}

} // namespace itk

#endif
