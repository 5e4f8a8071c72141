#include "RefinedTie.h"

#include "CellShares.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

/** w_r while landmarks and images draw: against the tied mesh [1]. */
constexpr double referenceWeight = 0.1;
/** Of the ties of a refinement, until it is exact. */
constexpr std::array<double, 3> pulls{ { 1.0, 0.3, 0.1 } };
/** Times that volumes are found and the images' grey values, which depend on them, are compared anew, at each scale. */
constexpr std::size_t growthRounds = 3;

/** w_r, w_i and w_v while volumes are found. Springs and images are ten times as strong against the cells' shapes,
 * which are no material, as for equal cells, and volumes are hardly held: a ball of twice the volume is found with
 * nearly all of it (LocalGrowth.*). */
constexpr double                     looseReferenceWeight = 1.0;
constexpr double                     looseImageWeight = 10.0;
const std::vector<EqualisationStage> looseStages{ { 0.05, 0.1, 80.0, 60 }, { 0.02, 0.1, 80.0, 60 } };

} // namespace

RefinedTie::RefinedTie(const HexMesh &             templateMesh,
                       const TemplateRefinement &  refinement,
                       double                      volume,
                       const EqualisationOptions & options)
  : m_Refinement(refinement)
  , m_Refiner(templateMesh, refinement)
  , m_Volume(volume)
  , m_Options(options)
  , m_TemplateShares(cellShares(templateMesh))
{
  m_Options.ties = {};
  m_Options.ties.referenceWeight = referenceWeight;
}

RefinedTieResult
RefinedTie::refined(const EqualisationResult & tied, const SignedDistance & phi, const ProgressCallback & progress)
{
  m_Result = {};
  m_Result.equalisation = tied;
  m_Shares.assign(m_TemplateShares.size(), 1.0);
  m_Options.ties.reference = tied.mesh.nodes;
  m_Result.report.complete = true;
  if (!m_Refinement.localGrowth)
  {
    m_Options.ties.landmarks = m_Refiner.landmarks();
    refineAtScales(phi, false, progress);
  }
  else
  {
    findGrowth(phi, progress);
  }
  if (!m_Result.report.complete)
  {
    m_Result.warnings.emplace_back("the refinement stopped early, as further meshes were not exact");
  }
  judge(tied);
  return std::move(m_Result);
}

void
RefinedTie::findGrowth(const SignedDistance & phi, const ProgressCallback & progress)
{
  if (m_Refinement.images)
  {
    refineAtScales(phi, false, progressBetween(progress, 0.0, 0.3));
  }
  m_Options.ties.landmarks = m_Refiner.landmarks();
  m_Options.ties.reference = m_Result.equalisation.mesh.nodes;
  m_Options.ties.rest = m_Result.equalisation.mesh.nodes;
  if (m_Result.report.complete)
  {
    refineAtScales(phi, true, progressBetween(progress, 0.3, 1.0));
  }
}

void
RefinedTie::refineAtScales(const SignedDistance & phi, bool findsGrowth, const ProgressCallback & progress)
{
  const std::vector<double> scales = m_Refiner.scales();
  const std::size_t         rounds = findsGrowth ? growthRounds : 1;
  for (std::size_t s = 0; s < scales.size() * rounds && m_Result.report.complete; ++s)
  {
    if (m_Refinement.images)
    {
      m_Options.ties.image = m_Refiner.image(m_Result.equalisation.mesh, scales[s / rounds]);
    }
    m_Result.report.complete = refineOnce(phi, findsGrowth, progressOfPart(progress, s, scales.size() * rounds));
    if (m_Result.report.complete)
    {
      m_Sharpest = m_Options.ties.image;
    }
  }
}

HexMesh
RefinedTie::loosened(const SignedDistance & phi, const ProgressCallback & progress) const
{
  EqualisationOptions options = m_Options;
  options.directStages = looseStages;
  options.ties.referenceWeight = looseReferenceWeight;
  options.ties.imageWeight = looseImageWeight;
  return minimisedLattice(
    m_Result.equalisation.mesh, phi, m_Volume, SharedVolumeMeasure(m_TemplateShares), options, progress);
}

bool
RefinedTie::refineOnce(const SignedDistance & phi, bool findsGrowth, const ProgressCallback & progress)
{
  HexMesh     start = m_Result.equalisation.mesh;
  GrownShares grown{ m_Shares };
  if (findsGrowth)
  {
    start = loosened(phi, progressBetween(progress, 0.0, 0.4));
    grown = grownShares(start, m_TemplateShares);
  }
  const ProgressCallback ofPulls = progressBetween(progress, findsGrowth ? 0.4 : 0.0, 1.0);
  const LatticeTies      whole = m_Options.ties;
  for (std::size_t p = 0; p < pulls.size(); ++p)
  {
    std::vector<double> shares = partlyGrown(m_Shares, grown.shares, pulls[p]);
    EqualisationOptions options = m_Options;
    options.ties.landmarkWeight = pulls[p] * whole.landmarkWeight;
    options.ties.imageWeight = pulls[p] * whole.imageWeight;
    EqualisationResult made = equaliseMeasures(p == 0 ? start : m_Result.equalisation.mesh,
                                               phi,
                                               m_Volume,
                                               SharedVolumeMeasure(shares),
                                               m_Volume,
                                               options,
                                               progressOfPart(ofPulls, p, pulls.size()));
    if (made.exact)
    {
      m_Result.equalisation = std::move(made);
      m_Result.report.smallestPull = std::min(m_Result.report.smallestPull, pulls[p]);
      if (findsGrowth)
      {
        m_Result.report.growth = growthBetween(m_TemplateShares, shares);
        m_Result.report.growth->limited = grown.limited;
      }
      m_Shares = std::move(shares);
      return true;
    }
    std::ostringstream text;
    text << "refinement by " << pulls[p] << " of the pull: not exact";
    m_Result.attempts.push_back(text.str());
  }
  return false;
}

void
RefinedTie::leaveOut(const EqualisationResult & tied)
{
  TemplateRefinementResult & report = m_Result.report;
  m_Result.equalisation = tied;
  report.growth.reset();
  report.smallestPull = 1.0;
  for (std::optional<RefinedResidual> * residual : { &report.landmarkError, &report.imageDifference })
  {
    if (*residual)
    {
      (*residual)->after = (*residual)->before;
    }
  }
}

void
RefinedTie::judge(const EqualisationResult & tied)
{
  TemplateRefinementResult & report = m_Result.report;
  const HexMesh &            mesh = m_Result.equalisation.mesh;
  bool                       isNearer = false;
  std::string                farther;
  const auto                 compare = [&](const char * what, double before, double after) {
    isNearer = isNearer || after < before;
    farther = after > before ? what : farther;
    return RefinedResidual{ before, after };
  };
  if (!m_Refiner.landmarks().empty())
  {
    report.landmarkError =
      compare("landmarks", landmarkError(tied.mesh, m_Refiner.landmarks()), landmarkError(mesh, m_Refiner.landmarks()));
  }
  if (m_Sharpest)
  {
    report.imageDifference =
      compare("images", imageDifference(tied.mesh, *m_Sharpest), imageDifference(mesh, *m_Sharpest));
  }
  if (!isNearer)
  {
    m_Result.warnings.emplace_back("the refinement brought neither landmarks nor images nearer to each other, and was "
                                   "left out");
    leaveOut(tied);
  }
  else if (!farther.empty())
  {
    m_Result.warnings.push_back("the refinement brought the " + farther + " farther from each other");
  }
  if (report.smallestPull < 1.0)
  {
    std::ostringstream text;
    text << "refined by " << report.smallestPull << " of the pull only, as with more the mesh was not exact";
    m_Result.warnings.push_back(text.str());
  }
  if (m_Refinement.localGrowth && !report.growth)
  {
    m_Result.warnings.emplace_back("local growth was not found: all cells are equal");
  }
  if (report.growth && report.growth->limited > 0)
  {
    m_Result.warnings.push_back("local growth: " + std::to_string(report.growth->limited) +
                                " cells would have grown or shrunk by more than a factor of 8, and were kept to it");
  }
}

} // namespace moserhex
