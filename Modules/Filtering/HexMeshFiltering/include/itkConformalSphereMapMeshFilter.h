#ifndef itkConformalSphereMapMeshFilter_h
#define itkConformalSphereMapMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkTriangleMeshConversion.h"

#include "moserhex/SphericalMap/ConformalMap.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class ConformalSphereMapMeshFilter
 * \brief Angenent's conformal map of a closed genus-0 surface to the unit sphere (stage D).
 *
 * Output: the triangles of the input with their vertices on the unit sphere. See moserhex::conformalSphereMap for the
 * equations and errors. The map may flip triangles of bad meshes: see GetFlippedTriangles(), or use
 * AreaPreservingSphereMapMeshFilter, which guarantees that it does not. */
template <typename TInputMesh, typename TOutputMesh = DoubleTriangleMesh>
class ConformalSphereMapMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ConformalSphereMapMeshFilter);

  using Self = ConformalSphereMapMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ConformalSphereMapMeshFilter);

  /** All options of the algorithm. */
  void
  SetOptions(const moserhex::ConformalMapOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  /** \copydoc SetOptions */
  itkGetConstReferenceMacro(Options, moserhex::ConformalMapOptions);

  /** Triangles with a negative solid angle in the last output. */
  itkGetConstMacro(FlippedTriangles, int);

protected:
  ConformalSphereMapMeshFilter() = default;
  ~ConformalSphereMapMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    moserhex::TriangleMesh surface = TriangleMeshFromItk(this->GetInput());
    RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      moserhex::ConformalMapResult map = moserhex::conformalSphereMap(surface, m_Options);
      m_FlippedTriangles = map.flippedTriangles;
      surface.vertices = std::move(map.positions);
      moserhex::reportProgress(progress, 1.0);
    });
    CopyTriangleMeshToItk(surface, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "FlippedTriangles: " << m_FlippedTriangles << std::endl;
  }

private:
  moserhex::ConformalMapOptions m_Options;
  int                           m_FlippedTriangles{ 0 };
};

} // namespace itk

#endif
