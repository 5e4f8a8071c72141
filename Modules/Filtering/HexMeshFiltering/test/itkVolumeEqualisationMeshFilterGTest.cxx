// Exact: the filter adds nothing to the Core algorithm, so nodes are compared bit for bit.
#include "itkVolumeEqualisationMeshFilter.h"

#include "moserhex/Analytic/SolidShapes.h"

#include <gtest/gtest.h>

using namespace moserhex;
using Filter = itk::VolumeEqualisationMeshFilter<>;

namespace
{

constexpr double radius = 10.0;

/** Distance to a ball about the origin, 1 mm apart. */
LevelSet
ballLevelSet()
{
  const analytic::Solid ball = analytic::ball(radius);
  LevelSet              phi;
  phi.grid.size = { 31, 31, 31 };
  phi.grid.spacing = 1.0;
  phi.grid.origin = Vector3::Constant(-15.0);
  phi.values.reserve(31 * 31 * 31);
  for (int k = 0; k < 31; ++k)
  {
    for (int j = 0; j < 31; ++j)
    {
      for (int i = 0; i < 31; ++i)
      {
        phi.values.push_back(ball.signedFunction(Vector3(i - 15.0, j - 15.0, k - 15.0)));
      }
    }
  }
  return phi;
}

/** A cube lattice whose corners stick out of the ball. */
HexMesh
cubeStart(int n)
{
  HexMesh mesh;
  mesh.nodesPerSide = n;
  const double step = 1.4 * radius / (n - 1);
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        mesh.nodes.push_back(step * Vector3(i, j, k) - Vector3::Constant(0.7 * radius));
      }
    }
  }
  return mesh;
}

Filter::Pointer
filterOf(const HexMesh & start, double volume)
{
  const auto input = itk::LatticeHexMesh::New();
  itk::CopyHexMeshToItk(start, input.GetPointer());
  const auto filter = Filter::New();
  filter->SetInput(input);
  filter->SetLevelSetImage(itk::ImageFromLevelSet<Filter::LevelSetImageType>(ballLevelSet()));
  filter->SetVolume(volume);
  filter->SetNumberOfWorkUnits(1);
  return filter;
}

double
ballVolume()
{
  return analytic::ball(radius).volume;
}

} // namespace

TEST(VolumeEqualisationMeshFilter, EqualsTheCoreAlgorithm)
{
  const auto filter = filterOf(cubeStart(6), ballVolume());
  filter->SetNodesPerSide(8);
  filter->Update();

  const LevelSet          phi = ballLevelSet();
  const CubicInterpolator phiAt(phi);
  EqualisationOptions     options;
  options.nodesPerSide = 8;
  const EqualisationResult expected = equaliseVolumes(
    cubeStart(6),
    [&phiAt](const Vector3 & point, Vector3 & gradient) {
      const ValueAndGradient at = phiAt.at(point);
      gradient = at.gradient;
      return at.value;
    },
    ballVolume(),
    options);
  EXPECT_EQ(itk::PositionsFromItk(filter->GetOutput()), expected.mesh.nodes);
  EXPECT_EQ(filter->GetResult().largestDistance, expected.largestDistance);
}

TEST(VolumeEqualisationMeshFilter, EveryCellOfABallHasTheSameVolume)
{
  const auto filter = filterOf(cubeStart(6), ballVolume());
  filter->Update();
  EXPECT_TRUE(filter->GetResult().exact);
  const double wanted = ballVolume() / 125.0;
  for (const double volume : cellVolumes(itk::HexMeshFromItk(filter->GetOutput())))
  {
    EXPECT_NEAR(volume, wanted, 1e-9 * wanted);
  }
}

TEST(VolumeEqualisationMeshFilter, WorkUnitsChangeNoBit)
{
  const auto one = filterOf(cubeStart(6), ballVolume());
  const auto three = filterOf(cubeStart(6), ballVolume());
  three->SetNumberOfWorkUnits(3);
  one->Update();
  three->Update();
  EXPECT_EQ(itk::PositionsFromItk(one->GetOutput()), itk::PositionsFromItk(three->GetOutput()));
}

TEST(VolumeEqualisationMeshFilter, MeshThatIsNotExactIsNotConvergedUnlessItIsAllowed)
{
  // The surface holds half of the volume asked for: the boundary cannot lie on it.
  const auto filter = filterOf(cubeStart(6), 2.0 * ballVolume());
  try
  {
    filter->Update();
    FAIL() << "a mesh twice the ball was called exact";
  }
  catch (const itk::NotConvergedError & error)
  {
    EXPECT_EQ(std::string(error.GetDescription()).compare(0, 11, "not exact: "), 0) << error.GetDescription();
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0u);
  filter->AllowPartialOn();
  filter->Update();
  EXPECT_FALSE(filter->GetResult().exact);
  EXPECT_FALSE(filter->GetResult().shortcomings.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 216u);
}

TEST(VolumeEqualisationMeshFilter, WithoutVolumeOrLevelSetItRefuses)
{
  EXPECT_THROW(filterOf(cubeStart(6), 0.0)->Update(), itk::InvalidInputError);
  const auto filter = filterOf(cubeStart(6), ballVolume());
  filter->SetLevelSetImage(nullptr);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(VolumeEqualisationMeshFilter, AnAbortIsProcessAborted)
{
  const auto filter = filterOf(cubeStart(6), ballVolume());
  auto *     raw = filter.GetPointer();
  filter->AddObserver(itk::ProgressEvent(), [raw](const itk::EventObject &) { raw->AbortGenerateDataOn(); });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}
