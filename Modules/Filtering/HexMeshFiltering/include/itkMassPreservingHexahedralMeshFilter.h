#ifndef itkMassPreservingHexahedralMeshFilter_h
#define itkMassPreservingHexahedralMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkHexMeshConversion.h"
#include "itkLabelConditioningImageFilter.h"
#include "itkLevelSetToShellOrderingImageFilter.h"

#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <itkImageToMeshFilter.h>

namespace itk
{

/** \class MassPreservingHexahedralMeshFilter
 * \brief One label of a labelmap to a structured hexahedral mesh whose cells have equal volumes.
 *
 * The whole method of Sandhu, Dominitz, Gao and Tannenbaum, "Volumetric Mapping of Genus Zero Objects via Mass
 * Preservation", as a mini-pipeline:
 *
 *   A  LabelConditioningImageFilter            label -> signed distance on an isotropic grid, genus 0
 *   B  LevelSetToShellOrderingImageFilter      Chan-Vese fronts -> nested shells
 *   C-I, K  moserhex::meshSolid                shell surfaces, sphere maps, initial map, smoothing, volumetric flow
 *
 * Output: (2N)^3 points and (2N-1)^3 hexahedra in lattice order, LPS millimetres, double precision. Point data: lattice
 * index and shell number; cell data: shell number and volume ratio (see itkHexMeshConversion.h).
 *
 * \par Errors
 * InvalidInputError (the label is absent, empty, too thin, or not of genus 0: the description has the numbers),
 * NotConvergedError (a stage did not reach what it promises), ProcessAborted. The output is left empty then.
 *
 * The result is the same, byte for byte, for any number of work units. */
template <typename TLabelImage, typename TMesh = LatticeHexMesh>
class MassPreservingHexahedralMeshFilter : public ImageToMeshFilter<TLabelImage, TMesh>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MassPreservingHexahedralMeshFilter);

  using Self = MassPreservingHexahedralMeshFilter;
  using Superclass = ImageToMeshFilter<TLabelImage, TMesh>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(MassPreservingHexahedralMeshFilter);

  using LabelImageType = TLabelImage;
  using LabelType = typename TLabelImage::PixelType;
  using MeshType = TMesh;
  using LevelSetImageType = Image<double, 3>;
  using ConditioningFilterType = LabelConditioningImageFilter<TLabelImage, LevelSetImageType>;
  using OrderingFilterType = LevelSetToShellOrderingImageFilter<LevelSetImageType>;
  using ShellMethod = typename OrderingFilterType::MethodEnum;

  /** Which label to mesh. Default 1. */
  itkSetMacro(Label, LabelType);
  itkGetConstMacro(Label, LabelType);

  /** N, the number of shells; the lattice has 2N nodes a side. Default 10. */
  itkOptionMacro(NumberOfShells, int, shells);

  /** The last stage to run: Initial, Smoothed or Moser (default). */
  itkOptionMacro(LastStage, moserhex::MeshingStage, lastStage);

  /** How the shells are found: coupled Chan-Vese fronts (default), uncoupled snapshots, or the eikonal limit. */
  itkSetEnumMacro(ShellMethod, ShellMethod);
  itkGetConstMacro(ShellMethod, ShellMethod);

  /** All options of stages C to I. */
  void
  SetMeshingOptions(const moserhex::SolidMeshingOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  const moserhex::SolidMeshingOptions &
  GetMeshingOptions() const
  {
    return m_Options;
  }

  /** The mesh as a Core structure; the same points as the output. */
  const moserhex::HexMesh &
  GetHexMesh() const
  {
    return m_Result.mesh;
  }

  /** Every stage with its time and, from the initial map on, the quality of the mesh after it. */
  const std::vector<moserhex::MeshingStageReport> &
  GetStages() const
  {
    return m_Result.stages;
  }

  /** Shells, sphere maps, boundary distance and warnings of the last run. */
  const moserhex::SolidMeshingResult &
  GetResult() const
  {
    return m_Result;
  }

  /** What conditioning did to the label. */
  const moserhex::ConditioningReport &
  GetConditioningReport() const
  {
    return m_ConditioningReport;
  }

  /** Volume of the label, voxels times voxel volume [mm^3]. */
  itkGetConstMacro(LabelVolume, double);

protected:
  MassPreservingHexahedralMeshFilter() = default;
  ~MassPreservingHexahedralMeshFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** Runs a filter of the mini-pipeline, its progress mapped to [from, to], abort passed on, errors with their kind. */
  template <typename TFilter>
  double
  RunStage(TFilter * filter, double from, double to);

  LabelType                     m_Label{ 1 };
  ShellMethod                   m_ShellMethod{ ShellMethod::ChanVese };
  moserhex::SolidMeshingOptions m_Options;
  moserhex::SolidMeshingResult  m_Result;
  moserhex::ConditioningReport  m_ConditioningReport;
  double                        m_LabelVolume{ 0.0 };
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkMassPreservingHexahedralMeshFilter.hxx"
#endif

#endif
