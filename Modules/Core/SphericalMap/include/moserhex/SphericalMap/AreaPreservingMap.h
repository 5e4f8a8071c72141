#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <optional>
#include <string>

namespace moserhex
{

/** Where areaPreservingSphereMap stops. The earlier stages are for comparison: their maps may have flipped triangles
 * and keep no area. */
enum class SphereMapStage
{
  Conformal,     ///< the paper's conformal map
  Centred,       ///< ... and Moebius centring
  MoserFlow,     ///< ... and the paper's area flow, from a start without flips
  AreaPreserving ///< ... and the barrier minimiser: the map with the guarantees
};

/** Options of areaPreservingSphereMap. */
struct AreaPreservingMapOptions
{
  Vector3                removedDirection{ Vector3::UnitZ() };        ///< see ConformalMapOptions
  std::optional<Vector3> removedNearPoint;                            ///< see ConformalMapOptions
  SphereMapStage         lastStage{ SphereMapStage::AreaPreserving }; ///< where to stop
  double                 shapeWeight{ 1e-3 };                         ///< eps at which the map is the minimiser [1]
  double                 areaTolerance{ 0.01 }; ///< area ratio rms promised; eps goes down until it holds [1]
  double                 areaLimit{ 0.0 };      ///< a rms above areaTolerance is accepted up to this; 0: never [1]
  double                 relativeFloor{ 1e-3 }; ///< smallest target of a triangle, of the mean [1]
  int                    maximumSteps{ 200 };   ///< Newton steps of each minimisation
};

/** What areaPreservingSphereMap made. */
struct AreaPreservingMapResult
{
  Positions        positions; ///< nV, |s| = 1 within 1e-15
  SphereMapQuality quality;   ///< of the map: flips, area ratios, angles
  std::string path; ///< start taken and what followed: "conformal", "conformal + moser", "hierarchy + eps 0.0007", ...
  std::vector<StepReport> reports; ///< one per stage, in order; note names the stage
  double shapeWeight{ 0.0 };       ///< eps of the result: options.shapeWeight unless the tolerance asked for less
};

/** Area-preserving map of a closed genus-0 surface to the unit sphere.
 *
 * conformal map -> Moebius centring -> (when triangles flipped, or limbs are pressed together: clamped weights, then
 * the hierarchy) -> one braked pass of Moser's flow on long shapes -> minimiser of AreaBarrier at fixed eps -> frame:
 * directions on the sphere match LPS directions in the body in the least-squares sense.
 *
 * Guarantee (lastStage AreaPreserving): no flipped triangle, solid angles sum to 4 pi within 1e-9, area ratio rms <=
 * max(areaTolerance, areaLimit). Where the minimiser at options.shapeWeight misses the tolerance, eps goes down step by
 * step until it holds; the result says so in `path` and `shapeWeight`. The map does not depend on the triangle removed,
 * on scale, or on how vertices are numbered: 1e-5 degrees on smooth shapes; on crumpled ones a few vertices can have
 * two places, up to a degree apart. Rotating the surface rotates the map.
 *
 * \param surface  closed, oriented outwards, genus 0; triangles of zero area are allowed
 * \throws InvalidInput  not a closed sphere (V-E+F), oriented inwards, a position not finite, no area
 * \throws NotConverged  the guarantee was not reached; the message has the numbers
 * \throws Cancelled
 * \note O(nV^1.5) time, O(nV log nV) memory, single-threaded, deterministic. */
[[nodiscard]] AreaPreservingMapResult
areaPreservingSphereMap(const TriangleMesh &             surface,
                        const AreaPreservingMapOptions & options = {},
                        const ProgressCallback &         progress = {});

} // namespace moserhex
