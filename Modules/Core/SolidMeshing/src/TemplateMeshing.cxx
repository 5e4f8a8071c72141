#include "BoundaryProjection.h"
#include "CellMasses.h"
#include "ExactStage.h"
#include "FrameSearch.h"
#include "ReferenceTie.h"
#include "RefinedTie.h"
#include "RefinementCheck.h"
#include "StageLog.h"
#include "TemplatePlacement.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

/** Parts of the whole run, for progress only. */
constexpr double afterPlacement = 0.1;
constexpr double afterTying = 0.5;

void
requireUsable(const SolidMeshingOptions & options)
{
  const auto require = [](bool holds, const std::string & text) {
    if (!holds)
    {
      throw InvalidInput("template: " + text);
    }
  };
  require(options.templateMesh.has_value(), "there is none");
  require(options.templateMesh->paddingLayers == 0, "it has padding");
  requireLattice(*options.templateMesh);
  require(options.templateMesh->nodesPerSide == 2 * options.shells,
          "it has " + std::to_string(options.templateMesh->nodesPerSide) + " nodes a side, need " +
            std::to_string(2 * options.shells));
  require(!options.templateNodes || options.templateNodes->size() == options.templateMesh->nodes.size(),
          "there are not as many nodes in the solid's space as it has");
  require(options.lastStage == MeshingStage::Exact, "it needs the last stage Exact");
  require(options.density == nullptr || !options.refinement.any(),
          "landmarks and images refine equal volumes, not masses");
  require(!options.refinement.localGrowth || options.refinement.any(), "local growth needs landmarks or images");
  require(options.paddingLayers == 0, "a mesh that is tied to one has no padding");
}

/** Runs an equalisation that starts from the template: what it refuses is the template's fault, as the solid has been
 * conditioned. */
template <typename TWork>
EqualisationResult
startingFromTemplate(const TWork & work)
{
  try
  {
    return work();
  }
  catch (const InvalidInput & error)
  {
    throw InvalidInput(error.code() == ErrorCode::Precondition ? ErrorCode::Template : error.code(), error.what());
  }
}

/** One run: what a step leaves for those after it. */
class TemplateRun
{
public:
  TemplateRun(const LevelSet & phi, double volume, const SolidMeshingOptions & options)
    : m_Phi(phi), m_PhiAt(phi), m_Volume(volume), m_Options(options), m_Log(m_Result.stages)
  {}

  [[nodiscard]] SolidMeshingResult
  run(const ProgressCallback & progress)
  {
    m_Result.warnings = checkRefinement(*m_Options.templateMesh, m_Options.refinement, m_Phi, m_Volume);
    place();
    reportProgress(progress, afterPlacement);
    const bool isRefined = m_Options.refinement.any();
    const bool hasDensity = m_Options.density != nullptr;
    tie(progressBetween(progress, afterPlacement, isRefined || hasDensity ? afterTying : 1.0));
    if (isRefined)
    {
      refine(progressBetween(progress, afterTying, 1.0));
    }
    if (hasDensity)
    {
      equaliseMasses(progressBetween(progress, afterTying, 1.0));
    }
    const TriangleMesh       surface = marchingTetrahedra(m_Result.simplerSolid ? *m_Result.simplerSolid : m_Phi, 0.0);
    const ClosestPointSearch search(surface);
    m_Result.boundary = boundaryDistance(m_Result.mesh, nearestPointOn(search, phiAt(), 0.0));
    requireExact(m_Options, m_Result);
    reportProgress(progress, 1.0);
    return std::move(m_Result);
  }

private:
  void
  place()
  {
    PlacedTemplate placed = placeTemplate(m_Options, m_Phi, m_Volume);
    m_Reference = std::move(placed.mesh);
    m_Result.alignment = placed.alignment;
    m_Result.templateFit = placed.fit;
    if (placed.alignment && !placed.alignment->report.converged)
    {
      m_Result.warnings.emplace_back("the alignment of the template stopped before its minimum");
    }
    m_Log.add("template", m_Reference, placed.note);
  }

  void
  tie(const ProgressCallback & progress)
  {
    const VolumeMeasure       volumes;
    const EqualisationOptions options = equalisationOptions(m_Options);
    const bool                hasOther = static_cast<bool>(m_Options.ownMesh);
    ReferenceTie              tie(m_Reference.nodes, m_Volume, volumes, options);
    EqualisationResult        tied = startingFromTemplate([&] {
      return tie.tied(m_Reference, signedDistance(m_PhiAt), progressBetween(progress, 0.0, hasOther ? 0.5 : 1.0));
    });
    std::string               note;
    if (!tied.exact && hasOther)
    {
      note = drawOwnMesh(tie, tied, progressBetween(progress, 0.5, 1.0));
    }
    m_SurfaceTolerance = tie.surfaceTolerance();
    take("exact", std::move(tied), note, tie.attempts());
  }

  /** Replaces a tied mesh that is not exact. \return what was done, for the report */
  std::string
  drawOwnMesh(ReferenceTie & tie, EqualisationResult & tied, const ProgressCallback & progress)
  {
    std::optional<OwnMesh> own = m_Options.ownMesh();
    if (!own)
    {
      return "";
    }
    std::optional<CubicInterpolator> simpler;
    if (own->simplerSolid)
    {
      simpler.emplace(*own->simplerSolid);
    }
    std::optional<EqualisationResult> drawn =
      tie.drawn(own->mesh, signedDistance(simpler ? *simpler : m_PhiAt), progress);
    if (!drawn)
    {
      return "";
    }
    tied = *std::move(drawn);
    m_Result.drawnFromOwnMesh = true;
    if (simpler)
    {
      m_Result.simplerSolid = std::move(own->simplerSolid);
      m_SimplerAt.emplace(*m_Result.simplerSolid);
    }
    m_Result.warnings.emplace_back("no tie from the template was exact: the solid's own mesh was drawn to it instead");
    return "from the solid's own mesh";
  }

  void
  equaliseMasses(const ProgressCallback & progress)
  {
    const CellMasses          masses(m_Options, m_Result.mesh);
    const EqualisationOptions options = equalisationOptions(m_Options);
    ReferenceTie              tie(m_Reference.nodes, m_Volume, masses.measure(), options);
    take("masses", tie.tied(m_Result.mesh, signedDistance(phiAt()), progress), "", tie.attempts());
    masses.report(m_Result);
  }

  void
  take(const std::string &              stage,
       EqualisationResult &&            tied,
       std::string                      note,
       const std::vector<std::string> & attempts)
  {
    take(std::move(tied));
    std::string separator = note.empty() ? "" : "; ";
    for (const std::string & attempt : attempts)
    {
      note += std::exchange(separator, "; ") + attempt;
    }
    m_Result.attempts.insert(m_Result.attempts.end(), attempts.begin(), attempts.end());
    m_Log.add(stage, m_Result.mesh, note);
  }

  void
  refine(const ProgressCallback & progress)
  {
    if (!m_Result.equalisation->exact)
    {
      m_Result.warnings.emplace_back("not refined, as the mesh is not exact");
      return;
    }
    EqualisationOptions options = equalisationOptions(m_Options);
    options.surfaceTolerance = m_SurfaceTolerance;
    RefinedTie         refinement(*m_Options.templateMesh, m_Options.refinement, m_Volume, options);
    EqualisationResult tied = *m_Result.equalisation;
    tied.mesh = m_Result.mesh;
    RefinedTieResult refined = refinement.refined(tied, signedDistance(phiAt()), progress);
    m_Result.refinement = refined.report;
    m_Result.warnings.insert(m_Result.warnings.end(), refined.warnings.begin(), refined.warnings.end());
    take("refined", std::move(refined.equalisation), describe(refined.report), refined.attempts);
  }

  [[nodiscard]] static std::string
  describe(const TemplateRefinementResult & report)
  {
    std::ostringstream text;
    if (report.landmarkError)
    {
      text << "landmarks " << report.landmarkError->before << " -> " << report.landmarkError->after << " mm";
    }
    if (report.imageDifference)
    {
      text << (report.landmarkError ? ", " : "") << "image difference " << report.imageDifference->before << " -> "
           << report.imageDifference->after << " standard deviations";
    }
    if (report.growth)
    {
      text << ", growth of cells " << report.growth->smallest << " to " << report.growth->largest
           << " times the organ's";
    }
    return text.str();
  }

  void
  take(EqualisationResult && equalised)
  {
    m_Result.mesh = std::move(equalised.mesh);
    equalised.mesh = {};
    m_Result.equalisation = std::move(equalised);
  }

  /** Of the solid that is meshed. */
  [[nodiscard]] const CubicInterpolator &
  phiAt() const
  {
    return m_SimplerAt ? *m_SimplerAt : m_PhiAt;
  }

  const LevelSet &                 m_Phi;
  CubicInterpolator                m_PhiAt;
  double                           m_Volume;
  const SolidMeshingOptions &      m_Options;
  HexMesh                          m_Reference;               ///< the template at the solid
  double                           m_SurfaceTolerance{ 0.0 }; ///< within which the tied mesh was exact [mm]
  SolidMeshingResult               m_Result;
  std::optional<CubicInterpolator> m_SimplerAt; ///< of m_Result.simplerSolid
  StageLog                         m_Log;
};

} // namespace

SolidMeshingResult
meshOnTemplate(const LevelSet &            phi,
               double                      volume,
               const SolidMeshingOptions & options,
               const ProgressCallback &    progress)
{
  requireUsable(options);
  return TemplateRun(phi, volume, options).run(progress);
}

} // namespace moserhex
