#ifndef itkShellMeshesToHexMeshFilter_h
#define itkShellMeshesToHexMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"

#include "moserhex/HexMap/InitialMap.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class ShellMeshesToHexMeshFilter
 * \brief Joins N shells and their sphere maps with the cube's shells into one hexahedral lattice (stages F, G).
 *
 * Shell 1 is the innermost. SetShell(k, surface, sphere) gives shell k and its map to the unit sphere (same triangles,
 * vertices moved); all shells 1..N must be given. Output: (2N)^3 points, (2N-1)^3 hexahedra in lattice order. */
template <typename TTriangleMesh, typename TOutputMesh = LatticeHexMesh>
class ShellMeshesToHexMeshFilter : public MeshToMeshFilter<TTriangleMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ShellMeshesToHexMeshFilter);

  using Self = ShellMeshesToHexMeshFilter;
  using Superclass = MeshToMeshFilter<TTriangleMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ShellMeshesToHexMeshFilter);

  /** Shell 1 (innermost) to N and its map to the sphere. */
  void
  SetShell(unsigned int shell, const TTriangleMesh * surface, const TTriangleMesh * sphere)
  {
    if (shell == 0)
    {
      itkExceptionMacro("shells are numbered from 1 (innermost)");
    }
    this->SetNthInput(2 * (shell - 1), const_cast<TTriangleMesh *>(surface));
    this->SetNthInput(2 * (shell - 1) + 1, const_cast<TTriangleMesh *>(sphere));
  }

  /** N: the largest shell given so far. */
  unsigned int
  GetNumberOfShells() const
  {
    return static_cast<unsigned int>(this->GetNumberOfIndexedInputs() / 2);
  }

protected:
  ShellMeshesToHexMeshFilter() = default;
  ~ShellMeshesToHexMeshFilter() override = default;

  /** \throws ExceptionObject  a shell or its map is missing */
  void
  VerifyPreconditions() ITKv5_CONST override
  {
    Superclass::VerifyPreconditions();
    for (unsigned int input = 0; input < 2 * this->GetNumberOfShells(); ++input)
    {
      if (this->ProcessObject::GetInput(input) == nullptr)
      {
        itkExceptionMacro("shell " << input / 2 + 1 << " of " << this->GetNumberOfShells() << " is missing");
      }
    }
  }

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    std::vector<moserhex::TriangleMesh> shells;
    std::vector<moserhex::Positions>    maps;
    for (unsigned int k = 0; k < this->GetNumberOfShells(); ++k)
    {
      shells.push_back(TriangleMeshFromItk(this->GetInput(2 * k)));
      maps.push_back(PositionsFromItk(this->GetInput(2 * k + 1)));
    }
    moserhex::InitialMapOptions options;
    options.threads = this->GetNumberOfWorkUnits();
    const moserhex::HexMesh mesh = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      return moserhex::initialMap(shells, maps, options, progress);
    });
    CopyHexMeshToItk(mesh, this->GetOutput());
  }
};

} // namespace itk

#endif
