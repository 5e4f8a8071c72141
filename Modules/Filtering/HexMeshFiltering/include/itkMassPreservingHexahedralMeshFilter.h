#ifndef itkMassPreservingHexahedralMeshFilter_h
#define itkMassPreservingHexahedralMeshFilter_h

#include "itkCoreAlgorithm.h"
#include "itkDensityConversion.h"
#include "itkHexMeshConversion.h"
#include "itkLabelConditioningImageFilter.h"
#include "itkLabelVolumeConversion.h"
#include "itkLevelSetToShellOrderingImageFilter.h"

#include "moserhex/LevelSet/CoarseSolid.h"
#include "moserhex/LevelSet/LabelDensity.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <itkImageToMeshFilter.h>

#include <optional>
#include <string>
#include <tuple>
#include <utility>

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
 *   C-K  moserhex::meshSolid                   shell surfaces, sphere maps, initial map, smoothing, volumetric flow,
 *                                            equalisation
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

  ///@{
  /** Of the input and the output. */
  using LabelImageType = TLabelImage;
  using LabelType = typename TLabelImage::PixelType;
  using MeshType = TMesh;
  ///@}

  ///@{
  /** Of the mini-pipeline. */
  using LevelSetImageType = Image<double, 3>;
  using ConditioningFilterType = LabelConditioningImageFilter<TLabelImage, LevelSetImageType>;
  using OrderingFilterType = LevelSetToShellOrderingImageFilter<LevelSetImageType>;
  ///@}

  using ShellMethod = typename OrderingFilterType::MethodEnum; ///< ChanVese, Snapshots or Eikonal

  /** Which label to mesh. Default 1. */
  itkSetMacro(Label, LabelType);
  itkGetConstMacro(Label, LabelType);

  /** N, the number of shells; the lattice has 2N nodes a side. Default 10. */
  itkOptionMacro(NumberOfShells, int, shells);

  /** The last stage to run: Initial, Smoothed, Moser or Exact (default). */
  itkOptionMacro(LastStage, moserhex::MeshingStage, lastStage);

  /** Where the exact mesh starts from: the initial map of three shells (Fast, default), or stages A to I with all
   * shells (Faithful). */
  itkOptionMacro(Way, moserhex::MeshingWay, way);

  /** How the cube is turned against the body: Anatomical (default) or Ridge. */
  itkOptionMacro(Frame, moserhex::LatticeFrame, frame);

  /** L, layers of pillow cells around the lattice, for finite elements: no cell is left with two faces on the surface.
   * Default 0. Only with the last stage Exact. */
  itkOptionMacro(PaddingLayers, int, paddingLayers);

  /** A lattice of as many shells that the mesh is to be like, node by node, in place of stages B to I: see
   * moserhex::meshOnTemplate. By default there is none. Only with the last stage Exact and without padding; with a
   * density the cells are made equal by mass, and a TemplateRefinement is refused. */
  void
  SetTemplateMesh(std::optional<moserhex::HexMesh> mesh)
  {
    m_Options.templateMesh = std::move(mesh);
    this->Modified();
  }
  /** \copydoc SetTemplateMesh */
  const std::optional<moserhex::HexMesh> &
  GetTemplateMesh() const
  {
    return m_Options.templateMesh;
  }

  /** How the template is brought to the label: Rigid (default), Affine or None. */
  itkOptionMacro(TemplateAlignment, moserhex::TemplateAlignment, templateAlignment);

  /** The template's nodes in the label's space, where a transform takes them there; in place of an alignment. */
  void
  SetTemplateNodes(std::optional<moserhex::Positions> nodes)
  {
    m_Options.templateNodes = std::move(nodes);
    this->Modified();
  }
  /** \copydoc SetTemplateNodes */
  const std::optional<moserhex::Positions> &
  GetTemplateNodes() const
  {
    return m_Options.templateNodes;
  }

  /** Landmarks and images of both subjects that say more than the shapes do about where the template's places are. By
   * default there are none. Needs a template. */
  void
  SetTemplateRefinement(moserhex::TemplateRefinement refinement)
  {
    m_Options.refinement = std::move(refinement);
    this->Modified();
  }
  /** \copydoc SetTemplateRefinement */
  const moserhex::TemplateRefinement &
  GetTemplateRefinement() const
  {
    return m_Options.refinement;
  }

  using DensityImageType = Image<double, 3>; ///< any unit

  /** A positive density on the label's space: cells get equal masses instead of equal volumes. The grid may differ from
   * the label's. Optional; only with the last stage Exact. */
  itkSetInputMacro(DensityImage, DensityImageType);
  itkGetInputMacro(DensityImage, DensityImageType);

  /** Whether a label that is not one solid of genus 0 is repaired (default) or refused. */
  void
  SetTopologyPolicy(moserhex::TopologyPolicy policy)
  {
    if (m_TopologyPolicy != policy)
    {
      m_TopologyPolicy = policy;
      this->Modified();
    }
  }
  /** \copydoc SetTopologyPolicy */
  moserhex::TopologyPolicy
  GetTopologyPolicy() const
  {
    return m_TopologyPolicy;
  }

  /** Most that a repair may change, relative to the label [1]. */
  itkSetMacro(MaximumRepair, double);
  itkGetConstMacro(MaximumRepair, double);

  /** Give out a mesh that is not exact, with a warning, where NotConvergedError would be thrown: the best of the same
   * attempts. Default false. */
  itkOptionMacro(AllowPartial, bool, allowPartial);

  /** How the shells are found: coupled Chan-Vese fronts, uncoupled snapshots, or the eikonal limit. Until it is set,
   * the eikonal limit for the fast way, whose few shells only start the optimisation, and Chan-Vese for all else. */
  void
  SetShellMethod(ShellMethod method)
  {
    m_ShellMethod = method;
    this->Modified();
  }
  /** The method that the next run takes: the one set or, until then, the one that the other options lead to. */
  ShellMethod
  GetShellMethod() const
  {
    return m_ShellMethod.value_or(moserhex::shellsToExtract(m_Options) < m_Options.shells ? ShellMethod::Eikonal
                                                                                          : ShellMethod::ChanVese);
  }

  /** All options of stages C to J. */
  void
  SetMeshingOptions(const moserhex::SolidMeshingOptions & options)
  {
    m_Options = options;
    this->Modified();
  }
  /** \copydoc SetMeshingOptions */
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

  /** What conditioning did to the label; `repair` in it: to its topology. */
  const moserhex::ConditioningReport &
  GetConditioningReport() const
  {
    return m_ConditioningReport;
  }

  /** The density of the last run on the label, with its mean and mass there; empty when none was set. */
  const std::optional<moserhex::LabelDensity> &
  GetLabelDensity() const
  {
    return m_LabelDensity;
  }

  /** Volume of the label after its repair, voxels times voxel volume [mm^3]. */
  itkGetConstMacro(LabelVolume, double);

protected:
  MassPreservingHexahedralMeshFilter() = default;
  ~MassPreservingHexahedralMeshFilter() override = default;

  /** \throws ExceptionObject  no input; shells out of 2 to 64; a density without the last stage Exact; a refinement
   * without a template */
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

  /** Shells of `orderedPhi` in one way, then stages C to K; `orderingStage` says what was done before. */
  moserhex::SolidMeshingResult
  MeshFrom(moserhex::SolidMeshingOptions options,
           ShellMethod                   method,
           const moserhex::LevelSet &    orderedPhi,
           const moserhex::LevelSet &    phi,
           moserhex::MeshingStageReport  orderingStage);

  /** The repaired label made simpler, for shapes whose details are narrower than the cells; nothing where that is not
   * faithful to the label. */
  std::optional<moserhex::LevelSet>
  SimplerSolid(const moserhex::LabelVolume & label, moserhex::Simplification simplification);

  /** With its threads and its density. */
  moserhex::SolidMeshingOptions
  OptionsOfRun();

  moserhex::SolidMeshingOptions
  OptionsWithSimplerSolid(const moserhex::LabelVolume & label); // keeps a reference to the label

  /** With the shells of GetShellMethod(), those of the fast way from a coarse grid. */
  moserhex::SolidMeshingResult
  MeshFromUsualShells(const moserhex::SolidMeshingOptions & options, const moserhex::LevelSet & phi);

  /** The same, and with Chan-Vese shells when that does not lead to an exact mesh. AllowPartial changes no attempt, so
   * it never takes an exact mesh away; of meshes that are not exact the better one is kept. */
  moserhex::SolidMeshingResult
  MeshFromBestShells(const moserhex::SolidMeshingOptions & options, const moserhex::LevelSet & phi);

  /** Made without the template, by volumes and in its own frame, of a simpler solid where that is needed; nothing where
   * that is not exact. */
  std::optional<moserhex::OwnMesh>
  OwnMesh(const moserhex::LevelSet & phi, const moserhex::LabelVolume & label);

  /** Tied to the template. */
  moserhex::SolidMeshingResult
  MeshOnTemplate(const moserhex::LevelSet & phi, const moserhex::LabelVolume & label);

  void
  PutDensityOnLabel(const moserhex::LabelVolume & label);

  /** Smaller is better; after stage J only. */
  static auto
  Badness(const moserhex::SolidMeshingResult & result)
  {
    const moserhex::EqualisationResult & equalised = *result.equalisation;
    return std::make_tuple(
      !equalised.exact, equalised.concaveCells, equalised.uncertifiedCells, equalised.largestDistance);
  }

  /** Parts of the whole run, for progress only. */
  static constexpr double afterConditioning = 0.15;
  static constexpr double afterOrdering = 0.3;

  /** A simpler solid whose Dice coefficient with the label is below this is a warning, not only a note [1]. */
  static constexpr double noteworthyDice = 0.98;

  LabelType                     m_Label{ 1 };
  std::optional<ShellMethod>    m_ShellMethod;
  moserhex::TopologyPolicy      m_TopologyPolicy{ moserhex::ConditioningOptions{}.topology };
  double                        m_MaximumRepair{ moserhex::ConditioningOptions{}.maximumRepair };
  moserhex::SolidMeshingOptions m_Options;
  moserhex::SolidMeshingResult  m_Result;
  moserhex::ConditioningReport  m_ConditioningReport;

  std::optional<moserhex::ConditioningReport> m_SimplerReport; ///< of the last SimplerSolid()
  double                                      m_LabelVolume{ 0.0 };

  std::optional<moserhex::LabelDensity> m_LabelDensity;
};

} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#include "itkMassPreservingHexahedralMeshFilter.hxx"
#endif

#endif
