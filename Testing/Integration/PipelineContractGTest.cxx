// Exact: bytes, counts and kinds of errors.
#include "PipelineRun.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <itkCommand.h>

#include <gtest/gtest.h>

#include <optional>
#include <tuple>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

PipelineOptions
small(unsigned int threads = 2)
{
  PipelineOptions options;
  options.shells = 4;
  options.threads = threads;
  return options;
}

ShortImage::Pointer
ballImage()
{
  return labelImage(analytic::labelVolume(analytic::ball(12.0)));
}

/** A density on the grid of an image, of 1 everywhere. */
Pipeline::DensityImageType::Pointer
unitDensity(const ShortImage & grid)
{
  auto density = Pipeline::DensityImageType::New();
  density->CopyInformation(&grid);
  density->SetRegions(grid.GetLargestPossibleRegion());
  density->Allocate();
  density->FillBuffer(1.0);
  return density;
}

/** What is run without repair and turned frames, so that a tolerance changes nothing but what is called exact. */
SolidMeshingOptions
unrepaired(double surfaceTolerance, bool allowPartial)
{
  SolidMeshingOptions options;
  options.shells = 4;
  options.turnedFrames = 0;
  options.equalisation.repairRounds = 0;
  options.equalisation.surfaceTolerance = surfaceTolerance;
  options.allowPartial = allowPartial;
  options.simplerSolid = [](Simplification) { return std::nullopt; };
  return options;
}

Pipeline::Pointer
runWith(const ShortImage * image, const SolidMeshingOptions & options, std::optional<Pipeline::ShellMethod> method = {})
{
  auto pipeline = Pipeline::New();
  pipeline->SetInput(image);
  pipeline->SetMeshingOptions(options);
  if (method)
  {
    pipeline->SetShellMethod(*method);
  }
  pipeline->Update();
  return pipeline;
}

/** The order in which meshes that are not exact are kept. */
auto
badness(const Pipeline & pipeline)
{
  const EqualisationResult & result = *pipeline.GetResult().equalisation;
  return std::make_tuple(result.concaveCells, result.uncertifiedCells, result.largestDistance);
}

/** A ball with a tunnel of that radius along z [voxels]. */
ShortImage::Pointer
ballWithTunnel(double radius)
{
  LabelVolume label = analytic::labelVolume(analytic::ball(12.0));
  for (int k = 0; k < label.size[2]; ++k)
  {
    for (int j = 0; j < label.size[1]; ++j)
    {
      for (int i = 0; i < label.size[0]; ++i)
      {
        const double x = i - 0.5 * (label.size[0] - 1);
        const double y = j - 0.5 * (label.size[1] - 1);
        if (x * x + y * y < radius * radius)
        {
          label.inside[label.voxelNumber(i, j, k)] = 0;
        }
      }
    }
  }
  return labelImage(label);
}

} // namespace

TEST(PipelineContract, TheResultIsTheSameForAnyNumberOfThreads)
{
  const auto image = labelImage(analytic::labelVolume(analytic::bumpyBall(14.0)));
  for (const MeshingStage stage : { MeshingStage::Moser, MeshingStage::Exact })
  {
    PipelineOptions options = small(1);
    options.lastStage = stage;
    const HexMesh one = runPipeline(image, options)->GetHexMesh();
    for (const unsigned int threads : { 2u, 3u })
    {
      options.threads = threads;
      const HexMesh other = runPipeline(image, options)->GetHexMesh();
      ASSERT_EQ(one.nodes.size(), other.nodes.size());
      for (std::size_t node = 0; node < one.nodes.size(); ++node)
      {
        ASSERT_EQ(one.nodes[node], other.nodes[node]) << "node " << node << ", " << threads << " threads";
      }
    }
  }
}

TEST(PipelineContract, OutputIsTheLatticeWithItsData)
{
  const auto   pipeline = runPipeline(ballImage(), small());
  const auto * mesh = pipeline->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 512u);
  ASSERT_EQ(mesh->GetNumberOfCells(), 343u);
  EXPECT_NO_THROW((void)itk::HexMeshFromItk(mesh));

  itk::LatticePointData point;
  ASSERT_TRUE(mesh->GetPointData()->GetElementIfIndexExists(3 + 8 * (5 + 8 * 7), &point));
  EXPECT_EQ(point[0], 3);
  EXPECT_EQ(point[1], 5);
  EXPECT_EQ(point[2], 7);
  EXPECT_EQ(point[3], 4);

  double sum = 0.0;
  for (itk::IdentifierType cell = 0; cell < 343; ++cell)
  {
    sum += mesh->GetCellData()->ElementAt(cell)[1];
  }
  EXPECT_NEAR(sum / 343, 1.0, 1e-12);
  EXPECT_EQ(mesh->GetCellData()->ElementAt(171)[0], 1); // the middle cell
}

TEST(PipelineContract, EarlierStagesStopTheChain)
{
  PipelineOptions options = small();
  options.lastStage = MeshingStage::Initial;
  const auto initial = runPipeline(ballImage(), options);
  EXPECT_EQ(initial->GetStages().back().name, "initial map");
  options.lastStage = MeshingStage::Smoothed;
  const auto smoothed = runPipeline(ballImage(), options);
  EXPECT_EQ(smoothed->GetStages().back().name, "smoothing");
  EXPECT_EQ(qualityAfter(*smoothed, "initial map").volumeVariance,
            qualityAfter(*initial, "initial map").volumeVariance);
}

TEST(PipelineContract, EveryShellMethodGivesAMesh)
{
  for (const auto method :
       { Pipeline::ShellMethod::ChanVese, Pipeline::ShellMethod::Snapshots, Pipeline::ShellMethod::Eikonal })
  {
    PipelineOptions options = small();
    options.method = method;
    const auto pipeline = runPipeline(ballImage(), options);
    EXPECT_EQ(pipeline->GetHexMesh().nodes.size(), 512u);
  }
}

TEST(PipelineContract, ATunnelIsRejectedWithItsNumbersWhenToldSo)
{
  auto       pipeline = Pipeline::New();
  const auto image = ballWithTunnel(4.0);
  pipeline->SetInput(image);
  pipeline->SetMeshingOptions(unrepaired(0.5, false));
  EXPECT_EQ(pipeline->GetTopologyPolicy(), TopologyPolicy::Repair);
  pipeline->SetTopologyPolicy(TopologyPolicy::Reject);
  try
  {
    pipeline->Update();
    FAIL() << "a tunnel was accepted";
  }
  catch (const itk::InvalidInputError & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find("1 handle, V-E+F = 0, need 2"), std::string::npos)
      << error.GetDescription();
  }
  pipeline->SetTopologyPolicy(TopologyPolicy::Repair);
  pipeline->SetMaximumRepair(0.001);
  EXPECT_EQ(pipeline->GetMaximumRepair(), 0.001);
  EXPECT_THROW(pipeline->Update(), itk::InvalidInputError);
}

TEST(PipelineContract, ATunnelIsRepairedAndReported)
{
  const auto   pipeline = runPipeline(ballWithTunnel(0.8), small());
  const auto & repair = pipeline->GetConditioningReport().repair;
  ASSERT_EQ(repair.changes.size(), 1u);
  EXPECT_EQ(repair.changes[0].kind, TopologyChangeKind::TunnelFilled);
  EXPECT_EQ(repair.before.handles(), 1);
  EXPECT_EQ(pipeline->GetResult().warnings.front().find("1 tunnel filled: "), 0u);
}

TEST(PipelineContract, AnAbsentLabelIsRefused)
{
  PipelineOptions options = small();
  options.label = 7;
  EXPECT_THROW((void)runPipeline(ballImage(), options), itk::InvalidInputError);
}

TEST(PipelineContract, TooFewShellsAreRefused)
{
  PipelineOptions options = small();
  options.shells = 1;
  EXPECT_THROW((void)runPipeline(ballImage(), options), itk::ExceptionObject);
}

TEST(PipelineContract, AbortStopsTheRunFromEveryStage)
{
  const auto image = ballImage();
  for (const double when : { 0.05, 0.2, 0.35, 0.82 })
  {
    auto pipeline = Pipeline::New();
    pipeline->SetInput(image);
    pipeline->SetNumberOfShells(4);
    Pipeline * raw = pipeline.GetPointer();
    pipeline->AddObserver(itk::ProgressEvent(), [raw, when](const itk::EventObject &) {
      if (raw->GetProgress() >= when)
      {
        raw->AbortGenerateDataOn();
      }
    });
    EXPECT_THROW(pipeline->Update(), itk::ProcessAborted) << "at " << when;
  }
}

TEST(PipelineContract, ProgressGrowsToOne)
{
  auto pipeline = Pipeline::New();
  pipeline->SetInput(ballImage());
  pipeline->SetNumberOfShells(4);
  Pipeline *  raw = pipeline.GetPointer();
  float       last = 0.0F;
  std::size_t events = 0;
  pipeline->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    EXPECT_GE(raw->GetProgress(), last);
    last = raw->GetProgress();
    ++events;
  });
  pipeline->Update();
  EXPECT_EQ(last, 1.0F);
  EXPECT_GE(events, 10u);
}

TEST(PipelineContract, ADensityThatWasModifiedIsUsedAnew)
{
  const auto image = ballImage();
  const auto density = unitDensity(*image);
  auto       pipeline = Pipeline::New();
  pipeline->SetInput(image);
  pipeline->SetNumberOfShells(2);
  pipeline->SetShellMethod(Pipeline::ShellMethod::Eikonal);
  pipeline->SetAllowPartial(true);
  pipeline->SetDensityImage(density);
  pipeline->Update();
  ASSERT_TRUE(pipeline->GetLabelDensity());
  EXPECT_NEAR(pipeline->GetLabelDensity()->meanDensity, 1.0, 1e-12);
  density->FillBuffer(3.0);
  density->Modified();
  pipeline->Update();
  EXPECT_NEAR(pipeline->GetLabelDensity()->meanDensity, 3.0, 1e-12);
  pipeline->SetDensityImage(nullptr);
  pipeline->Update();
  EXPECT_FALSE(pipeline->GetLabelDensity());
}

TEST(PipelineContract, AllowPartialNeverTakesAnExactMeshAway)
{
  // Tolerances below what eikonal shells lead to: they do not do, and Chan-Vese shells may or may not.
  std::size_t exact = 0;
  std::size_t partial = 0;
  for (const analytic::Solid & solid : { analytic::bumpyBall(14.0),
                                         analytic::ball(12.0),
                                         analytic::ellipsoid(Vector3(15.0, 10.0, 8.0)),
                                         analytic::cube(20.0) })
  {
    SCOPED_TRACE(solid.name);
    const auto   image = labelImage(analytic::labelVolume(solid));
    const double distance =
      runWith(image, unrepaired(1e-9, true), Pipeline::ShellMethod::Eikonal)->GetResult().equalisation->largestDistance;
    const double tolerance = 0.999 * distance;
    const auto   eikonal = runWith(image, unrepaired(tolerance, true), Pipeline::ShellMethod::Eikonal);
    if (eikonal->GetResult().equalisation->exact)
    {
      continue;
    }
    const auto allowed = runWith(image, unrepaired(tolerance, true));
    try
    {
      const auto strict = runWith(image, unrepaired(tolerance, false));
      EXPECT_TRUE(allowed->GetResult().equalisation->exact);
      EXPECT_EQ(allowed->GetHexMesh().nodes, strict->GetHexMesh().nodes);
      ++exact;
    }
    catch (const itk::NotConvergedError &)
    {
      EXPECT_FALSE(allowed->GetResult().equalisation->exact);
      EXPECT_LE(badness(*allowed), badness(*eikonal));
      EXPECT_NE(allowed->GetResult().warnings.back().find("Chan-Vese"), std::string::npos);
      ++partial;
    }
  }
  EXPECT_GE(exact, 1u);
  EXPECT_GE(partial, 1u);
}
