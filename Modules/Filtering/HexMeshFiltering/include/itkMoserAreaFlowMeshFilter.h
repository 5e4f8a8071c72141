#ifndef itkMoserAreaFlowMeshFilter_h
#define itkMoserAreaFlowMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkTriangleMeshConversion.h"

#include "moserhex/SphericalMap/MoserAreaFlow.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class MoserAreaFlowMeshFilter
 * \brief Moser's flow on the sphere towards an area-preserving map (stage E, the paper's own).
 *
 * Primary input: a map of the surface to the unit sphere without flipped triangles (ConformalSphereMapMeshFilter).
 * Input "Surface": the surface itself, whose areas are to be kept; same triangles. Output: the improved map. */
template <typename TInputMesh, typename TOutputMesh = DoubleTriangleMesh>
class MoserAreaFlowMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MoserAreaFlowMeshFilter);

  using Self = MoserAreaFlowMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(MoserAreaFlowMeshFilter);

  /** The surface whose areas are to be kept; required. */
  itkSetInputMacro(Surface, TInputMesh);
  itkGetInputMacro(Surface, TInputMesh);

  /** Area ratio rms at which the flow ends: moserhex::MoserAreaFlowOptions::tolerance. */
  itkOptionMacro(Tolerance, double, tolerance);

  /** How often the flow is repeated: moserhex::MoserAreaFlowOptions::maximumPasses. */
  itkOptionMacro(MaximumPasses, int, maximumPasses);

  /** Runge-Kutta steps: moserhex::MoserAreaFlowOptions::stepsPerPass. */
  itkOptionMacro(StepsPerPass, int, stepsPerPass);

  /** What happens where triangles would flip: moserhex::MoserAreaFlowOptions::localBrake. */
  itkOptionMacro(LocalBrake, bool, localBrake);

  /** Passes made, area ratio rms reached, and whether the tolerance was met. */
  itkGetConstReferenceMacro(Report, moserhex::StepReport);

protected:
  MoserAreaFlowMeshFilter()
  {
    this->AddRequiredInputName("Surface");
  }
  ~MoserAreaFlowMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    const moserhex::TriangleMesh surface = TriangleMeshFromItk(this->GetSurface());
    moserhex::TriangleMesh       sphere = TriangleMeshFromItk(this->GetInput());
    if (sphere.triangles != surface.triangles)
    {
      const moserhex::InvalidInput error("the surface and its map must have the same triangles");
      throw InvalidInputError(__FILE__, __LINE__, error, this->GetNameOfClass());
    }
    RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      moserhex::MoserAreaFlowResult flow = moserhex::moserAreaFlow(surface, sphere.vertices, m_Options);
      m_Report = flow.report;
      sphere.vertices = std::move(flow.positions);
      moserhex::reportProgress(progress, 1.0);
    });
    CopyTriangleMeshToItk(sphere, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Tolerance: " << m_Options.tolerance << std::endl;
    os << indent << "MaximumPasses: " << m_Options.maximumPasses << std::endl;
    os << indent << "StepsPerPass: " << m_Options.stepsPerPass << std::endl;
    os << indent << "LocalBrake: " << m_Options.localBrake << std::endl;
  }

private:
  moserhex::MoserAreaFlowOptions m_Options;
  moserhex::StepReport           m_Report;
};

} // namespace itk

#endif
