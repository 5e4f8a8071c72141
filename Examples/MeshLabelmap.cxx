// MeshLabelmap LABELMAP LABEL MESH.vtu: one label of a labelmap to a structured hexahedral mesh.
#include <itkMassPreservingHexahedralMeshFilter.h>
#include <moserhex/HexMeshIO/HexMeshWriter.h>
#include <moserhex/HexMeshIO/LabelImageReader.h>

#include <cstdlib>
#include <iostream>

int
main(int argc, char ** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: MeshLabelmap LABELMAP LABEL MESH.vtu\n";
    return 2;
  }
  try
  {
    const moserhex::LabelImage labelmap = moserhex::readLabelImage(argv[1]);

    auto filter = itk::MassPreservingHexahedralMeshFilter<moserhex::LabelImageType>::New();
    filter->SetInput(labelmap.image);
    filter->SetLabel(std::atoi(argv[2]));
    filter->SetNumberOfShells(6); // 12 x 12 x 12 nodes
    filter->Update();

    for (const moserhex::MeshingStageReport & stage : filter->GetStages())
    {
      std::cout << stage.name << ": " << stage.seconds << " s";
      if (stage.quality)
      {
        std::cout << ", volume variance " << stage.quality->volumeVariance << ", " << stage.quality->concavePercent
                  << " % concave";
      }
      std::cout << '\n';
    }
    moserhex::writeHexMesh(argv[3], filter->GetHexMesh());
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
