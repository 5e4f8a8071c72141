#ifndef itkWeightedChanVeseFunction_hxx
#define itkWeightedChanVeseFunction_hxx

#include "itkWeightedChanVeseFunction.h"

#include <itkImageRegionConstIterator.h>
#include <itkMath.h>

#include <algorithm>
#include <cmath>

namespace itk
{

template <typename TImage>
WeightedChanVeseFunction<TImage>::WeightedChanVeseFunction()
{
  RadiusType radius;
  radius.Fill(1);
  this->Initialize(radius);
  this->SetAdvectionWeight(0);
  this->SetPropagationWeight(1);
}

template <typename TImage>
double
WeightedChanVeseFunction<TImage>::Heaviside(double phi) const
{
  const double x = std::min(std::max(-phi / m_HeavisideWidth, -1.0), 1.0);
  return 0.5 * (1.0 + x + std::sin(Math::pi * x) / Math::pi);
}

template <typename TImage>
void
WeightedChanVeseFunction<TImage>::UpdateMeans(const ImageType * levelSet)
{
  double sizeInside = 0.0;
  double betaInside = 0.0;
  double betaInAll = 0.0;
  double sizeOfAll = 0.0;

  const auto                          region = levelSet->GetRequestedRegion();
  ImageRegionConstIterator<ImageType> phi(levelSet, region);
  ImageRegionConstIterator<ImageType> beta(m_FeatureImage, region);
  for (; !phi.IsAtEnd(); ++phi, ++beta)
  {
    sizeOfAll += 1.0;
    betaInAll += beta.Get();
    if (phi.Get() < m_HeavisideWidth)
    {
      const double inside = phi.Get() <= -m_HeavisideWidth ? 1.0 : this->Heaviside(phi.Get());
      sizeInside += inside;
      betaInside += inside * beta.Get();
    }
  }
  m_MeanInside = sizeInside > 0.0 ? betaInside / sizeInside : 0.0;
  m_MeanOutside = sizeOfAll > sizeInside ? (betaInAll - betaInside) / (sizeOfAll - sizeInside) : 0.0;
}

template <typename TImage>
double
WeightedChanVeseFunction<TImage>::RegionForce(double beta) const
{
  const double fromOutside = beta - m_MeanOutside;
  const double fromInside = beta - m_MeanInside;
  return fromOutside * fromOutside - fromInside * fromInside;
}

template <typename TImage>
auto
WeightedChanVeseFunction<TImage>::PropagationSpeed(const NeighborhoodType & neighborhood,
                                                   const FloatOffsetType &,
                                                   GlobalDataStruct *) const -> ScalarValueType
{
  const auto   index = neighborhood.GetIndex();
  const double beta = m_FeatureImage->GetPixel(index);
  return static_cast<ScalarValueType>(m_WeightImage->GetPixel(index) * this->RegionForce(beta));
}

template <typename TImage>
auto
WeightedChanVeseFunction<TImage>::CurvatureSpeed(const NeighborhoodType & neighborhood,
                                                 const FloatOffsetType &,
                                                 GlobalDataStruct *) const -> ScalarValueType
{
  return static_cast<ScalarValueType>(m_WeightImage->GetPixel(neighborhood.GetIndex()) * this->RegionForce(1.0));
}

template <typename TImage>
auto
WeightedChanVeseFunction<TImage>::ComputeGlobalTimeStep(void * globalData) const -> TimeStepType
{
  constexpr double largestPropagation = 0.45;
  constexpr double largestCurvature = 1.0 / (2.0 * Superclass::ImageDimension);

  const auto * data = static_cast<const GlobalDataStruct *>(globalData);
  const double propagation = data->m_MaxPropagationChange;
  const double curvature = std::abs(static_cast<double>(data->m_MaxCurvatureChange));
  if (!(propagation > 0.0))
  {
    return curvature > 0.0 ? largestCurvature / curvature : 0.0;
  }
  const double step = largestPropagation / propagation;
  return curvature > 0.0 ? std::min(step, largestCurvature / curvature) : step;
}

template <typename TImage>
void
WeightedChanVeseFunction<TImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "HeavisideWidth: " << m_HeavisideWidth << std::endl;
  os << indent << "MeanInside: " << m_MeanInside << std::endl;
  os << indent << "MeanOutside: " << m_MeanOutside << std::endl;
  itkPrintSelfObjectMacro(FeatureImage);
  itkPrintSelfObjectMacro(WeightImage);
}

} // namespace itk

#endif
