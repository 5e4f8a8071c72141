// The filter converts and forwards: results are compared with the Core function's bit for bit.
#include "itkLabelConditioningImageFilter.h"
#include "itkLabelVolumeConversion.h"
#include "itkLevelSetConversion.h"

#include <itkCommand.h>

#include <gtest/gtest.h>

using LabelImage = itk::Image<unsigned short, 3>;
using Filter = itk::LabelConditioningImageFilter<LabelImage>;

namespace
{

/** An ellipsoid (label 3) and a ring in one plane (label 4) in voxels of 1 x 1 x 3 mm. */
LabelImage::Pointer
labelImage()
{
  const auto           image = LabelImage::New();
  LabelImage::SizeType size{ { 60, 40, 16 } };
  image->SetRegions(size);
  const double spacing[3] = { 1.0, 1.0, 3.0 };
  const double origin[3] = { -30.0, 5.0, 100.0 };
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->Allocate();
  image->FillBuffer(0);
  for (int k = 0; k < 16; ++k)
  {
    for (int j = 0; j < 40; ++j)
    {
      for (int i = 0; i < 60; ++i)
      {
        const double x = (i - 18.0) / 15.0;
        const double y = (j - 20.0) / 13.0;
        const double z = (3.0 * k - 24.0) / 14.0;
        const double ring = std::hypot(i - 46.0, j - 20.0);
        const bool   inRing = k == 8 && ring > 5.0 && ring < 9.0;
        image->SetPixel({ { i, j, k } }, x * x + y * y + z * z < 1.0 ? 3 : (inRing ? 4 : 0));
      }
    }
  }
  return image;
}

Filter::Pointer
filterFor(unsigned short label)
{
  const auto filter = Filter::New();
  filter->SetInput(labelImage());
  filter->SetLabel(label);
  filter->SetNodesPerSide(8);
  return filter;
}

std::string
messageOf(Filter * filter)
{
  try
  {
    filter->Update();
  }
  catch (const itk::InvalidInputError & error)
  {
    return error.GetDescription();
  }
  return "accepted";
}

} // namespace

TEST(LabelConditioningImageFilter, GivesTheResultOfTheCoreFunction)
{
  const auto filter = filterFor(3);
  filter->Update();
  moserhex::ConditioningOptions options;
  options.nodesPerSide = 8;
  const auto expected = moserhex::conditionLabel(itk::LabelVolumeFromImage(labelImage().GetPointer(), 3), options);
  const auto actual = itk::LevelSetFromImage(filter->GetOutput());
  EXPECT_EQ(actual.values, expected.levelSet.values);
  EXPECT_EQ(actual.grid.origin, expected.levelSet.grid.origin);
  EXPECT_EQ(filter->GetLabelVolume(), expected.labelVolume);
  EXPECT_EQ(filter->GetReport().dice, expected.report.dice);
  EXPECT_EQ(filter->GetReport().sliceAxis, 2);
}

TEST(LabelConditioningImageFilter, GeometryIsEmptyBeforeAndKnownAfterTheUpdate)
{
  const auto filter = filterFor(3);
  filter->UpdateOutputInformation();
  EXPECT_EQ(filter->GetOutput()->GetLargestPossibleRegion().GetNumberOfPixels(), 0u);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetLargestPossibleRegion().GetNumberOfPixels(), 1000u);
  EXPECT_EQ(filter->GetOutput()->GetLargestPossibleRegion(), filter->GetOutput()->GetBufferedRegion());
}

TEST(LabelConditioningImageFilter, SecondUpdateDoesNotRunAgain)
{
  const auto filter = filterFor(3);
  filter->Update();
  const auto region = filter->GetOutput()->GetLargestPossibleRegion();
  const auto modified = filter->GetOutput()->GetPixelContainer()->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPixelContainer()->GetMTime(), modified);
  EXPECT_EQ(filter->GetOutput()->GetLargestPossibleRegion(), region);
}

TEST(LabelConditioningImageFilter, NewOptionsGiveANewGrid)
{
  const auto filter = filterFor(3);
  filter->Update();
  filter->SetSpacing(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetSpacing()[0], 2.0);
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion(), filter->GetOutput()->GetLargestPossibleRegion());
}

TEST(LabelConditioningImageFilter, LabelWithAHandleIsRejectedWithItsNumbersWhenToldSo)
{
  const auto filter = filterFor(4);
  EXPECT_EQ(filter->GetTopologyPolicy(), moserhex::TopologyPolicy::Repair);
  filter->SetTopologyPolicy(moserhex::TopologyPolicy::Reject);
  EXPECT_EQ(messageOf(filter), "label 4: 1 handle, V-E+F = 0, need 2 (genus 0)");
}

TEST(LabelConditioningImageFilter, RepairIsReportedAndNotMoreThanAllowed)
{
  const auto image = labelImage();
  image->SetPixel({ { 18, 20, 8 } }, 0); // a cavity
  const auto filter = filterFor(3);
  filter->SetInput(image);
  filter->Update();
  ASSERT_EQ(filter->GetReport().repair.changes.size(), 1u);
  EXPECT_EQ(filter->GetReport().repair.changes[0].kind, moserhex::TopologyChangeKind::CavityFilled);
  EXPECT_LT((filter->GetReport().repair.changes[0].centre - moserhex::Vector3(-12, 25, 124)).norm(), 1e-9);
  EXPECT_EQ(static_cast<double>(moserhex::voxelCount(filter->GetRepairedLabel())) * 3.0, filter->GetLabelVolume());
  filter->SetMaximumRepair(0.0);
  EXPECT_EQ(filter->GetMaximumRepair(), 0.0);
  EXPECT_EQ(messageOf(filter).find("label 3: 1 cavity, V-E+F = 4, need 2 (genus 0); a repair changes >= "), 0u);
}

TEST(LabelConditioningImageFilter, AbsentLabelIsRefusedWithTheLabelsPresent)
{
  EXPECT_EQ(messageOf(filterFor(7)), "label 7 is not in the image; labels present: 3, 4");
}

TEST(LabelConditioningImageFilter, BackgroundAndBadOptionsAreRefused)
{
  EXPECT_THROW(filterFor(0)->Update(), itk::ExceptionObject);
  const auto nodes = filterFor(3);
  nodes->SetNodesPerSide(1);
  EXPECT_THROW(nodes->Update(), itk::ExceptionObject);
  const auto spacing = filterFor(3);
  spacing->SetSpacing(-1.0);
  EXPECT_THROW(spacing->Update(), itk::ExceptionObject);
}

TEST(LabelConditioningImageFilter, ProgressRisesToOneAndAbortStopsTheFilter)
{
  const auto filter = filterFor(3);
  float      last = -1.0F;
  bool       rises = true;
  const auto observer = itk::CStyleCommand::New();
  struct State
  {
    float * last;
    bool *  rises;
  } state{ &last, &rises };
  observer->SetClientData(&state);
  observer->SetCallback([](itk::Object * caller, const itk::EventObject &, void * data) {
    auto *      s = static_cast<State *>(data);
    const float now = static_cast<itk::ProcessObject *>(caller)->GetProgress();
    *s->rises = *s->rises && now >= *s->last;
    *s->last = now;
  });
  filter->AddObserver(itk::ProgressEvent(), observer);
  filter->Update();
  EXPECT_TRUE(rises);
  EXPECT_EQ(last, 1.0F);

  const auto aborted = filterFor(3);
  const auto abort = itk::CStyleCommand::New();
  abort->SetCallback([](itk::Object * caller, const itk::EventObject &, void *) {
    static_cast<itk::ProcessObject *>(caller)->AbortGenerateDataOn();
  });
  aborted->AddObserver(itk::ProgressEvent(), abort);
  EXPECT_THROW(aborted->Update(), itk::ProcessAborted);
}
