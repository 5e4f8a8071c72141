#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/LevelSet/LabelDiagnosis.h"
#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/LevelSet.h"
#include "moserhex/LevelSet/TopologyRepair.h"

#include <string>
#include <vector>

namespace moserhex
{

/** What happens to a label that is not one solid of genus 0. */
enum class TopologyPolicy
{
  Repair, ///< made one by repairTopology()
  Reject  ///< refused with its numbers
};

/** Options of conditionLabel. */
struct ConditioningOptions
{
  /** Nodes per side of the lattice the solid is meant for; sets the grid spacing when that is 0 [1]. */
  int nodesPerSide{ 20 };

  /** Spacing of the grid [mm]; 0: automaticSpacing(). */
  double spacing{ 0.0 };

  /** Standard deviation of the Gaussian that removes the terraces, in units of the largest voxel side [1]. It is never
   * below 0.7 nodes nor, so that thin labels survive, above 0.15 V^(1/3) unless 0.7 nodes are. */
  double smoothing{ 0.35 };

  /** The standard deviation is never below this [mm]: for solids that must not have details narrower than a lattice's
   * cells. */
  double minimumSigma{ 0.0 };

  /** Ridges, spurs and grooves that a ball of this radius does not fit into are taken away or filled [mm]; 0: none. */
  double roundingRadius{ 0.0 };

  /** A voxel side larger than this times the smallest one makes slices, which are interpolated by shape [1]. */
  double sliceAnisotropy{ 1.5 };

  /** Smallest Dice coefficient with the label's voxels: a label that the smoothing cannot hold is refused [1]. */
  double minimumDice{ 0.8 };

  TopologyPolicy topology{ TopologyPolicy::Repair }; ///< what happens to a label that is not a ball

  /** Most that a repair may change: voxels added and removed over voxels of the label [1]. */
  double maximumRepair{ 0.05 };

  /** How messages name the label. */
  std::string labelName{ "label" };

  /** 0: all of the machine's; the result does not depend on it. */
  unsigned int threads{ 0 };
};

/** What was changed on the way from the voxels to the level set. */
struct ConditioningReport
{
  TopologyRepairReport repair;           ///< what was done to the label's voxels; no changes: it was a ball
  ImageBorders         borders;          ///< borders of the image where the label was closed off
  int                  sliceAxis{ -1 };  ///< axis interpolated by shape; -1: the voxels are (nearly) isotropic
  double               sigma{ 0.0 };     ///< of the Gaussian [mm]
  double               rounding{ 0.0 };  ///< ConditioningOptions::roundingRadius [mm]
  long                 eulerBefore{ 2 }; ///< V - E + F of the surface without topology protection
  std::size_t          nodesCut{ 0 };    ///< grid nodes that went outside to protect the topology
  std::size_t          nodesFilled{ 0 }; ///< grid nodes that went inside
  double               changedVolumeFraction{ 0.0 }; ///< (cut + filled) h^3 / V [1]
  double               volumeError{ 0.0 }; ///< (volume of phi < 0 - V) / V, exact for the piecewise linear phi [1]
  double               dice{ 0.0 };        ///< of the label's voxels and the voxels whose centre has phi < 0 [1]
  double               seconds{ 0.0 };     ///< wall time
};

/** What of it a user should be told, one line each: the repair of the topology, a mask closed off at the border of the
 * image, nodes changed to protect the topology, a Dice coefficient below 0.9. Empty when the label was taken as it is.
 */
[[nodiscard]] std::vector<std::string>
warningsOf(const ConditioningReport & report);

/** How a second, simpler solid is made of a label whose first one has details narrower than a lattice can carry. */
enum class Simplification
{
  Smoother, ///< a wider Gaussian: 1.5 times the first sigma, and at least 0.65 of a cell's edge
  Rounder   ///< at least one cell's edge, after rounding with a ball of radius 2.25 of a cell's edge
};

/** Options for the simpler solid. \param first  of the first solid \param volume  of the label [mm^3] */
[[nodiscard]] ConditioningOptions
simplified(Simplification simplification, const ConditioningReport & first, double volume, int nodesPerSide);

/** Whether a simpler solid is near enough to the label: a smoother one loses at most 0.02 of the Dice coefficient, a
 * rounder one, which is the last resort, keeps 0.95. */
[[nodiscard]] bool
isFaithful(Simplification simplification, const ConditioningReport & simpler, const ConditioningReport & first);

/** What a simpler solid was smoothed and rounded with, and how much of the label that took away, in one line. */
[[nodiscard]] std::string
describeSimplification(const ConditioningReport & simpler, const ConditioningReport & usual);

/** What conditionLabel made. */
struct ConditionedSolid
{
  LevelSet           levelSet; ///< phi [mm], < 0 inside
  LabelVolume        label;    ///< the voxels that phi was made from: a ball, cut out with a margin of one voxel
  double             labelVolume{ 0.0 }; ///< V: volume of these voxels [mm^3]
  ConditioningReport report;             ///< what was changed on the way
};

/** Half an edge of a cell of the lattice, (V / (n-1)^3)^(1/3) / 2, but not above
 *
 *   V^(1/3) / 24    a lattice of few nodes still needs its surface resolved, and
 *   V / (2A)        A = area of the voxel faces: a sheet gets four nodes across its thickness (but never below half
 *                   of the first value, so that a folded label does not exhaust the memory).
 *
 * \param volume    of the label [mm^3]
 * \param faceArea  of the faces between inside and outside voxels [mm^2] */
[[nodiscard]] double
automaticSpacing(double volume, double faceArea, int nodesPerSide);

/** Turns a label of any (anisotropic, oblique, cut off) image into a solid ball on an isotropic grid along the image
 * axes.
 *
 * 1. A label that is not one solid of genus 0 is repaired (TopologyRepair.h) or refused. Cuts and bridges reach as far
 *    as the Gaussian of step 3 needs.
 * 2. Signed distance: three-dimensional, or, when one voxel side is long, per slice: saturated q -> c tanh(q / c),
 *    c = three slices, so that no slice overrules its neighbours; Catmull-Rom across slices; the empty slice next
 *    to the label mirrors its last slice, |q|, which puts the cap half a slice out, wherever the image ends.
 * 3. Where rounding is asked for, opening and then closing by a ball: the distance to the surface, moved by -r, +2r
 *    and -r and measured anew each time. Then the Gaussian, and the level that encloses V.
 * 4. Topology: homotopic growth from the deepest node, or homotopic shrinking of the box, whichever moves fewer nodes;
 *    only the surroundings of moved nodes are smoothed again.
 * 5. Redistance, growth near 0, and the level that encloses V moved to 0.
 *
 * Guarantees: {phi < c} is a ball and the level set c one sphere for |c| <= h/4; |grad phi| = 1 near 0 up to O(h);
 * volume of {phi < 0} = V within 1e-6. The same answer for every origin and direction. Deterministic.
 *
 * \throws InvalidInput  empty or invalid label; not a ball ("label 3: 1 handle, V-E+F = 0, need 2 (genus 0)") and to be
 *         rejected, or a repair that changes too much (ErrorCode::Topology); thinner than the smoothing can hold
 *         (ErrorCode::Thin); options out of range
 * \throws Cancelled     by the callback */
[[nodiscard]] ConditionedSolid
conditionLabel(const LabelVolume &         label,
               const ConditioningOptions & options = {},
               const ProgressCallback &    progress = {});

} // namespace moserhex
