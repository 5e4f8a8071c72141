#ifndef itkVolumeEqualisationMeshFilter_h
#define itkVolumeEqualisationMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"
#include "itkLevelSetConversion.h"

#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <itkImage.h>
#include <itkMeshToMeshFilter.h>

namespace itk
{

/** \class VolumeEqualisationMeshFilter
 * \brief Gives every cell of a hexahedral lattice exactly the same volume, none of them concave (stage J).
 *
 * Primary input: any lattice of the solid, tangled or not, of at most the size wanted (ShellMeshesToHexMeshFilter makes
 * one). Input "LevelSetImage": signed distance to the organ's surface, negative inside [mm], on a grid with equal
 * spacings (LabelConditioningImageFilter makes one). Output: the lattice whose boundary slid on that surface.
 *
 * \par Errors
 * InvalidInputError (no lattice's nodes, Volume or an option out of range), NotConvergedError (the mesh is not exact:
 * the description says in what, and by how much) unless AllowPartial, ProcessAborted. The output is left empty then.
 *
 * The result is the same, byte for byte, for any number of work units. */
template <typename TInputMesh = LatticeHexMesh, typename TOutputMesh = TInputMesh>
class VolumeEqualisationMeshFilter : public MeshToMeshFilter<TInputMesh, TOutputMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(VolumeEqualisationMeshFilter);

  using Self = VolumeEqualisationMeshFilter;
  using Superclass = MeshToMeshFilter<TInputMesh, TOutputMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(VolumeEqualisationMeshFilter);

  using LevelSetImageType = Image<double, 3>; ///< with equal spacings

  /** Signed distance to the organ's surface, negative inside [mm]; required. */
  itkSetInputMacro(LevelSetImage, LevelSetImageType);
  itkGetInputMacro(LevelSetImage, LevelSetImageType);

  /** Volume of the label; every cell gets Volume / (n-1)^3 [mm^3]. Must be set. */
  itkSetMacro(Volume, double);
  itkGetConstMacro(Volume, double);

  /** All options of the stage; the thread count is replaced by the number of work units. */
  void
  SetOptions(const moserhex::EqualisationOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  /** \copydoc SetOptions */
  itkGetConstReferenceMacro(Options, moserhex::EqualisationOptions);

  /** n of the mesh wanted; 0, the default: that of the input. */
  itkOptionMacro(NodesPerSide, int, nodesPerSide);

  /** How near the boundary has to come: moserhex::EqualisationOptions::surfaceTolerance. */
  itkOptionMacro(SurfaceTolerance, double, surfaceTolerance);

  /** Give out a mesh that is not exact where NotConvergedError would be thrown. Default false. */
  itkSetMacro(AllowPartial, bool);
  itkGetConstMacro(AllowPartial, bool);
  itkBooleanMacro(AllowPartial);

  /** Whether the mesh is exact, what it lacks, and what was done; without its mesh, which is the output. */
  itkGetConstReferenceMacro(Result, moserhex::EqualisationResult);

protected:
  VolumeEqualisationMeshFilter()
  {
    this->AddRequiredInputName("LevelSetImage");
  }
  ~VolumeEqualisationMeshFilter() override = default;

  /** A mesh has nothing to copy before its data exist; the base class would want input and output of one type. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override
  {
    const moserhex::HexMesh       start = HexMeshFromItk(this->GetInput());
    moserhex::EqualisationOptions options = m_Options;
    options.threads = this->GetNumberOfWorkUnits();
    m_Result = RunCoreAlgorithm(this, [&](const moserhex::ProgressCallback & progress) {
      const moserhex::LevelSet          levelSet = LevelSetFromImage(this->GetLevelSetImage());
      const moserhex::CubicInterpolator phi(levelSet);
      const auto distance = [&phi](const moserhex::Vector3 & point, moserhex::Vector3 & gradient) {
        const moserhex::ValueAndGradient at = phi.at(point);
        gradient = at.gradient;
        return at.value;
      };
      return moserhex::equaliseVolumes(start, distance, m_Volume, options, progress);
    });
    const moserhex::HexMesh mesh = std::move(m_Result.mesh);
    m_Result.mesh = {};
    if (!m_Result.exact && !m_AllowPartial)
    {
      std::string all;
      for (const std::string & shortcoming : m_Result.shortcomings)
      {
        all += (all.empty() ? "not exact: " : "; ") + shortcoming;
      }
      const moserhex::NotConverged error(moserhex::ErrorCode::NotExact, all, m_Result.report);
      throw NotConvergedError(__FILE__, __LINE__, error, this->GetNameOfClass());
    }
    CopyHexMeshToItk(mesh, this->GetOutput());
  }

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Volume: " << m_Volume << std::endl;
    os << indent << "NodesPerSide: " << m_Options.nodesPerSide << std::endl;
    os << indent << "SurfaceTolerance: " << m_Options.surfaceTolerance << std::endl;
    os << indent << "AllowPartial: " << m_AllowPartial << std::endl;
    os << indent << "Exact: " << m_Result.exact << std::endl;
  }

private:
  moserhex::EqualisationOptions m_Options;
  moserhex::EqualisationResult  m_Result;
  double                        m_Volume{ 0.0 };
  bool                          m_AllowPartial{ false };
};

} // namespace itk

#endif
