#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

/** Options of placeFrame and edgeScore. */
struct FramePlacementOptions
{
  /** n of the lattice whose edges are judged: even, 4 to 1000. Hollows and ridges narrower than its cells do not count;
   * on prostates 6 served the final mesh of 20 no worse than 10 or 20 did. [1] */
  int nodesPerSide{ 6 };

  double maximumAngle{ 10.0 }; ///< largest rotation away from the frame given, 0 to 180 [degree]

  /** Largest boost b, 0 <= b < 0.5; 0: rotation only. It changes area ratios by at most ((1 + b) / (1 - b))^2. [1] */
  double maximumBoost{ 0.0 };

  double sharpness{ 10.0 };    ///< k, 0 < k <= 100: the larger, the more the worst corners of an edge decide [1]
  double anchor{ 1.0 };        ///< a >= 0: the score must fall by the factor exp(a) to go as far as the bounds [1]
  double firstStep{ 0.5 };     ///< of the search, part of the bounds, in (0, 1] [1]
  double smallestStep{ 0.02 }; ///< the search ends below this part of the bounds, in (0, firstStep] [1]
  int    maximumRounds{ 200 }; ///< of the search, >= 1 [1]

  unsigned int threads{ 0 }; ///< 0: all of the machine's; the result does not depend on it
};

/** A conformal map of the sphere: s -> boost of R s (see moebiusBoost). */
struct FramePlacement
{
  Matrix3 rotation{ Matrix3::Identity() }; ///< R, det R = +1 [1]
  Vector3 boost{ Vector3::Zero() };        ///< |boost| < 1 [1]
};

/** How the 12 edges of the cube lie on the surface. */
struct EdgeScore
{
  double score{ 0.0 };                  ///< mean of exp(-k q) over the corners of the cells along the edges [1]
  double smallestScaledJacobian{ 0.0 }; ///< smallest q [1]
};

/** What placeFrame found. */
struct FramePlacementResult
{
  FramePlacement placement;        ///< turns and boosts the frame given
  EdgeScore      before;           ///< of the frame given
  EdgeScore      after;            ///< its score is never above that of `before`
  double         angle{ 0.0 };     ///< of the rotation [degree]
  int            evaluations{ 0 }; ///< of the score
  StepReport     report;           ///< steps: rounds; residual: last step, part of the bounds [1]
};

/** Score of one placement. At a node on an edge of the cube the three sides of a cell (one or two along the edge, one
 * into each face) all lie on the surface, so its scaled Jacobian
 *
 *   q = det(e1, e2, e3) / (|e1| |e2| |e3|)
 *
 * is known without the interior: negative in a hollow, zero where the surface is flat across the edge, large on a
 * ridge. The score is the mean of exp(-k q) over all these corners; those at the cube's corners count for each of
 * their three edges.
 * \throws InvalidInput  as placeFrame */
[[nodiscard]] EdgeScore
edgeScore(const TriangleMesh &          surface,
          const Positions &             sphereMap,
          const FramePlacement &        placement,
          const FramePlacementOptions & options = {});

/** The same for many placements; faster than one by one.
 * \return in the order of the placements; the same for any number of threads */
[[nodiscard]] std::vector<EdgeScore>
edgeScores(const TriangleMesh &                surface,
           const Positions &                   sphereMap,
           const std::vector<FramePlacement> & placements,
           const FramePlacementOptions &       options = {});

/** Turns (and boosts) the lattice's frame so that the cube's edges leave hollows and follow ridges, looking at the
 * boundary only and near the frame given:
 *
 *   minimise  log score(r, b) + a (|r|^2 / r_max^2 + |b|^2 / b_max^2)   over |r| <= r_max, |b| <= b_max
 *
 * r the rotation vector, b the boost. Compass search from the identity: both ways along each of the 3 or 6 axes in
 * every round, the best of them is taken (the first among equals), the step is halved when none is better. The second
 * term keeps flat minima near the frame given, so that repeated scans of a subject agree; the search is local for the
 * same reason.
 *
 * \param surface    closed, outward, genus 0 [mm]
 * \param sphereMap  one unit vector per vertex, no flipped triangle, in the anatomical frame
 * \throws InvalidInput  the map has another number of vertices than the surface; an option outside its range
 * \throws Cancelled     by the callback
 * \note Deterministic for any number of threads. */
[[nodiscard]] FramePlacementResult
placeFrame(const TriangleMesh &          surface,
           const Positions &             sphereMap,
           const FramePlacementOptions & options = {},
           const ProgressCallback &      progress = {});

/** The image of a direction under a placement, length 1. */
[[nodiscard]] Vector3
placed(const Vector3 & direction, const FramePlacement & placement);

/** The direction whose image is `direction`. */
[[nodiscard]] Vector3
unplaced(const Vector3 & direction, const FramePlacement & placement);

/** Sphere maps in the new frame, one unit vector per entry. A rotation keeps triangles as they are; a boost can turn
 * over triangles that are nearly flat on the sphere, so a map that was boosted has to be checked
 * (countFlippedTriangles). */
[[nodiscard]] std::vector<Positions>
placed(const std::vector<Positions> & sphereMaps, const FramePlacement & placement);

} // namespace moserhex
