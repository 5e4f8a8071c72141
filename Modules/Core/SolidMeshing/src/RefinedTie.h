#pragma once

#include "TemplateRefiner.h"
#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** What a refinement made of a tied mesh. */
struct RefinedTieResult
{
  EqualisationResult       equalisation; ///< exact, as the mesh was that it started from; with local growth against it
  TemplateRefinementResult report;
  std::vector<std::string> attempts; ///< what did not become exact, in order
  std::vector<std::string> warnings; ///< what a user should be told, one line each
};

/** Draws an exact mesh that is tied to a template, through exact ones, to where landmarks and images say that its
 * places are: images from smooth to sharp, the ties of each as strong as leaves the mesh exact.
 *
 * With local growth the volumes are found, too, in rounds. The energy is minimised with cells that are hardly held to
 * parts of the organ, and at rest (LatticeTies::rest), so that only landmarks and images change their volumes; the
 * volumes that they take then (grownShares) are what the cells are made equal to. */
class RefinedTie
{
public:
  /** Keeps references. \param templateMesh  in its own space \param volume  of the solid [mm^3]
   * \param options  their ties are replaced \throws InvalidInput  as TemplateRefiner */
  RefinedTie(const HexMesh &             templateMesh,
             const TemplateRefinement &  refinement,
             double                      volume,
             const EqualisationOptions & options);

  /** \param tied  exact */
  [[nodiscard]] RefinedTieResult
  refined(const EqualisationResult & tied, const SignedDistance & phi, const ProgressCallback & progress);

private:
  /** First equal cells to where images are alike, then their growth from that mesh, at rest: a turn is no growth, but
   * would be resisted by cells at rest. Equal cells that had followed landmarks would leave no growth to be seen. */
  void
  findGrowth(const SignedDistance & phi, const ProgressCallback & progress);

  /** By images from smooth to sharp, until a mesh is not exact. \param findsGrowth  the volumes, too, in rounds */
  void
  refineAtScales(const SignedDistance & phi, bool findsGrowth, const ProgressCallback & progress);

  /** One equalisation and, where that is not exact, with weaker ties. \return whether an exact mesh came of it */
  bool
  refineOnce(const SignedDistance & phi, bool findsGrowth, const ProgressCallback & progress);

  /** The mesh with the present ties when its cells are hardly held to their volumes. */
  [[nodiscard]] HexMesh
  loosened(const SignedDistance & phi, const ProgressCallback & progress) const;

  /** Back to the tied mesh. */
  void
  leaveOut(const EqualisationResult & tied);

  void
  judge(const EqualisationResult & tied);

  const TemplateRefinement &  m_Refinement;
  TemplateRefiner             m_Refiner;
  double                      m_Volume;
  EqualisationOptions         m_Options;
  std::vector<double>         m_TemplateShares; ///< of its cells [1]
  std::vector<double>         m_Shares;         ///< of the present mesh [1]
  std::optional<LatticeImage> m_Sharpest;       ///< of the images that led to an exact mesh
  RefinedTieResult            m_Result;
};

} // namespace moserhex
