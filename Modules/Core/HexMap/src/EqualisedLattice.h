#pragma once

#include "EqualisationFlaws.h"
#include "LatticeOptimiser.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

#include <vector>

namespace moserhex
{

/** What equaliseMeasures() was asked for; it outlives the work. */
struct EqualisationProblem
{
  const SignedDistance &      phi;     ///< [mm]
  double                      volume;  ///< [mm^3]
  const CellMeasure &         measure; ///< what is made equal
  double                      total;   ///< of the measure
  const EqualisationOptions & options;
  Positions                   surface; ///< points spread over it [mm]
};

/** The present mesh of stage J and what can be said of it. Its optimisers work in edges of a mean cell around the
 * middle of the start. */
class EqualisedLattice
{
public:
  /** The mesh, and the level of phi on which its boundary is held [mm]. */
  struct State
  {
    HexMesh mesh;
    double  level{ 0.0 };
  };

  /** \param problem  kept by reference */
  EqualisedLattice(const HexMesh & start, const EqualisationProblem & problem);

  [[nodiscard]] const EqualisationProblem &
  problem() const
  {
    return m_Problem;
  }

  [[nodiscard]] const HexMesh &
  mesh() const
  {
    return m_State.mesh;
  }

  [[nodiscard]] const State &
  state() const
  {
    return m_State;
  }

  void
  setState(State state)
  {
    m_State = std::move(state);
  }

  void
  setMesh(HexMesh mesh)
  {
    m_State.mesh = std::move(mesh);
  }

  /** Takes the mesh to a finer or coarser lattice. */
  void
  resample(int nodesPerSide);

  /** An optimiser on the present lattice, at the present level. */
  [[nodiscard]] LatticeOptimiser
  makeOptimiser() const;

  /** The nodes as an optimiser has them. */
  [[nodiscard]] Eigen::VectorXd
  vector(const LatticeLayout & layout) const;

  /** Takes over what an optimiser made of them, and its level. */
  void
  take(const LatticeOptimiser & optimiser, const Eigen::VectorXd & x);

  /** Edge of a mean cell [mm]. */
  [[nodiscard]] double
  unit() const;

  /** Measure wanted of every cell. */
  [[nodiscard]] double
  target() const;

  /** The volumes with which the cells, at their present mean densities, have equal measures, in cubes of unit(). Cells
   * that are flat or inverted count with the mean density. */
  [[nodiscard]] std::vector<double>
  targetVolumes() const;

  /** Mean (measure / target - 1)^2 [1]. */
  [[nodiscard]] double
  deviation() const;

  [[nodiscard]] bool
  isEqual() const;

  [[nodiscard]] std::size_t
  uncertifiedCells() const;

  /** Over the cells [1]. */
  [[nodiscard]] double
  meanScaledJacobian() const;

  /** Associates the optimiser's surface points with the present mesh. Does not say whether the cells are equal. */
  [[nodiscard]] EqualisationFlaws
  flaws(LatticeOptimiser & optimiser) const;

  /** What a mesh is repaired for. */
  [[nodiscard]] FlawLimits
  flawLimits() const;

  /** Of the surface from the boundary, in an exact mesh [mm]. */
  [[nodiscard]] double
  largestUncoveredDistance() const;

private:
  const EqualisationProblem & m_Problem;
  State                       m_State;
  Vector3                     m_Origin; ///< of the optimisers [mm]
};

/** Every cell within a relative deviation of 1e-9. */
constexpr double largestExactVariance = 1e-18;

} // namespace moserhex
