#ifndef itkShellOrderingToShellMeshesFilter_h
#define itkShellOrderingToShellMeshesFilter_h

#include "itkCoreAlgorithm.h"
#include "itkLevelSetConversion.h"
#include "itkTriangleMeshConversion.h"

#include "moserhex/LevelSet/ShellSurfaces.h"

#include <itkImageToMeshFilter.h>

namespace itk
{

/** \class ShellOrderingToShellMeshesFilter
 * \brief Cuts the N shells out of an ordering as closed triangle meshes without slivers (stage C).
 *
 * Primary input: the ordering (LevelSetToShellOrderingImageFilter). Input "LevelSet": phi, whose zero set is the
 * outermost shell, on the same grid. Volume: of the organ [mm^3]. GetShell(k) is shell k, 1 the innermost.
 *
 * \par Errors
 * InvalidInputError, NotConvergedError: see moserhex::extractShellSurfaces. */
template <typename TImage, typename TMesh = DoubleTriangleMesh>
class ShellOrderingToShellMeshesFilter : public ImageToMeshFilter<TImage, TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ShellOrderingToShellMeshesFilter);

  using Self = ShellOrderingToShellMeshesFilter;
  using Superclass = ImageToMeshFilter<TImage, TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ShellOrderingToShellMeshesFilter);

  /** phi, negative inside [mm]; required. */
  itkSetInputMacro(LevelSet, TImage);
  itkGetInputMacro(LevelSet, TImage);

  /** Volume of the organ [mm^3]; must be set. */
  itkSetMacro(Volume, double);
  itkGetConstMacro(Volume, double);

  /** N, the number of outputs. Default 10. */
  void
  SetNumberOfShells(unsigned int shells)
  {
    if (shells == this->GetNumberOfShells())
    {
      return;
    }
    this->SetNumberOfRequiredOutputs(shells);
    this->SetNumberOfIndexedOutputs(shells);
    for (unsigned int k = 0; k < shells; ++k)
    {
      if (this->ProcessObject::GetOutput(k) == nullptr)
      {
        this->SetNthOutput(k, this->MakeOutput(k).GetPointer());
      }
    }
    this->Modified();
  }
  /** \copydoc SetNumberOfShells */
  unsigned int
  GetNumberOfShells() const
  {
    return static_cast<unsigned int>(this->GetNumberOfIndexedOutputs());
  }

  /** Shell 1 (innermost) to N: output shell-1. */
  TMesh *
  GetShell(unsigned int shell)
  {
    return dynamic_cast<TMesh *>(this->ProcessObject::GetOutput(shell - 1));
  }

  /** Volume fractions of the shells; empty (the default): the cube's own, ((2k-1)/(2N-1))^3. */
  void
  SetVolumeFractions(const std::vector<double> & fractions)
  {
    m_VolumeFractions = fractions;
    this->Modified();
  }

  /** How fine the shells are: moserhex::ShellSurfaceOptions::trianglesPerQuad. */
  itkOptionMacro(TrianglesPerQuad, double, trianglesPerQuad);

  /** Whether intersections are looked for: moserhex::ShellSurfaceOptions::checkIntersections. */
  itkOptionMacro(CheckIntersections, bool, checkIntersections);

  /** The worst numbers of the shells of the last run, and its warnings. */
  itkGetConstReferenceMacro(Summary, moserhex::ShellSurfacesSummary);

protected:
  ShellOrderingToShellMeshesFilter()
  {
    this->AddRequiredInputName("LevelSet");
    this->SetNumberOfShells(10);
  }
  ~ShellOrderingToShellMeshesFilter() override = default;

  /** \throws ExceptionObject  an input is missing, or Volume was not set */
  void
  VerifyPreconditions() ITKv5_CONST override
  {
    Superclass::VerifyPreconditions();
    if (!(m_Volume > 0.0))
    {
      itkExceptionMacro("Volume is " << m_Volume << " mm^3, need > 0");
    }
  }

  void
  GenerateData() override
  {
    m_Options.threads = this->GetNumberOfWorkUnits();
    const moserhex::LevelSet ordering = LevelSetFromImage(this->GetInput());
    const moserhex::LevelSet phi = LevelSetFromImage(this->GetLevelSet());
    const auto               shells = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      return m_VolumeFractions.empty()
                             ? moserhex::extractShellSurfaces(
                   ordering, phi, m_Volume, static_cast<int>(this->GetNumberOfShells()), m_Options, progress)
                             : moserhex::extractShellSurfaces(ordering, phi, m_Volume, m_VolumeFractions, m_Options, progress);
    });
    if (shells.size() != this->GetNumberOfShells())
    {
      itkExceptionMacro(<< m_VolumeFractions.size() << " volume fractions for " << this->GetNumberOfShells()
                        << " shells");
    }
    m_Summary = moserhex::summarizeShells(shells, m_Options);
    for (unsigned int k = 0; k < shells.size(); ++k)
    {
      CopyTriangleMeshToItk(shells[k].mesh, this->GetShell(k + 1));
    }
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Volume: " << m_Volume << std::endl;
    os << indent << "NumberOfShells: " << this->GetNumberOfShells() << std::endl;
    os << indent << "TrianglesPerQuad: " << m_Options.trianglesPerQuad << std::endl;
  }

private:
  moserhex::ShellSurfaceOptions  m_Options;
  moserhex::ShellSurfacesSummary m_Summary;
  std::vector<double>            m_VolumeFractions;
  double                         m_Volume{ 0.0 };
};

} // namespace itk

#endif
