// OwnStage LABELMAP LABEL MESH.vtu: a stage of one's own between two stages of the method.
#include <itkLabelConditioningImageFilter.h>
#include <itkMassPreservingHexahedralMeshFilter.h>
#include <itkVolumeEqualisationMeshFilter.h>
#include <moserhex/HexMeshIO/HexMeshWriter.h>
#include <moserhex/HexMeshIO/LabelImageReader.h>
#include <moserhex/Quality/HexQuality.h>

#include <cstdlib>
#include <iostream>

namespace
{

/** The stage: every inner node goes to the mean of its six neighbours, some times over. As any other filter from a
 * lattice to a lattice it can stand anywhere between those of MoserHex. */
class NeighbourMeanMeshFilter : public itk::MeshToMeshFilter<itk::LatticeHexMesh, itk::LatticeHexMesh>
{
public:
  using Self = NeighbourMeanMeshFilter;
  using Superclass = itk::MeshToMeshFilter<itk::LatticeHexMesh, itk::LatticeHexMesh>;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self);

  itkSetMacro(Sweeps, int);

protected:
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    moserhex::HexMesh mesh = itk::HexMeshFromItk(this->GetInput());
    const int         last = mesh.nodesPerSide - 1;
    for (int sweep = 0; sweep < m_Sweeps; ++sweep)
    {
      const moserhex::HexMesh before = mesh;
      const auto              at = [&before](int i, int j, int k) { return before.nodes[before.nodeNumber(i, j, k)]; };
      for (int k = 1; k < last; ++k)
      {
        for (int j = 1; j < last; ++j)
        {
          for (int i = 1; i < last; ++i)
          {
            mesh.nodes[mesh.nodeNumber(i, j, k)] = (at(i - 1, j, k) + at(i + 1, j, k) + at(i, j - 1, k) +
                                                    at(i, j + 1, k) + at(i, j, k - 1) + at(i, j, k + 1)) /
                                                   6.0;
          }
        }
      }
    }
    itk::CopyHexMeshToItk(mesh, this->GetOutput());
  }

private:
  int m_Sweeps{ 10 };
};

void
print(const char * name, const moserhex::HexMesh & mesh)
{
  const moserhex::HexQualitySummary quality = moserhex::summarizeQuality(mesh);
  std::cout << name << ": volume variance " << quality.volumeVariance << ", " << quality.concaveCells
            << " concave cells, median scaled Jacobian " << quality.scaledJacobian.median << '\n';
}

} // namespace

int
main(int argc, char ** argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: OwnStage LABELMAP LABEL MESH.vtu\n";
    return 2;
  }
  try
  {
    const moserhex::LabelImage labelmap = moserhex::readLabelImage(argv[1]);
    const int                  label = std::atoi(argv[2]);

    // Stages A to G: the initial map of the cube to the organ.
    auto initial = itk::MassPreservingHexahedralMeshFilter<moserhex::LabelImageType>::New();
    initial->SetInput(labelmap.image);
    initial->SetLabel(label);
    initial->SetNumberOfShells(5);
    initial->SetLastStage(moserhex::MeshingStage::Initial);

    auto own = NeighbourMeanMeshFilter::New();
    own->SetInput(initial->GetOutput());

    // Stage J needs the organ's surface, as a level set, and its volume.
    auto conditioning = itk::LabelConditioningImageFilter<moserhex::LabelImageType>::New();
    conditioning->SetInput(labelmap.image);
    conditioning->SetLabel(label);
    conditioning->SetNodesPerSide(10);
    conditioning->Update();

    auto equal = itk::VolumeEqualisationMeshFilter<>::New();
    equal->SetInput(own->GetOutput());
    equal->SetLevelSetImage(conditioning->GetOutput());
    equal->SetVolume(conditioning->GetLabelVolume());
    equal->Update();

    print("initial map", initial->GetHexMesh());
    print("own stage", itk::HexMeshFromItk(own->GetOutput()));
    print("equal volumes", itk::HexMeshFromItk(equal->GetOutput()));
    moserhex::writeHexMesh(argv[3], itk::HexMeshFromItk(equal->GetOutput()));
    return equal->GetResult().exact ? 0 : 1;
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
