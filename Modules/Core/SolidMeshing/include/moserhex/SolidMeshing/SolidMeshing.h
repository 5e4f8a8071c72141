#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMap/FramePlacement.h"
#include "moserhex/HexMap/InitialMap.h"
#include "moserhex/HexMap/LatticeSmoothing.h"
#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/HexMap/VolumetricMoserFlow.h"
#include "moserhex/LevelSet/Density.h"
#include "moserhex/LevelSet/LabelConditioning.h"
#include "moserhex/LevelSet/ShellSurfaces.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/SolidMeshing/SurfaceAlignment.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"
#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** Where the mesh is taken from the chain. */
enum class MeshingStage
{
  Initial,  ///< after stage G: shells remeshed with the cube's nodes
  Smoothed, ///< after stage H: smoothed
  Moser,    ///< after stage I: the volume-preserving flow
  Exact     ///< after stage J: equalised
};

/** Where stage J starts from. */
enum class MeshingWay
{
  Fast,    ///< the initial map of few shells, refined while it is equalised; stages H and I are left out
  Faithful ///< stages A to I with all shells, then equalised
};

/** How the cube is turned against the body. */
enum class LatticeFrame
{
  Anatomical, ///< i, j, k along the patient's axes as well as the sphere map allows
  Ridge       ///< turned a little so that the cube's edges leave hollows and follow ridges
};

/** How a template is brought to a solid before its nodes are moved. */
enum class TemplateAlignment
{
  None,  ///< it lies where it belongs, for example in the same scan
  Rigid, ///< by alignToSurface
  Affine ///< the same, also stretched and sheared
};

/** An exact mesh of a solid that was made without a template, in its own frame. */
struct OwnMesh
{
  HexMesh                 mesh;         ///< of as many nodes as the template
  std::optional<LevelSet> simplerSolid; ///< the solid that was meshed when it is not phi, same grid or another
};

/** Options of meshSolid and meshOnTemplate. */
struct SolidMeshingOptions
{
  int                 shells{ 10 };                     ///< N; the lattice has 2N nodes a side
  MeshingStage        lastStage{ MeshingStage::Exact }; ///< the mesh is taken after it
  MeshingWay          way{ MeshingWay::Fast };          ///< matters only when the last stage is Exact
  int                 fastShells{ 3 };                  ///< shells of the fast way, at most N of them are used
  std::vector<double> volumeFractions;                  ///< of the shells; empty: the cube's own, ((2k-1)/(2N-1))^3

  LatticeFrame          frame{ LatticeFrame::Anatomical }; ///< of the lattice against the body
  FramePlacementOptions framePlacement;                    ///< for LatticeFrame::Ridge; its thread count is replaced
  /** Turned frames, the most promising first, that the fast way meshes at full size when its own does not lead to an
   * exact mesh; 0: none [1]. */
  int turnedFrames{ 2 };

  /** The same solid made simpler, or nothing when that would lose too much of the label: a lattice cannot carry what is
   * narrower than its cells. Asked for a smoother one when the own frame does not lead to an exact mesh of phi, and for
   * a rounder one when turned frames do not, either. Empty: no such attempts. */
  std::function<std::optional<LevelSet>(Simplification simplification)> simplerSolid;

  ShellSurfaceOptions        surfaces;     ///< stage C; its thread count is replaced by `threads`
  AreaPreservingMapOptions   sphereMap;    ///< stages D, E
  CubeShellMapOptions        cubeShells;   ///< stage F
  LatticeSmoothingOptions    smoothing;    ///< stage H
  VolumetricMoserFlowOptions flow;         ///< stage I
  EqualisationOptions        equalisation; ///< stage J; its size and thread count are replaced

  /** L, layers of pillow cells around the lattice after stage J, all cells of lattice and layers equal (Padding.h).
   * Only with the last stage Exact; refused otherwise. */
  int paddingLayers{ 0 };

  /** A lattice of N shells that the mesh is to be like, node by node: see meshOnTemplate. Empty: none. */
  std::optional<HexMesh> templateMesh;
  TemplateAlignment      templateAlignment{ TemplateAlignment::Rigid }; ///< how it is brought to the solid
  /** Its nodes in the solid's space, as many, where a transform takes them there [mm]; in place of templateAlignment.
   */
  std::optional<Positions> templateNodes;
  /** The solid meshed on its own. Asked for when the template does not lead to an exact mesh: then this one is drawn to
   * it. Empty, or nothing: no such attempt. */
  std::function<std::optional<OwnMesh>()> ownMesh;
  TemplateRefinement                      refinement; ///< of a mesh that is tied; needs a template

  /** Every cell gets the same mass under this density, of mean 1 over the organ, instead of the same volume. Not owned;
   * null: volumes. Only with the last stage Exact; refused otherwise. */
  const Density * density{ nullptr };
  double          densityAccuracy{ 1e-4 }; ///< of a cell's mass against the mean mass [1]

  /** Return a mesh that is not exact, with a warning, where NotConverged would be thrown. */
  bool allowPartial{ false };

  unsigned int threads{ 0 }; ///< 0: all of the machine's; the result does not depend on it
};

/** Most layers of padding. */
constexpr int largestPadding = 8;

/** Shells that are cut out and mapped: N, or those of the fast way. */
[[nodiscard]] int
shellsToExtract(const SolidMeshingOptions & options);

/** What a stage did and, from stage G on, the quality of the mesh after it. */
struct MeshingStageReport
{
  std::string                      name;           ///< "shell surfaces", "sphere maps", "initial map", ...
  double                           seconds{ 0.0 }; ///< wall time [s]
  std::optional<HexQualitySummary> quality;        ///< of the mesh; empty before stage G
  std::string                      note;           ///< empty when there is nothing to say
};

/** Distance of the mesh's boundary to the organ's surface, over boundary nodes and centres of boundary quadrilaterals.
 */
struct BoundaryDistance
{
  double rms{ 0.0 };            ///< [mm]
  double maximum{ 0.0 };        ///< [mm]
  double maximumOfNodes{ 0.0 }; ///< nodes alone [mm]
};

/** How a template lies at a solid before its nodes are moved one by one. */
struct TemplateFit
{
  double scale{ 1.0 };  ///< by which it was made larger in every direction to have the solid's volume [1]
  double rms{ 0.0 };    ///< root mean square distance of its boundary nodes to the solid's surface [mm]
  double median{ 0.0 }; ///< of the same distances' amounts [mm]
  /** The median if the motion nearest to SolidMeshingOptions::templateNodes is taken the other way round: much smaller
   * where those were made with the inverse of the right transform. Only with such nodes [mm]. */
  std::optional<double> medianOfInverse;
};

/** How equal the masses are that stage J made under a density. */
struct MassReport
{
  double variance{ 0.0 };        ///< population variance of mass / mean mass [1]
  double quadratureError{ 0.0 }; ///< estimated, of the worst cell's mass against the mean mass [1]
};

/** What meshSolid and meshOnTemplate made. */
struct SolidMeshingResult
{
  HexMesh                                 mesh;         ///< of the last stage, with its padding
  std::vector<MeshingStageReport>         stages;       ///< in order of execution
  ShellSurfacesSummary                    shells;       ///< stage C
  std::vector<AreaPreservingMapResult>    sphereMaps;   ///< entry k-1 for shell k; positions are emptied
  BoundaryDistance                        boundary;     ///< of the mesh to the surface of the solid that was meshed
  std::optional<FramePlacementResult>     frame;        ///< of LatticeFrame::Ridge
  std::optional<SurfaceAlignmentResult>   alignment;    ///< of a template
  std::optional<TemplateFit>              templateFit;  ///< of a template, as it was placed
  std::optional<TemplateRefinementResult> refinement;   ///< of a tied mesh
  std::optional<LevelSet>                 simplerSolid; ///< the solid that was meshed when it is not phi
  std::string                             turnWarning;  ///< which of the fallback turns was used; empty: none
  Matrix3                                 fallbackTurn{ Matrix3::Identity() }; ///< that turn, see latticeTurn()
  std::vector<std::string>                attempts;                     ///< of stage J, in order, and what came of each
  bool                                    drawnFromOwnMesh{ false };    ///< SolidMeshingOptions::ownMesh, to a template
  bool                                    exactWithoutPadding{ false }; ///< stage J made the lattice alone exact
  std::optional<MassReport>               mass;                         ///< with a density
  std::optional<EqualisationResult>       equalisation;                 ///< stage J; its mesh is emptied
  std::vector<std::string>                warnings;                     ///< what a user should be told, one line each
};

/** How the lattice is turned against the patient's axes, by LatticeFrame::Ridge and by a fallback turn: the rotation
 * that takes the patient's directions to the cube's [1]. The identity where it is not, and of a tied mesh, whose
 * lattice lies as its template's does. */
[[nodiscard]] Matrix3
latticeTurn(const SolidMeshingResult & result);

/** Stages C to K: from a solid and its ordering by volume to a structured hexahedral mesh.
 *
 * Shell surfaces (C) and their area-preserving sphere maps (D, E) are made in parallel over the shells. All maps are in
 * the body's frame; then shell k is turned to match shell k+1 (closest points), so that shells do not twist against
 * each other. Boundary nodes move on {phi = level of shell N} only: the nearest point on shell N's triangles, then
 * Newton.
 *
 * \param ordering  s of shellOrdering: 0 at the seed, 1 on the surface                              [1]
 * \param phi       conditioned solid, negative inside, same grid                                    [mm]
 * \param volume    the label's volume                                                               [mm^3]
 * \throws InvalidInput, NotConverged  as extractShellSurfaces, areaPreservingSphereMap, initialMap,
 * volumetricMoserFlow, equaliseVolumes \throws NotConverged  stage J did not reach what it promises; says which part
 * and by how much; with ErrorCode::Shape, coarse lattices show that no frame will do \throws Cancelled     by the
 * callback \note Deterministic for any number of threads. */
[[nodiscard]] SolidMeshingResult
meshSolid(const LevelSet &            ordering,
          const LevelSet &            phi,
          double                      volume,
          const SolidMeshingOptions & options = {},
          const ProgressCallback &    progress = {});

/** The same with shells from another grid, for the few shells of the fast way, which only start the optimisation.
 *
 * \param ordering    of shellOrdering for `orderedPhi`, same grid as that     [1]
 * \param orderedPhi  the solid on the shells' grid, as of coarseSolid         [mm]
 * \param phi         the solid whose surface the mesh gets, any grid          [mm] */
[[nodiscard]] SolidMeshingResult
meshSolid(const LevelSet &            ordering,
          const LevelSet &            orderedPhi,
          const LevelSet &            phi,
          double                      volume,
          const SolidMeshingOptions & options = {},
          const ProgressCallback &    progress = {});

/** Stage J alone, from another mesh: ties a solid to options.templateMesh, so that lattice indices are the same places
 * in both, as far as their shapes tell.
 *
 * The template is brought to the solid by options.templateAlignment, in the solid's size or, where the two differ by a
 * part only, in its own, and scaled to the solid's volume about its middle; then its boundary is drawn onto the
 * surface, on which it slides, all cells are made equal, and of all ways to do so that one is sought which bends the
 * template least and leaves its boundary nodes nearest to their places (LatticeTies::reference). The less it may be
 * bent, the more like it the mesh is, and the more seldom it becomes exact: weights are tried from large to small.
 * Where no weight leads to an exact mesh, options.ownMesh is drawn to the template instead, by weights from small to
 * large.
 *
 * With options.refinement the exact mesh is then drawn, through exact ones, to where landmarks belong, and to where one
 * subject's image is like the other's (LatticeTies.h), images from smooth to sharp. The last exact mesh counts; what
 * was not reached is a warning.
 *
 * With options.density the cells are then made equal by mass under the same ties: where the density says that one part
 * of the solid has grown, or is the other subject's, its cells grow, and nodes elsewhere stay.
 *
 * With options.refinement.localGrowth the cells' volumes are found, too, and "exact" is against these.
 *
 * result.stages: "template", "exact" and, with a refinement, "refined", with a density, "masses". result.alignment is
 * set where the template is aligned; there are no shells and no sphere maps. Landmarks that lie farther outside of
 * their organ than 5 mm and two mean cell edges are a warning. \throws InvalidInput  no template, one of another size
 * or with padding; padding, another last stage than Exact, or a density together with a refinement is wanted \throws
 * InvalidInput (Template)  the template's cells have no volume, or as it was brought to the solid none of its nodes is
 * inside; (TemplateLandmarks, Landmarks)  all lie outside of their organ; (TemplateImage, Image)  an image does not
 * cover its organ, or is the same everywhere in it; NotConverged, Cancelled  as meshSolid */
[[nodiscard]] SolidMeshingResult
meshOnTemplate(const LevelSet &            phi,
               double                      volume,
               const SolidMeshingOptions & options,
               const ProgressCallback &    progress = {});

} // namespace moserhex
