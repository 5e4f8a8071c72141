#include "ExactStage.h"

#include "CellMasses.h"
#include "FrameSearch.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMap/Padding.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace moserhex
{
namespace
{

EqualisationResult
equalise(const ExactStage &          stage,
         const EqualisationOptions & options,
         const HexMesh &             start,
         const ProgressCallback &    progress)
{
  return equaliseVolumes(start, signedDistance(stage.phi), stage.volume, options, progress);
}

void
keep(EqualisationResult && equalised, SolidMeshingResult & result)
{
  result.mesh = std::move(equalised.mesh);
  equalised.mesh = {};
  result.equalisation = std::move(equalised);
}

/** phi of the solid that is meshed; outlives the stage. */
class MeshedSolid
{
public:
  MeshedSolid(const ExactStage & stage, const SolidMeshingResult & result) : m_Stage(stage)
  {
    if (result.simplerSolid)
    {
      m_Simpler.emplace(*result.simplerSolid);
    }
  }

  [[nodiscard]] SignedDistance
  distance() const
  {
    return signedDistance(m_Simpler ? *m_Simpler : m_Stage.phi);
  }

private:
  const ExactStage &               m_Stage;
  std::optional<CubicInterpolator> m_Simpler;
};

/** Equal masses, from a mesh of equal volumes, on which the quadrature is chosen. */
void
equaliseMasses(const ExactStage &          stage,
               const EqualisationOptions & equalisation,
               SolidMeshingResult &        result,
               const ProgressCallback &    progress)
{
  const MeshedSolid solid(stage, result);
  const CellMasses  masses(stage.options, result.mesh);
  keep(equaliseMeasures(
         result.mesh, solid.distance(), stage.volume, masses.measure(), stage.volume, equalisation, progress),
       result);
  masses.report(result);
}

[[noreturn]] void
refuseShape(const HopelessShape & shape)
{
  std::ostringstream text;
  text << "too thin, bent or sharp for a cube's lattice: in the best of all frames " << shape.uncertifiedCells << " of "
       << shape.cells << " cells" << (shape.isCoarse ? " of a coarse one" : "") << " are not positive";
  throw NotConverged(ErrorCode::Shape, text.str(), {});
}

/** The attempts of stage J, one after the other until a mesh is exact; what came of each is noted in the result. */
class Attempts
{
public:
  Attempts(const ExactStage & stage, SolidMeshingResult & result)
    : m_Stage(stage), m_Result(result), m_Start(result.mesh), m_OwnFrame(equalisationOptions(stage.options))
  {
    if (maybeTurned())
    {
      m_OwnFrame.hopelessCells = std::min(m_OwnFrame.hopelessCells, tangledCells(m_OwnFrame.nodesPerSide));
    }
  }

  void
  run(const ProgressCallback & progress)
  {
    keep(equalise(m_Stage, m_OwnFrame, m_Start, progressBetween(progress, 0.0, maybeTurned() ? 0.2 : 1.0)), m_Result);
    note("own frame");
    const bool wasGivenUp = isGivenUp(*m_Result.equalisation);
    if (!isExact() && m_Stage.options.simplerSolid)
    {
      trySimplerSolid(Simplification::Smoother, progressBetween(progress, 0.2, 0.3));
    }
    if (isExact() || !maybeTurned())
    {
      return;
    }
    const std::optional<HopelessShape> hopeless = tryTurnedFrames(progressBetween(progress, 0.3, 0.6));
    // What not even a coarse lattice can follow is more than details.
    const bool isFarOff = hopeless && hopeless->isCoarse;
    if (!isExact() && !isFarOff && m_Stage.options.simplerSolid)
    {
      trySimplerSolid(Simplification::Rounder, progressBetween(progress, 0.6, 0.9));
    }
    if (hopeless && !isExact() && !m_Stage.options.allowPartial)
    {
      refuseShape(*hopeless);
    }
    if (wasGivenUp && !isExact() && m_Stage.options.allowPartial)
    {
      workOutOwnFrame(progressBetween(progress, 0.9, 1.0));
    }
  }

private:
  [[nodiscard]] bool
  maybeTurned() const
  {
    return m_Stage.turnedStart && m_Stage.options.turnedFrames > 0;
  }

  [[nodiscard]] bool
  isExact() const
  {
    return m_Result.equalisation->exact;
  }

  void
  note(const std::string & attempt)
  {
    m_Result.attempts.push_back(attempt + (isExact() ? ": exact" : ": not exact"));
  }

  [[nodiscard]] std::optional<HopelessShape>
  tryTurnedFrames(const ProgressCallback & progress)
  {
    FrameSearchResult found = searchTurnedFrames(m_Stage, m_Stage.phi, *m_Result.equalisation, progress);
    if (found.better)
    {
      keep(std::move(*found.better), m_Result);
      m_Result.turnWarning = found.turn;
      m_Result.fallbackTurn = found.rotation;
    }
    note("turned frames");
    return found.hopeless;
  }

  /** The start on the surface of a simpler solid in its own frame; of a rounder one, the last resort, in turned frames,
   * too. */
  void
  trySimplerSolid(Simplification simplification, const ProgressCallback & progress)
  {
    const bool              isRounder = simplification == Simplification::Rounder;
    const std::string       name = isRounder ? "rounder solid" : "smoother solid";
    std::optional<LevelSet> simpler = m_Stage.options.simplerSolid(simplification);
    if (!simpler)
    {
      m_Result.attempts.push_back(name + ": too far from the label");
      return;
    }
    const CubicInterpolator phi(*simpler);
    try
    {
      EqualisationResult equalised =
        equaliseVolumes(m_Start, signedDistance(phi), m_Stage.volume, m_OwnFrame, progressBetween(progress, 0.0, 0.3));
      std::string turn;
      Matrix3     rotation = Matrix3::Identity();
      if (isRounder && !equalised.exact)
      {
        FrameSearchResult found = searchTurnedFrames(m_Stage, phi, equalised, progressBetween(progress, 0.3, 1.0));
        equalised = found.better ? std::move(*found.better) : std::move(equalised);
        turn = found.turn;
        rotation = found.rotation;
      }
      if (equalised.exact)
      {
        keep(std::move(equalised), m_Result);
        m_Result.turnWarning = turn;
        m_Result.fallbackTurn = rotation;
        m_Result.simplerSolid = std::move(simpler);
      }
      note(name);
    }
    catch (const InvalidInput & error) // the start lies too far from the simpler surface
    {
      m_Result.attempts.push_back(name + ": " + error.what());
    }
  }

  /** Where a partial mesh will do, an own frame that was given up is worked out. */
  void
  workOutOwnFrame(const ProgressCallback & progress)
  {
    EqualisationResult equalised = equalise(m_Stage, equalisationOptions(m_Stage.options), m_Start, progress);
    if (isBetter(equalised, *m_Result.equalisation))
    {
      keep(std::move(equalised), m_Result);
      m_Result.turnWarning.clear();
      m_Result.fallbackTurn.setIdentity();
    }
    note("own frame, worked out");
  }

  const ExactStage &   m_Stage;
  SolidMeshingResult & m_Result;
  HexMesh              m_Start;
  EqualisationOptions  m_OwnFrame;
};

/** The attempts of padding, one after the other until cells are wide enough for finite elements; what came of each is
 * noted in the result. */
class PaddingAttempts
{
public:
  PaddingAttempts(const ExactStage & stage, SolidMeshingResult & result)
    : m_Stage(stage)
    , m_Result(result)
    , m_Start(padded(result.mesh, stage.options.paddingLayers))
    , m_Own(equalisationOptions(stage.options))
  {
    result.exactWithoutPadding = result.equalisation->exact;
  }

  /** Returns the angles with which the best came about. */
  PaddingAngles
  run(const ProgressCallback & progress)
  {
    const MeshedSolid  solid(m_Stage, m_Result);
    PaddingAngles      angles = PaddingAngles::Strong;
    EqualisationResult best = pad(solid.distance(), angles, "padding", progressBetween(progress, 0.0, 0.4));
    if (!best.exact || best.smallestScaledJacobian < wantedSmallest)
    {
      EqualisationResult other =
        pad(solid.distance(), PaddingAngles::Weak, "padding, angles count less", progressBetween(progress, 0.4, 0.7));
      if (std::make_pair(other.exact, other.smallestScaledJacobian) >
          std::make_pair(best.exact, best.smallestScaledJacobian))
      {
        angles = PaddingAngles::Weak;
        best = std::move(other);
      }
    }
    if (isPoor(best) && tryRounderSolid(best, progressBetween(progress, 0.7, 1.0)))
    {
      angles = PaddingAngles::Strong;
    }
    keep(std::move(best), m_Result);
    return angles;
  }

private:
  /** Of the scaled Jacobians of a padded mesh [1]: below these another weight of angles, ... */
  static constexpr double wantedSmallest = 0.2;
  static constexpr double wantedMean = 0.9;
  /** ... and a rounder solid is tried. Far enough below the mean wanted for a surface to be given up for it. */
  static constexpr double poorMean = 0.85;

  [[nodiscard]] static bool
  isPoor(const EqualisationResult & mesh)
  {
    return !mesh.exact || mesh.smallestScaledJacobian < wantedSmallest || mesh.meanScaledJacobian < poorMean;
  }

  [[nodiscard]] EqualisationResult
  pad(const SignedDistance &   distance,
      PaddingAngles            angles,
      const std::string &      name,
      const ProgressCallback & progress)
  {
    EqualisationResult padding =
      equaliseVolumes(m_Start, distance, m_Stage.volume, paddingOptions(m_Own, angles), progress);
    std::ostringstream attempt;
    attempt << name << (padding.exact ? ": exact" : ": not exact") << ", scaled Jacobian at least "
            << padding.smallestScaledJacobian << ", on average " << padding.meanScaledJacobian;
    m_Result.attempts.push_back(attempt.str());
    return padding;
  }

  /** The last resort, as without padding, of a lattice that is exact on the solid as it is: replaces the mesh where it
   * becomes exact with cells as wide as wanted. A solid that is a simpler one already is not made simpler still. */
  bool
  tryRounderSolid(EqualisationResult & best, const ProgressCallback & progress)
  {
    if (!m_Result.exactWithoutPadding || m_Result.simplerSolid || !m_Stage.options.simplerSolid)
    {
      return false;
    }
    const std::string       name = "padding, rounder solid";
    std::optional<LevelSet> rounder = m_Stage.options.simplerSolid(Simplification::Rounder);
    if (!rounder)
    {
      m_Result.attempts.push_back(name + ": too far from the label");
      return false;
    }
    const CubicInterpolator phi(*rounder);
    try
    {
      EqualisationResult padding = pad(signedDistance(phi), PaddingAngles::Strong, name, progress);
      const bool isWide = padding.smallestScaledJacobian >= wantedSmallest && padding.meanScaledJacobian >= wantedMean;
      if (padding.exact && (isWide || !best.exact))
      {
        best = std::move(padding);
        m_Result.simplerSolid = std::move(rounder);
        return true;
      }
    }
    catch (const InvalidInput & error) // the start lies too far from the rounder surface
    {
      m_Result.attempts.push_back(name + ": " + error.what());
    }
    return false;
  }

  const ExactStage &   m_Stage;
  SolidMeshingResult & m_Result;
  HexMesh              m_Start;
  EqualisationOptions  m_Own;
};

} // namespace

void
makeExact(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress)
{
  const bool hasDensity = stage.options.density != nullptr;
  Attempts(stage, result).run(progressBetween(progress, 0.0, hasDensity ? 0.5 : 1.0));
  if (hasDensity)
  {
    equaliseMasses(stage, equalisationOptions(stage.options), result, progressBetween(progress, 0.5, 1.0));
  }
}

void
padExactly(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress)
{
  const bool          hasDensity = stage.options.density != nullptr;
  const PaddingAngles angles =
    PaddingAttempts(stage, result).run(progressBetween(progress, 0.0, hasDensity ? 0.5 : 1.0));
  if (hasDensity)
  {
    equaliseMasses(
      stage, paddingOptions(equalisationOptions(stage.options), angles), result, progressBetween(progress, 0.5, 1.0));
  }
}

void
requireExact(const SolidMeshingOptions & options, SolidMeshingResult & result)
{
  EqualisationResult & equalisation = *result.equalisation;
  const double         tolerance = options.equalisation.surfaceTolerance;
  if (equalisation.largestDistance <= tolerance && !(result.boundary.maximum <= tolerance))
  {
    std::ostringstream text;
    text << "boundary measured up to " << result.boundary.maximum << " mm off the surface, must be at most "
         << tolerance;
    equalisation.shortcomings.push_back(text.str());
    equalisation.exact = false;
    equalisation.report.converged = false;
  }
  std::string all;
  for (const std::string & shortcoming : equalisation.shortcomings)
  {
    all += (all.empty() ? "" : "; ") + shortcoming;
    result.warnings.push_back("not exact: " + shortcoming);
  }
  if (!equalisation.exact && !options.allowPartial)
  {
    const std::string what = result.exactWithoutPadding ? "exact without padding, not exact with it: " : "not exact: ";
    throw NotConverged(ErrorCode::NotExact, what + all, equalisation.report);
  }
}

} // namespace moserhex
