// The filter adds nothing to the Core algorithm: shells are compared with its bit for bit, on a ball whose ordering is
// (r / R)^2.
#include "itkShellOrderingToShellMeshesFilter.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using LevelSetImage = itk::Image<double, 3>;
using Filter = itk::ShellOrderingToShellMeshesFilter<LevelSetImage>;

namespace
{

constexpr double radius = 10.0;
constexpr double volume = 4.0 / 3.0 * pi * radius * radius * radius;

LevelSet
onBall(bool ordering)
{
  LevelSet result;
  result.grid.size = { { 33, 33, 33 } };
  result.grid.spacing = 0.8;
  result.grid.origin = Vector3::Constant(-16 * 0.8);
  for (std::size_t node = 0; node < result.grid.nodeCount(); ++node)
  {
    const double r = result.grid.point(node).norm();
    result.values.push_back(ordering ? r * r / (radius * radius) : r - radius);
  }
  return result;
}

Filter::Pointer
filterOnBall(unsigned int shells)
{
  auto filter = Filter::New();
  filter->SetInput(itk::ImageFromLevelSet<LevelSetImage>(onBall(true)));
  filter->SetLevelSet(itk::ImageFromLevelSet<LevelSetImage>(onBall(false)));
  filter->SetVolume(volume);
  filter->SetNumberOfShells(shells);
  return filter;
}

} // namespace

TEST(ShellOrderingToShellMeshesFilter, EqualsTheCoreAlgorithm)
{
  const auto filter = filterOnBall(3);
  filter->Update();
  const std::vector<ShellSurface> expected = extractShellSurfaces(onBall(true), onBall(false), volume, 3);
  ASSERT_EQ(filter->GetNumberOfShells(), 3u);
  for (unsigned int k = 0; k < 3; ++k)
  {
    const TriangleMesh mesh = itk::TriangleMeshFromItk(filter->GetShell(k + 1));
    EXPECT_EQ(mesh.vertices, expected[k].mesh.vertices);
    EXPECT_EQ(mesh.triangles, expected[k].mesh.triangles);
  }
  EXPECT_LE(filter->GetSummary().worstVolumeError, 1e-3);
}

TEST(ShellOrderingToShellMeshesFilter, TakesOtherVolumeFractions)
{
  const auto filter = filterOnBall(2);
  filter->SetVolumeFractions({ 0.5, 1.0 });
  filter->Update();
  EXPECT_NEAR(enclosedVolume(itk::TriangleMeshFromItk(filter->GetShell(1))) / volume, 0.5, 1e-3);
}

TEST(ShellOrderingToShellMeshesFilter, AnotherNumberOfFractionsThanShellsIsRefused)
{
  const auto filter = filterOnBall(3);
  filter->SetVolumeFractions({ 0.5, 1.0 });
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}

TEST(ShellOrderingToShellMeshesFilter, AMissingVolumeIsRefused)
{
  const auto filter = filterOnBall(3);
  filter->SetVolume(0.0);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
