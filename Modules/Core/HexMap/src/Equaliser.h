#pragma once

#include "EqualisedLattice.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

#include <limits>
#include <string>
#include <vector>

namespace moserhex
{

/** One attempt at the whole work of stage J, from one start: owns the lattice on its way from coarse to fine. */
class Equaliser
{
public:
  Equaliser(const HexMesh & start, const EqualisationProblem & problem) : m_Lattice(start, problem)
  {}

  /** Of the boundary to the level that encloses the volume, before a minimisation. */
  enum class Boundary
  {
    AsItIs,
    OnLevel
  };

  /** Minimises on the present lattice, with one stage after the other. */
  void
  minimise(const std::vector<EqualisationStage> & stages, Boundary boundary, const ProgressCallback & progress);

  /** A lattice that is still tangled is minimised without regard to the volumes and with ever less regularisation, and
   * once more as before. Kept when that untangles it. */
  void
  untangle(const EqualisationStage & lastStage, const ProgressCallback & progress);

  /** Takes the mesh to a finer or coarser lattice. */
  void
  resample(int nodesPerSide)
  {
    m_Lattice.resample(nodesPerSide);
  }

  /** From a minimised mesh to an exact one. Most meshes may be projected at once, lifted before, or else as they are;
   * where that leaves a flaw the cells are made much more equal first, which costs more, and repaired after. Keeps the
   * better of the two. */
  void
  finish(const EqualisationStage & lastStage, const ProgressCallback & progress);

  /** Lifts the narrowest corners of an exact mesh, in rounds of a few steps and a projection each. Keeps the mesh with
   * the largest smallest scaled Jacobian of those that are exact and have the boundary as near. A mesh that is not
   * exact, or has no narrow corner, is left as it is. */
  void
  polish(const ProgressCallback & progress);

  [[nodiscard]] EqualisationResult
  result() const;

  [[nodiscard]] const HexMesh &
  mesh() const
  {
    return m_Lattice.mesh();
  }

private:
  /** Raises the weight of the volumes until the mean square deviation is below the goal. */
  void
  settle(EqualisationStage stage, double goal, const ProgressCallback & progress);

  /** Onto equal measures. Returns the flaws of the mesh after it.
   * \param maximumSteps  of Newton's method, at most as many as the options allow */
  EqualisationFlaws
  project(LatticeOptimiser &       optimiser,
          const ProgressCallback & progress,
          int                      maximumSteps = std::numeric_limits<int>::max());

  /** Pushes doubtful cells open and pulls what is off the surface harder, in rounds. Projects again when nothing is
   * left to repair, when a round did not help, and in the end; keeps the best projected mesh and returns its flaws.
   * \param present  flaws of the mesh, which has been projected */
  EqualisationFlaws
  repair(LatticeOptimiser & optimiser, EqualisationFlaws present, const ProgressCallback & progress);

  /** Before a round of repair or polish from x: makes springs near their tolerance or beyond stiffer, and has the
   * optimiser take up the present level, slopes and volumes. */
  void
  prepareRound(LatticeOptimiser & optimiser, const Eigen::VectorXd & x, double growth) const;

  /** One round of the polish, without the projection: pushes the narrowest corners open. Does nothing and returns false
   * when the smallest scaled Jacobian is not narrow. */
  bool
  lift(LatticeOptimiser & optimiser, double smallestScaledJacobian, const ProgressCallback & progress);

  /** Adds a step to the report; returns the flaws of the mesh. */
  EqualisationFlaws
  log(const std::string & name, int iterations, int evaluations, const Stopwatch & time, LatticeOptimiser & optimiser);

  EqualisedLattice              m_Lattice;
  std::vector<EqualisationStep> m_Steps;
};

/** The projection bends cells that are far from equal; below this mean square deviation it bends them hardly at all. */
constexpr double readyDeviation = 3e-5;
/** Factor on the weight of the volumes while they are not yet as equal. */
constexpr double settlingGrowth = 4.0;
/** On the stiffness of springs near their tolerance, a round. */
constexpr double springGrowth = 4.0;

} // namespace moserhex
