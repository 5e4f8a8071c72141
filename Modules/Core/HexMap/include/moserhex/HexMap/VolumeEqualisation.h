#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/HexMap/EqualMeasureProjection.h"
#include "moserhex/HexMap/LatticeTies.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace moserhex
{

/** One minimisation of the lattice's energy on one lattice. */
struct EqualisationStage
{
  double regularisation{ 0.1 }; ///< epsilon: inverted corners cost a finite amount, the less the larger it is [1]
  double volumeWeight{ 50.0 };  ///< w_v, of (volume / target - 1)^2 [1]
  double surfaceWeight{ 80.0 }; ///< w_s, of the squared distance to the surface [1]
  int    maximumSteps{ 60 };    ///< of L-BFGS [1]
  int    power{ 1 };            ///< p, of the mean ratio: larger values lift the worst cells [1]
  double angleWeight{ 0.0 };    ///< w_a, of (1 - scaled Jacobian of a corner)^2 [1]
  /** The stage is left out where the mean scaled Jacobian of the cells is at least this; above 1: never [1]. */
  double enoughScaledJacobian{ 2.0 };
};

/** Options of equaliseMeasures and equaliseVolumes. */
struct EqualisationOptions
{
  int nodesPerSide{ 0 }; ///< n of the mesh wanted; 0: that of the mesh given

  /** One after the other, on every lattice coarser than the mesh wanted. */
  std::vector<EqualisationStage> coarseStages{ { 0.1, 20.0, 80.0, 60 }, { 0.05, 50.0, 80.0, 60 } };
  /** One after the other, on the lattice of the mesh wanted, after the coarser ones. */
  std::vector<EqualisationStage> finestStages{ { 0.05, 50.0, 80.0, 30 }, { 0.02, 50.0, 80.0, 30 } };
  /** For a mesh that has the size wanted. When they do not make it exact it is taken back to a coarse lattice. */
  std::vector<EqualisationStage> directStages{ { 0.05, 20.0, 80.0, 60 }, { 0.02, 50.0, 80.0, 60 } };

  int    repairRounds{ 16 }; ///< of pushing uncertified cells open and projecting again
  double repairMargin{
    0.03
  };                        ///< Bezier coefficients of doubtful cells are pushed above this, det J of a mean cell = 1
  int    polishRounds{ 8 }; ///< of lifting the narrowest corners of an exact mesh and projecting again
  double narrowScaledJacobian{ 0.18 }; ///< a mesh with a smaller scaled Jacobian than this is polished [1]
  double angleWeight{ 0.0 };           ///< w_a while a mesh is repaired or polished [1]
  /** A minimised mesh with more uncertified cells is returned as it is, not equal, for want of prospects. */
  std::size_t hopelessCells{ std::numeric_limits<std::size_t>::max() };
  double      surfaceTolerance{ 0.5 }; ///< a boundary farther than this from the surface is reported as failed [mm]
  /** A surface farther than this from the boundary is reported as failed, but never when nearer than surfaceTolerance:
   * bumps smaller than a cell are cut off. In edges of a mean cell [1]. */
  double coverageTolerance{ 1.0 };

  /** What ties the mesh to another one. With any, the start has the size wanted and no padding, is not taken back to a
   * coarse lattice; ties draw it even where it is exact already, unless it is the reference itself. */
  LatticeTies ties;

  EqualMeasureOptions projection;   ///< its thread count is replaced by `threads`
  unsigned int        threads{ 0 }; ///< 0: all of the machine's; the result does not depend on it
};

/** What one piece of the work did. */
struct EqualisationStep
{
  std::string name;              ///< "minimise", "project", "repair", "polish"
  int         nodesPerSide{ 0 }; ///< n of the lattice
  int         iterations{ 0 };   ///< L-BFGS steps or Newton steps
  int         evaluations{ 0 };  ///< of the energy, or conjugate-gradient steps
  double      variance{ 0.0 };   ///< of the measure after it [1]
  std::size_t uncertified{ 0 };  ///< cells with a Bezier coefficient <= 0 after it
  double      distance{ 0.0 };   ///< largest of boundary nodes and quad centres to the surface after it [mm]
  double      uncovered{ 0.0 };  ///< largest distance of the surface to the mesh's boundary after it [mm]
  double      seconds{ 0.0 };    ///< wall time [s]
};

/** What equaliseMeasures and equaliseVolumes made. */
struct EqualisationResult
{
  HexMesh                       mesh;                          ///< exact or not [mm]
  double                        level{ 0.0 };                  ///< of phi, on which the boundary nodes were held [mm]
  double                        variance{ 0.0 };               ///< mean (measure / target - 1)^2 [1]
  std::size_t                   concaveCells{ 0 };             ///< with det J <= 0 at a corner
  std::size_t                   uncertifiedCells{ 0 };         ///< not certified positive in the whole cell
  double                        largestDistance{ 0.0 };        ///< of boundary nodes and quad centres to phi = 0 [mm]
  double                        uncoveredDistance{ 0.0 };      ///< of points of phi = 0 to the mesh's boundary [mm]
  double                        smallestScaledJacobian{ 0.0 }; ///< over the cells [1]
  double                        meanScaledJacobian{ 0.0 };     ///< over the cells [1]
  bool                          exact{ false }; ///< measures equal, every cell certified, boundary within tolerance
  std::vector<std::string>      shortcomings;   ///< what of that was not reached, and by how much; empty when exact
  std::vector<EqualisationStep> steps;          ///< in order of execution
  StepReport                    report;         ///< converged = exact, residual = variance
};

/** So many uncertified cells after a minimisation mean that the cube's edges lie badly; flaws sit along edges, so the
 * number grows with n: max(2, n / 3). */
[[nodiscard]] std::size_t
tangledCells(int nodesPerSide);

/** Every cell the same volume (or mass), none concave, the boundary on the organ's surface (stage J).
 *
 * 1. Untangles, smooths and equalises together: L-BFGS on
 *      E(x) = sum over cells of [ 1/8 sum over corners of (f^p + w_a (1 - q)^2) + w_v/2 (v / v* - 1)^2 ]
 *           + w_s/2 sum of (s(x) - c)^2
 *           + the terms of the ties (LatticeTies.h)
 *    f the regularised mean ratio, q the scaled Jacobian of a corner, s the signed distance of boundary nodes and quad
 * centres in cell edges, which slide freely; the inverse of the lattice Laplacian by cosine transforms stands in for
 * the inverse Hessian. From the lattice given through ever finer ones, prolonged by cubics. Points of the surface that
 * the boundary has drained from, or that the start does not reach, pull it to them.
 * 2. Newton projection onto equal measures by the smoothest displacement (EqualMeasureProjection.h).
 * 3. Certifies det J > 0 in every cell by its Bezier coefficients, pushes the doubtful ones open, and projects again.
 * 4. Lifts the corners of the smallest scaled Jacobian where it is narrow, and projects again.
 *
 * \param start    any mesh of the same solid, tangled or not; n >= 2, at most the n wanted. One with padding
 * (Padding.h) keeps its n and is not taken back to coarser lattices \param phi      the organ's surface is {phi = 0},
 * closed; negative somewhere in the box around the start [mm] \param volume   of the label, > 0 [mm^3] \param measure
 * what is equalised; for VolumeMeasure the total is `volume` \param total    sum of the measure over the organ; every
 * cell gets the same part, > 0 [unit of the measure] \throws InvalidInput  no n^3 finite nodes; a volume, total or
 * option out of range; no closed surface at the start \throws Cancelled     by the callback \note Never throws for a
 * mesh that is not exact: `exact` and `shortcomings` say so. A start that is exact already is returned as it is, unless
 * ties draw it: landmarks, an image, or a reference with other nodes. Deterministic for any number of threads. */
[[nodiscard]] EqualisationResult
equaliseMeasures(const HexMesh &             start,
                 const SignedDistance &      phi,
                 double                      volume,
                 const CellMeasure &         measure,
                 double                      total,
                 const EqualisationOptions & options = {},
                 const ProgressCallback &    progress = {});

/** The minimum of E alone (1. above), by options.directStages on the lattice given: its measures are as equal as
 * volumeWeight asks for, and the mesh is neither projected nor certified.
 * \param measure  whose total over the organ is the volume; others as for equaliseMeasures, which throws the same */
[[nodiscard]] HexMesh
minimisedLattice(const HexMesh &             start,
                 const SignedDistance &      phi,
                 double                      volume,
                 const CellMeasure &         measure,
                 const EqualisationOptions & options,
                 const ProgressCallback &    progress = {});

/** The same as equaliseMeasures for volumes. */
[[nodiscard]] EqualisationResult
equaliseVolumes(const HexMesh &             start,
                const SignedDistance &      phi,
                double                      volume,
                const EqualisationOptions & options = {},
                const ProgressCallback &    progress = {});

} // namespace moserhex
