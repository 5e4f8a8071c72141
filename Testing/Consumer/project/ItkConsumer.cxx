// The ITK layer: a ball in a labelmap becomes a lattice mesh in a file.
#include <itkMassPreservingHexahedralMeshFilter.h>
#include <moserhex/HexMeshIO/HexMeshWriter.h>

#include <cstdio>

int
main()
{
  using LabelmapType = itk::Image<short, 3>;
  auto labelmap = LabelmapType::New();
  labelmap->SetRegions(itk::Size<3>{ { 40, 40, 40 } });
  labelmap->Allocate(true);
  for (long k = 0; k < 40; ++k)
  {
    for (long j = 0; j < 40; ++j)
    {
      for (long i = 0; i < 40; ++i)
      {
        const double x = i - 19.5;
        const double y = j - 19.5;
        const double z = k - 19.5;
        labelmap->SetPixel({ { i, j, k } }, x * x + y * y + z * z < 225.0 ? 1 : 0);
      }
    }
  }

  auto filter = itk::MassPreservingHexahedralMeshFilter<LabelmapType>::New();
  filter->SetInput(labelmap);
  filter->SetLabel(1);
  filter->SetNumberOfShells(4); // 8 x 8 x 8 nodes, 7 x 7 x 7 cells
  filter->Update();
  itk::LatticeHexMesh * mesh = filter->GetOutput();
  const double          variance = filter->GetStages().back().quality->volumeVariance;
  moserhex::writeHexMesh("ball.vtu", filter->GetHexMesh());
  std::printf("%lu nodes, volume variance %g\n", static_cast<unsigned long>(mesh->GetNumberOfPoints()), variance);
  return mesh->GetNumberOfPoints() == 512 && variance < 1e-12 ? 0 : 1;
}
