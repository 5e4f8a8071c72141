// Closed-form class (1e-12): the Heaviside function and the means are sums written out by hand. Exact class: sign of
// the force, the time step, no global state.
#include "itkWeightedChanVeseFunction.h"

#include <itkConstNeighborhoodIterator.h>
#include <itkImage.h>
#include <itkImageRegionIteratorWithIndex.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using ImageType = itk::Image<double, 3>;
using FunctionType = itk::WeightedChanVeseFunction<ImageType>;

ImageType::Pointer
makeImage(double (*value)(const ImageType::IndexType &))
{
  auto                image = ImageType::New();
  ImageType::SizeType size;
  size.Fill(9);
  image->SetRegions(size);
  image->Allocate();
  itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(value(it.GetIndex()));
  }
  return image;
}

/** Half the box in the organ. */
double
halfBox(const ImageType::IndexType & index)
{
  return index[0] < 5 ? 1.0 : 0.0;
}

double
two(const ImageType::IndexType &)
{
  return 2.0;
}

/** Plane front at index 2. */
double
plane(const ImageType::IndexType & index)
{
  return static_cast<double>(index[0]) - 2.0;
}

struct Setting
{
  ImageType::Pointer    feature{ makeImage(halfBox) };
  ImageType::Pointer    weight{ makeImage(two) };
  ImageType::Pointer    front{ makeImage(plane) };
  FunctionType::Pointer function{ FunctionType::New() };

  Setting()
  {
    function->SetFeatureImage(feature);
    function->SetWeightImage(weight);
    function->UpdateMeans(front);
  }

  itk::ConstNeighborhoodIterator<ImageType>
  at(int i) const
  {
    itk::Size<3> radius;
    radius.Fill(1);
    itk::ConstNeighborhoodIterator<ImageType> it(radius, front, front->GetBufferedRegion());
    it.SetLocation({ { i, 4, 4 } });
    return it;
  }
};

} // namespace

TEST(WeightedChanVeseFunction, HeavisideHasCompactSupportAndIsOneInside)
{
  const auto function = FunctionType::New();
  function->SetHeavisideWidth(1.5);
  for (const double phi : { -9.0, -3.0, -1.5 })
  {
    EXPECT_EQ(function->Heaviside(phi), 1.0);
  }
  for (const double phi : { 1.5, 3.0, 9.0 })
  {
    EXPECT_NEAR(function->Heaviside(phi), 0.0, 1e-16);
  }
  EXPECT_NEAR(function->Heaviside(0.0), 0.5, 1e-15);
  EXPECT_NEAR(function->Heaviside(0.75), 0.25 - 0.5 / itk::Math::pi, 1e-12);
  EXPECT_NEAR(function->Heaviside(0.4) + function->Heaviside(-0.4), 1.0, 1e-12);
}

TEST(WeightedChanVeseFunction, MeansAreThoseOfTheRegularisedSides)
{
  const Setting s;
  // Layers 0..8 with phi = -2..6; H = 1, h, 1/2, 1-h, 0, ...; beta = 1 in layers 0..4.
  const double h = s.function->Heaviside(-1.0);
  const double inside = 1 + h + 0.5 + (1 - h);
  EXPECT_NEAR(s.function->GetMeanInside(), 1.0, 1e-12);
  EXPECT_NEAR(s.function->GetMeanOutside(), (5 - inside) / (9 - inside), 1e-12);
}

TEST(WeightedChanVeseFunction, ForceDrivesTheFrontOutwardsInTheOrganAndInwardsBeyondIt)
{
  const Setting                  s;
  FunctionType::GlobalDataStruct data;
  FunctionType::FloatOffsetType  offset;
  const double                   in = s.function->PropagationSpeed(s.at(2), offset, &data);
  const double                   out = s.function->PropagationSpeed(s.at(6), offset, &data);
  const double                   muOut = s.function->GetMeanOutside();
  EXPECT_NEAR(in, 2.0 * (1 - muOut) * (1 - muOut), 1e-12); // weight 2, mu_in = 1
  EXPECT_NEAR(out, 2.0 * (muOut * muOut - 1), 1e-12);
  EXPECT_NEAR(s.function->CurvatureSpeed(s.at(6), offset, &data), in, 1e-12); // in units of the region force
}

TEST(WeightedChanVeseFunction, TimeStepKeepsTheFrontWithinHalfANode)
{
  const Setting s;
  auto *        data = static_cast<FunctionType::GlobalDataStruct *>(s.function->GetGlobalDataPointer());
  EXPECT_EQ(s.function->ComputeGlobalTimeStep(data), 0.0);
  data->m_MaxPropagationChange = 3.0;
  EXPECT_NEAR(s.function->ComputeGlobalTimeStep(data), 0.15, 1e-12);
  data->m_MaxCurvatureChange = 10.0;
  EXPECT_NEAR(s.function->ComputeGlobalTimeStep(data), 1.0 / 60, 1e-12);
  s.function->ReleaseGlobalDataPointer(data);
}

TEST(WeightedChanVeseFunction, LeavesTheStaticTimeStepOfItkAlone)
{
  const double  before = itk::LevelSetFunction<ImageType>::GetMaximumPropagationTimeStep();
  const Setting s;
  EXPECT_EQ(itk::LevelSetFunction<ImageType>::GetMaximumPropagationTimeStep(), before);
}
