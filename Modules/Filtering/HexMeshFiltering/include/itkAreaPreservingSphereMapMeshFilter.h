#ifndef itkAreaPreservingSphereMapMeshFilter_h
#define itkAreaPreservingSphereMapMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkTriangleMeshConversion.h"

#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class AreaPreservingSphereMapMeshFilter
 * \brief Area-preserving map of a closed genus-0 surface to the unit sphere, without a flipped triangle (stages D, E).
 *
 * Output: the triangles of the input with their vertices on the unit sphere, in the frame of the body (LPS). See
 * moserhex::areaPreservingSphereMap for the guarantees and errors. */
template <typename TInputMesh, typename TOutputMesh = DoubleTriangleMesh>
class AreaPreservingSphereMapMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(AreaPreservingSphereMapMeshFilter);

  using Self = AreaPreservingSphereMapMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(AreaPreservingSphereMapMeshFilter);

  /** Where the map is taken from the chain: moserhex::AreaPreservingMapOptions::lastStage. */
  itkOptionMacro(LastStage, moserhex::SphereMapStage, lastStage);

  /** Weight of the shape against the areas: moserhex::AreaPreservingMapOptions::shapeWeight. */
  itkOptionMacro(ShapeWeight, double, shapeWeight);

  /** Area ratio rms that is promised: moserhex::AreaPreservingMapOptions::areaTolerance. */
  itkOptionMacro(AreaTolerance, double, areaTolerance);

  /** Newton steps of each minimisation: moserhex::AreaPreservingMapOptions::maximumSteps. */
  itkOptionMacro(MaximumSteps, int, maximumSteps);

  /** Flips, solid angles, area ratios and angle errors of the last output. */
  itkGetConstReferenceMacro(Quality, moserhex::SphereMapQuality);

  /** Which start was taken and what followed. */
  itkGetConstReferenceMacro(Path, std::string);

protected:
  AreaPreservingSphereMapMeshFilter() = default;
  ~AreaPreservingSphereMapMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    moserhex::TriangleMesh surface = TriangleMeshFromItk(this->GetInput());
    RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      moserhex::AreaPreservingMapResult map = moserhex::areaPreservingSphereMap(surface, m_Options, progress);
      m_Quality = map.quality;
      m_Path = map.path;
      surface.vertices = std::move(map.positions);
    });
    CopyTriangleMeshToItk(surface, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "ShapeWeight: " << m_Options.shapeWeight << std::endl;
    os << indent << "AreaTolerance: " << m_Options.areaTolerance << std::endl;
    os << indent << "MaximumSteps: " << m_Options.maximumSteps << std::endl;
    os << indent << "Path: " << m_Path << std::endl;
  }

private:
  moserhex::AreaPreservingMapOptions m_Options;
  moserhex::SphereMapQuality         m_Quality;
  std::string                        m_Path;
};

} // namespace itk

#endif
