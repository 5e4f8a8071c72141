// The filters add nothing to the Core algorithms: results are compared with theirs bit for bit.
#include "itkAreaPreservingSphereMapMeshFilter.h"
#include "itkConformalSphereMapMeshFilter.h"
#include "itkHexMeshQualityCalculator.h"
#include "itkLatticeSmoothingMeshFilter.h"
#include "itkMoserAreaFlowMeshFilter.h"
#include "itkShellMeshesToHexMeshFilter.h"
#include "itkVolumetricMoserFlowMeshFilter.h"

#include "moserhex/Analytic/SurfaceShapes.h"

#include <gtest/gtest.h>

using namespace moserhex;
using Surface = itk::DoubleTriangleMesh;

namespace
{

Surface::Pointer
toItk(const TriangleMesh & mesh)
{
  auto result = Surface::New();
  itk::CopyTriangleMeshToItk(mesh, result.GetPointer());
  return result;
}

TriangleMesh
shell(double size)
{
  return analytic::ellipsoidSurface(3, Vector3(3.0, 2.0, 1.5) * size);
}

/** Four homothetic shells of an ellipsoid, joined into a lattice by the filters alone. */
itk::LatticeHexMesh::Pointer
latticeMesh()
{
  using Join = itk::ShellMeshesToHexMeshFilter<Surface>;
  const auto join = Join::New();
  for (unsigned int k = 1; k <= 4; ++k)
  {
    const auto map = itk::AreaPreservingSphereMapMeshFilter<Surface>::New();
    map->SetInput(toItk(shell((2 * k - 1) / 7.0)));
    map->Update();
    join->SetShell(k, map->GetInput(), map->GetOutput());
  }
  join->Update();
  itk::LatticeHexMesh::Pointer mesh = join->GetOutput();
  mesh->DisconnectPipeline();
  return mesh;
}

} // namespace

TEST(ConformalSphereMapMeshFilter, EqualsTheCoreAlgorithm)
{
  const TriangleMesh surface = shell(1.0);
  const auto         filter = itk::ConformalSphereMapMeshFilter<Surface>::New();
  filter->SetInput(toItk(surface));
  filter->Update();
  EXPECT_EQ(itk::PositionsFromItk(filter->GetOutput()), conformalSphereMap(surface).positions);
}

TEST(ConformalSphereMapMeshFilter, RefusesATorusAsInvalidInput)
{
  const auto filter = itk::ConformalSphereMapMeshFilter<Surface>::New();
  filter->SetInput(toItk(analytic::torusSurface(12, 8)));
  EXPECT_THROW(filter->Update(), itk::InvalidInputError);
}

TEST(MoserAreaFlowMeshFilter, EqualsTheCoreAlgorithm)
{
  const TriangleMesh surface = shell(1.0);
  const auto         conformal = itk::ConformalSphereMapMeshFilter<Surface>::New();
  conformal->SetInput(toItk(surface));
  const auto flow = itk::MoserAreaFlowMeshFilter<Surface>::New();
  flow->SetInput(conformal->GetOutput());
  flow->SetSurface(toItk(surface));
  flow->SetMaximumPasses(2);
  flow->Update();
  MoserAreaFlowOptions options;
  options.maximumPasses = 2;
  EXPECT_EQ(itk::PositionsFromItk(flow->GetOutput()),
            moserAreaFlow(surface, conformalSphereMap(surface).positions, options).positions);
}

TEST(MoserAreaFlowMeshFilter, RefusesAMapOfAnotherSurface)
{
  const auto flow = itk::MoserAreaFlowMeshFilter<Surface>::New();
  flow->SetInput(toItk(analytic::icosphere(2)));
  flow->SetSurface(toItk(shell(1.0)));
  EXPECT_THROW(flow->Update(), itk::InvalidInputError);
}

TEST(AreaPreservingSphereMapMeshFilter, ReportsAMapWithoutFlips)
{
  const auto filter = itk::AreaPreservingSphereMapMeshFilter<Surface>::New();
  filter->SetInput(toItk(shell(1.0)));
  filter->Update();
  EXPECT_EQ(filter->GetQuality().flippedTriangles, 0);
  EXPECT_LE(filter->GetQuality().areaRatioRms, 0.01);
  EXPECT_EQ(itk::PositionsFromItk(filter->GetOutput()), areaPreservingSphereMap(shell(1.0)).positions);
}

TEST(ShellMeshesToHexMeshFilter, RefusesAMissingShell)
{
  const auto join = itk::ShellMeshesToHexMeshFilter<Surface>::New();
  join->SetShell(1, toItk(shell(0.3)), toItk(analytic::icosphere(3)));
  join->SetShell(3, toItk(shell(1.0)), toItk(analytic::icosphere(3)));
  EXPECT_THROW(join->Update(), itk::ExceptionObject);
}

TEST(LatticeFilters, SmoothAndFlowEqualTheCoreAlgorithms)
{
  const auto mesh = latticeMesh();
  const auto smoothing = itk::LatticeSmoothingMeshFilter<>::New();
  smoothing->SetInput(mesh);
  const auto flow = itk::VolumetricMoserFlowMeshFilter<>::New();
  flow->SetInput(smoothing->GetOutput());
  flow->SetBoundary(BoundaryMotion::held);
  flow->SetMaximumPasses(3);
  flow->Update();

  const HexMesh              smoothed = smoothLattice(itk::HexMeshFromItk(mesh.GetPointer()), {});
  VolumetricMoserFlowOptions options;
  options.boundary = BoundaryMotion::held;
  options.maximumPasses = 3;
  const VolumetricMoserFlowResult expected = volumetricMoserFlow(smoothed, {}, options);
  EXPECT_EQ(itk::PositionsFromItk(flow->GetOutput()), expected.mesh.nodes);
  EXPECT_EQ(flow->GetPasses().size(), expected.passes.size());
}

TEST(HexMeshQualityCalculator, EqualsTheCoreSummary)
{
  const auto mesh = latticeMesh();
  const auto calculator = itk::HexMeshQualityCalculator<>::New();
  calculator->SetMesh(mesh);
  calculator->Compute();
  const HexQualitySummary expected = summarizeQuality(itk::HexMeshFromItk(mesh.GetPointer()));
  EXPECT_EQ(calculator->GetSummary().volumeVariance, expected.volumeVariance);
  EXPECT_EQ(calculator->GetSummary().scaledJacobian.minimum, expected.scaledJacobian.minimum);
}

TEST(HexMeshQualityCalculator, RefusesToWorkWithoutAMesh)
{
  EXPECT_THROW(itk::HexMeshQualityCalculator<>::New()->Compute(), itk::ExceptionObject);
}

TEST(MeshStageFilters, AnAbortIsProcessAborted)
{
  const auto filter = itk::AreaPreservingSphereMapMeshFilter<Surface>::New();
  filter->SetInput(toItk(shell(1.0)));
  auto * raw = filter.GetPointer();
  filter->AddObserver(itk::ProgressEvent(), [raw](const itk::EventObject &) { raw->AbortGenerateDataOn(); });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}
