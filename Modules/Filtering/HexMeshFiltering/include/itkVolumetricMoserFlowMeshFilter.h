#ifndef itkVolumetricMoserFlowMeshFilter_h
#define itkVolumetricMoserFlowMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"

#include "moserhex/HexMap/VolumetricMoserFlow.h"

#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class VolumetricMoserFlowMeshFilter
 * \brief Moser's volume-preserving flow on the cube lattice, repeated until it stops gaining (stage I).
 *
 * The output is never worse than the input in the sense of moserhex::volumetricMoserFlow; GetPasses() tells what every
 * pass did. */
template <typename TInputMesh = LatticeHexMesh, typename TOutputMesh = TInputMesh>
class VolumetricMoserFlowMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumetricMoserFlowMeshFilter);

  using Self = VolumetricMoserFlowMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(VolumetricMoserFlowMeshFilter);

  /** All options of the flow. */
  void
  SetOptions(const moserhex::VolumetricMoserFlowOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  /** \copydoc SetOptions */
  itkGetConstReferenceMacro(Options, moserhex::VolumetricMoserFlowOptions);

  /** What nodes on the boundary may do: moserhex::VolumetricMoserFlowOptions::boundary. */
  itkOptionMacro(Boundary, moserhex::BoundaryMotion, boundary);

  /** How often the flow is repeated: moserhex::VolumetricMoserFlowOptions::maximumPasses. */
  itkOptionMacro(MaximumPasses, int, maximumPasses);

  /** Puts boundary points back on the organ's surface after they slid. */
  void
  SetSurfaceProjection(moserhex::SurfaceProjection projection)
  {
    m_SurfaceProjection = std::move(projection);
    this->Modified();
  }

  /** State of the mesh after each pass; the first entry is the input. */
  const std::vector<moserhex::MoserPass> &
  GetPasses() const
  {
    return m_Passes;
  }

protected:
  VolumetricMoserFlowMeshFilter() = default;
  ~VolumetricMoserFlowMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    const moserhex::HexMesh             mesh = HexMeshFromItk(this->GetInput());
    moserhex::VolumetricMoserFlowResult flow = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      return moserhex::volumetricMoserFlow(mesh, m_SurfaceProjection, m_Options, progress);
    });
    m_Passes = std::move(flow.passes);
    CopyHexMeshToItk(flow.mesh, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "MaximumPasses: " << m_Options.maximumPasses << std::endl;
    os << indent << "Passes: " << m_Passes.size() << std::endl;
  }

private:
  moserhex::VolumetricMoserFlowOptions m_Options;
  moserhex::SurfaceProjection          m_SurfaceProjection;
  std::vector<moserhex::MoserPass>     m_Passes;
};

} // namespace itk

#endif
