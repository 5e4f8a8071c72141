#ifndef itkLatticeSmoothingMeshFilter_h
#define itkLatticeSmoothingMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"

#include "moserhex/HexMap/LatticeSmoothing.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class LatticeSmoothingMeshFilter
 * \brief Smooths the points of a hexahedral lattice: harmonic inside, tangential on the boundary (stage H). */
template <typename TInputMesh = LatticeHexMesh, typename TOutputMesh = TInputMesh>
class LatticeSmoothingMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LatticeSmoothingMeshFilter);

  using Self = LatticeSmoothingMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(LatticeSmoothingMeshFilter);

  /** How far the interior diffuses: moserhex::LatticeSmoothingOptions::interiorTime. */
  itkOptionMacro(InteriorTime, double, interiorTime);

  /** Sweeps over the boundary: moserhex::LatticeSmoothingOptions::boundarySweeps. */
  itkOptionMacro(BoundarySweeps, int, boundarySweeps);

  /** What one of them does: moserhex::LatticeSmoothingOptions::boundaryStrength. */
  itkOptionMacro(BoundaryStrength, double, boundaryStrength);

  /** Puts boundary points back on the organ's surface; needed when BoundarySweeps > 0. */
  void
  SetSurfaceProjection(moserhex::SurfaceProjection projection)
  {
    m_SurfaceProjection = std::move(projection);
    this->Modified();
  }

protected:
  LatticeSmoothingMeshFilter() = default;
  ~LatticeSmoothingMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    const moserhex::HexMesh mesh = HexMeshFromItk(this->GetInput());
    const moserhex::HexMesh smoothed = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      moserhex::HexMesh result = moserhex::smoothLattice(mesh, m_SurfaceProjection, m_Options);
      moserhex::reportProgress(progress, 1.0);
      return result;
    });
    CopyHexMeshToItk(smoothed, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "InteriorTime: " << m_Options.interiorTime << std::endl;
    os << indent << "BoundarySweeps: " << m_Options.boundarySweeps << std::endl;
    os << indent << "BoundaryStrength: " << m_Options.boundaryStrength << std::endl;
  }

private:
  moserhex::LatticeSmoothingOptions m_Options;
  moserhex::SurfaceProjection       m_SurfaceProjection;
};

} // namespace itk

#endif
