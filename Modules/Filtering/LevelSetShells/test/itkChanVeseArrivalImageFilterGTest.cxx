// Closed-form class: without curvature and with w = 1 a front in a large ball moves at nearly one node per unit of time
// times the region force (within 10 %). Exact class: refusals, determinism, abort.
#include "itkChanVeseArrivalImageFilter.h"

#include <itkCommand.h>
#include <itkImage.h>
#include <itkImageRegionIteratorWithIndex.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using ImageType = itk::Image<double, 3>;
using FilterType = itk::ChanVeseArrivalImageFilter<ImageType>;

constexpr int size = 41;
constexpr int middle = 20;

double
radiusOf(const ImageType::IndexType & index)
{
  return std::sqrt(std::pow(index[0] - middle, 2) + std::pow(index[1] - middle, 2) + std::pow(index[2] - middle, 2));
}

ImageType::Pointer
makeImage(const std::function<double(const ImageType::IndexType &)> & value)
{
  auto                image = ImageType::New();
  ImageType::SizeType sizes;
  sizes.Fill(size);
  image->SetRegions(sizes);
  image->Allocate();
  itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(value(it.GetIndex()));
  }
  return image;
}

/** Front from the middle of a ball of the given radius. */
FilterType::Pointer
ballFilter(double radius, double weight = 1.0)
{
  auto filter = FilterType::New();
  filter->SetInput(makeImage([](const auto & index) { return radiusOf(index) - 1.2; }));
  filter->SetFeatureImage(makeImage([=](const auto & index) { return radiusOf(index) < radius ? 1.0 : 0.0; }));
  filter->SetWeightImage(makeImage([=](const auto &) { return weight; }));
  filter->SetCurvatureWeight(0.0);
  return filter;
}

} // namespace

TEST(ChanVeseArrival, FrontPassesTheBallAndStopsAtItsSurface)
{
  const auto filter = ballFilter(15);
  filter->SetReachedFraction(0.97);
  filter->Update();
  EXPECT_TRUE(filter->GetConverged());
  EXPECT_GE(filter->GetPassedFraction(), 0.97);
  EXPECT_GT(filter->GetMeanInside(), 0.95);
  EXPECT_LT(filter->GetMeanOutside(), 0.05);
  const ImageType * arrival = filter->GetOutput();
  EXPECT_TRUE(std::isfinite(arrival->GetPixel({ { middle + 13, middle, middle } })));
  EXPECT_TRUE(std::isinf(arrival->GetPixel({ { middle + 18, middle, middle } })));
}

TEST(ChanVeseArrival, SpeedIsTheRegionForceTimesTheWeight)
{
  // mu_in = 1 and mu_out falls from 0.19 towards 0, so the force lies between (1 - 0.2)^2 and 1.
  const auto slow = ballFilter(15, 0.5);
  slow->SetReachedFraction(0.9);
  slow->Update();
  for (const int r : { 6, 9, 12 })
  {
    const double time = slow->GetOutput()->GetPixel({ { middle + r, middle, middle } });
    EXPECT_GT(time, (r - 1.2) / 0.5 * 0.95);
    EXPECT_LT(time, (r - 1.2) / 0.5 / 0.64 * 1.05);
  }
}

TEST(ChanVeseArrival, TimesAreNegativeInTheFirstFrontAndGrowOutwards)
{
  const auto filter = ballFilter(15);
  filter->Update();
  double before = filter->GetOutput()->GetPixel({ { middle, middle, middle } });
  EXPECT_LT(before, 0.0);
  for (int r = 1; r < 14; ++r)
  {
    const double time = filter->GetOutput()->GetPixel({ { middle + r, middle, middle } });
    EXPECT_GT(time, before) << "radius " << r;
    before = time;
  }
}

TEST(ChanVeseArrival, StallIsReportedNotSilent)
{
  const auto filter = ballFilter(15);
  filter->SetFeatureImage(makeImage([](const auto & index) { // a second ball that the front cannot reach
    const double away =
      std::sqrt(std::pow(index[0] - 33, 2) + std::pow(index[1] - middle, 2) + std::pow(index[2] - middle, 2));
    return radiusOf(index) < 7 || away < 4 ? 1.0 : 0.0;
  }));
  filter->SetReachedFraction(0.99);
  filter->SetStallIterations(20);
  filter->Update();
  EXPECT_FALSE(filter->GetConverged());
  EXPECT_LT(filter->GetPassedFraction(), 0.95);
  EXPECT_LT(filter->GetElapsedIterations(), 300u);
}

TEST(ChanVeseArrival, IterationLimitIsReportedNotSilent)
{
  const auto filter = ballFilter(15);
  filter->SetNumberOfIterations(5);
  filter->Update();
  EXPECT_FALSE(filter->GetConverged());
  EXPECT_EQ(filter->GetElapsedIterations(), 5u);
}

TEST(ChanVeseArrival, IsTheSameForAnyNumberOfThreadsAndInASecondRun)
{
  const auto first = ballFilter(12);
  first->SetNumberOfWorkUnits(1);
  first->Update();
  const auto second = ballFilter(12);
  second->SetNumberOfWorkUnits(2);
  second->Update();
  second->Modified();
  second->Update();
  const auto count = static_cast<std::size_t>(first->GetOutput()->GetBufferedRegion().GetNumberOfPixels());
  for (std::size_t i = 0; i < count; ++i)
  {
    ASSERT_EQ(first->GetOutput()->GetBufferPointer()[i], second->GetOutput()->GetBufferPointer()[i]);
  }
}

TEST(ChanVeseArrival, ImageSpacingDoesNotMatter)
{
  const auto first = ballFilter(10);
  first->Update();
  const auto   second = ballFilter(10);
  const double spacing[3] = { 0.3, 0.3, 0.3 };
  for (const ImageType * image : { second->GetInput(), second->GetFeatureImage(), second->GetWeightImage() })
  {
    const_cast<ImageType *>(image)->SetSpacing(spacing);
  }
  second->Update();
  EXPECT_EQ(first->GetOutput()->GetPixel({ { middle + 7, middle, middle } }),
            second->GetOutput()->GetPixel({ { middle + 7, middle, middle } }));
}

TEST(ChanVeseArrival, MissingInputsAndWrongOptionsAreRefused)
{
  const auto missing = FilterType::New();
  missing->SetInput(makeImage([](const auto & index) { return radiusOf(index) - 1.2; }));
  EXPECT_THROW(missing->Update(), itk::ExceptionObject);
  const auto refused = [](auto change) {
    const auto filter = ballFilter(10);
    change(filter.GetPointer());
    EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  };
  refused([](FilterType * f) { f->SetReachedFraction(0.0); });
  refused([](FilterType * f) { f->SetReachedFraction(1.5); });
  refused([](FilterType * f) { f->SetCurvatureWeight(-1.0); });
  refused([](FilterType * f) { f->SetHeavisideWidth(0.0); });
  refused([](FilterType * f) { f->SetStallIterations(0); });
  refused([](FilterType * f) { f->SetNumberOfIterations(0); });
  refused([](FilterType * f) { f->SetFeatureImage(makeImage([](const auto &) { return 0.0; })); });
}

TEST(ChanVeseArrival, CallerCanAbort)
{
  const auto filter = ballFilter(15);
  filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    if (filter->GetElapsedIterations() > 3)
    {
      filter->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}
