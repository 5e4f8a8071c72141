// Exact class: topology of the level sets, volume fractions, refusals, determinism, physical space. Two-roads class:
// the Chan-Vese front and fast sweeping order a ball alike (the curvature and the first order of both cost up to 0.05).
#include "itkCoreAlgorithm.h"
#include "itkLevelSetConversion.h"
#include "itkLevelSetToShellOrderingImageFilter.h"

#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/ShellOrdering.h"

#include <itkImage.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using ImageType = itk::Image<double, 3>;
using FilterType = itk::LevelSetToShellOrderingImageFilter<ImageType>;
using itk::ShellMethod;
using moserhex::Vector3;

template <typename TFunction>
moserhex::LevelSet
sampled(const Vector3 & extent, double spacing, const TFunction & f)
{
  moserhex::LevelSet phi;
  for (std::size_t a = 0; a < 3; ++a)
  {
    phi.grid.size[a] = 2 * static_cast<int>(extent[static_cast<int>(a)] / spacing + 4) + 1;
    phi.grid.origin[static_cast<int>(a)] = -spacing * (phi.grid.size[a] / 2) + 0.1 * spacing;
  }
  phi.grid.spacing = spacing;
  phi.values.resize(phi.grid.nodeCount());
  for (std::size_t node = 0; node < phi.values.size(); ++node)
  {
    phi.values[node] = f(phi.grid.point(node));
  }
  return phi;
}

moserhex::LevelSet
ball()
{
  return sampled({ 10, 10, 10 }, 0.8, [](const Vector3 & p) { return p.norm() - 10; });
}

moserhex::LevelSet
capsule()
{
  return sampled({ 14, 6, 6 }, 0.7, [](const Vector3 & p) {
    return (p - Vector3(std::min(std::max(p.x(), -8.0), 8.0), 0, 0)).norm() - 6;
  });
}

FilterType::Pointer
filterOf(const moserhex::LevelSet & phi, ShellMethod method, int shells = 6)
{
  auto filter = FilterType::New();
  filter->SetInput(itk::ImageFromLevelSet<ImageType>(phi));
  filter->SetMethod(method);
  filter->SetNumberOfShells(shells);
  return filter;
}

void
expectShellsAreSpheres(const moserhex::LevelSet & s, const std::vector<double> & fractions, double volume)
{
  for (std::size_t k = 0; k + 1 < fractions.size(); ++k)
  {
    const double level = moserhex::levelOfVolume(s, fractions[k] * volume);
    EXPECT_TRUE(moserhex::summarizeTopology(moserhex::marchingTetrahedra(s, level)).isSphere()) << "shell " << k + 1;
  }
}

} // namespace

class ShellOrderingFilter : public testing::TestWithParam<ShellMethod>
{};

TEST_P(ShellOrderingFilter, EveryShellIsASphereOfItsVolume)
{
  const moserhex::LevelSet phi = capsule();
  const auto               filter = filterOf(phi, GetParam());
  filter->Update();
  EXPECT_TRUE(filter->GetReport().converged);
  EXPECT_TRUE(filter->GetReport().warnings.empty());
  EXPECT_GT(filter->GetReport().iterations, 0u);
  ASSERT_EQ(filter->GetVolumeFractions().size(), 6u);
  if (GetParam() != ShellMethod::Snapshots)
  {
    EXPECT_EQ(filter->GetVolumeFractions(), moserhex::cubeVolumeFractions(6));
  }
  expectShellsAreSpheres(itk::LevelSetFromImage<ImageType>(filter->GetOutput()),
                         filter->GetVolumeFractions(),
                         moserhex::VolumeBelowLevel(phi).volume(0.0));
}

TEST_P(ShellOrderingFilter, KeepsTheGridOfTheInput)
{
  moserhex::LevelSet phi = ball();
  phi.grid.origin = Vector3(10, -20, 30);
  phi.grid.direction << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, -1;
  const auto turned = filterOf(phi, GetParam());
  turned->Update();
  const moserhex::LevelSet s = itk::LevelSetFromImage<ImageType>(turned->GetOutput());
  EXPECT_EQ(s.grid.size, phi.grid.size);
  EXPECT_TRUE(s.grid.origin.isApprox(phi.grid.origin, 1e-12));
  EXPECT_TRUE(s.grid.direction.isApprox(phi.grid.direction, 1e-12));
  const auto straight = filterOf(ball(), GetParam());
  straight->Update();
  EXPECT_EQ(itk::LevelSetFromImage<ImageType>(straight->GetOutput()).values, s.values);
}

TEST_P(ShellOrderingFilter, IsTheSameForOneAndTwoThreads)
{
  const auto one = filterOf(capsule(), GetParam());
  one->SetNumberOfWorkUnits(1);
  one->Update();
  const auto two = filterOf(capsule(), GetParam());
  two->SetNumberOfWorkUnits(2);
  two->Update();
  EXPECT_EQ(itk::LevelSetFromImage<ImageType>(one->GetOutput()).values,
            itk::LevelSetFromImage<ImageType>(two->GetOutput()).values);
}

TEST_P(ShellOrderingFilter, CallerCanAbort)
{
  const auto filter = filterOf(capsule(), GetParam());
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { filter->AbortGenerateDataOn(); });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}

TEST_P(ShellOrderingFilter, WrongInputIsRefused)
{
  EXPECT_THROW(filterOf(ball(), GetParam(), 0)->Update(), itk::InvalidInputError);
  moserhex::LevelSet empty = ball();
  std::fill(empty.values.begin(), empty.values.end(), 1.0);
  EXPECT_THROW(filterOf(empty, GetParam())->Update(), itk::ExceptionObject);
  const auto filter = FilterType::New();
  filter->SetMethod(GetParam());
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         ShellOrderingFilter,
                         testing::Values(ShellMethod::ChanVese, ShellMethod::Eikonal, ShellMethod::Snapshots));

TEST(ShellOrderingFilters, ChanVeseAndEikonalOrderABallByRadius)
{
  const moserhex::LevelSet phi = ball();
  for (const ShellMethod method : { ShellMethod::ChanVese, ShellMethod::Eikonal })
  {
    const auto filter = filterOf(phi, method);
    filter->SetSmoothing(1.0); // adds 3 (sigma h / R)^2 to s
    filter->Update();
    const moserhex::LevelSet s = itk::LevelSetFromImage<ImageType>(filter->GetOutput());
    for (std::size_t node = 0; node < phi.values.size(); ++node)
    {
      const double r = phi.grid.point(node).norm();
      if (r < 9)
      {
        EXPECT_NEAR(s.values[node], r * r / 100, 0.05) << "r " << r;
      }
    }
  }
}

TEST(ShellOrderingFilters, ChanVeseAgreesWithEikonalOnACapsule)
{
  const auto chanVese = filterOf(capsule(), ShellMethod::ChanVese);
  const auto eikonal = filterOf(capsule(), ShellMethod::Eikonal);
  chanVese->Update();
  eikonal->Update();
  const auto a = itk::LevelSetFromImage<ImageType>(chanVese->GetOutput()).values;
  const auto b = itk::LevelSetFromImage<ImageType>(eikonal->GetOutput()).values;
  double     largest = 0.0;
  for (std::size_t node = 0; node < a.size(); ++node)
  {
    largest = std::max(largest, std::abs(a[node] - b[node]));
  }
  EXPECT_LT(largest, 0.1);
  EXPECT_GT(largest, 0.0); // two methods, not one
}

TEST(ShellOrderingFilters, FrontThatStopsEarlyGivesAWarningAndStillSpheres)
{
  const moserhex::LevelSet phi = capsule();
  const auto               filter = filterOf(phi, ShellMethod::ChanVese);
  filter->SetMaximumNumberOfIterations(15);
  filter->Update();
  EXPECT_FALSE(filter->GetReport().converged);
  EXPECT_EQ(filter->GetReport().warnings.size(), 1u);
  EXPECT_GT(filter->GetReport().unreached, 0u);
  expectShellsAreSpheres(itk::LevelSetFromImage<ImageType>(filter->GetOutput()),
                         filter->GetVolumeFractions(),
                         moserhex::VolumeBelowLevel(phi).volume(0.0));
}

TEST(ShellOrderingFilters, AnisotropicImagesAreRefused)
{
  auto         image = itk::ImageFromLevelSet<ImageType>(ball());
  const double spacing[3] = { 0.8, 0.8, 1.6 };
  image->SetSpacing(spacing);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  EXPECT_THROW(filter->Update(), itk::InvalidInputError);
}
