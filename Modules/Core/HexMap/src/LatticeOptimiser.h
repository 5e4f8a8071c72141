#pragma once

#include "EmbeddedOperator.h"
#include "SurfaceAttraction.h"
#include "SurfaceCoverage.h"
#include "TieEnergy.h"
#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMap/VolumeEqualisation.h"
#include "moserhex/Numerics/LimitedMemoryBfgs.h"

#include <vector>

namespace moserhex
{

/** Minimises the energy of VolumeEqualisation.h on one lattice. Positions in units of a mean cell's edge. */
class LatticeOptimiser
{
public:
  /** \param phi  in those units \param surfacePoints  points on the organ's surface, in those units
   * \param volume  of the organ, in those units */
  LatticeOptimiser(LatticeLayout  layout,
                   SignedDistance phi,
                   Positions      surfacePoints,
                   double         volume,
                   unsigned int   threads);

  [[nodiscard]] const LatticeLayout &
  layout() const
  {
    return m_Layout;
  }

  [[nodiscard]] const SurfaceAttraction &
  attraction() const
  {
    return m_Attraction;
  }

  [[nodiscard]] SurfaceAttraction &
  attraction()
  {
    return m_Attraction;
  }

  [[nodiscard]] SurfaceCoverage &
  coverage()
  {
    return m_Coverage;
  }

  /** Volumes wanted, of every cell in the order of the cells; they must sum to the organ's volume. Until it is called
   * all are the same. */
  void
  setTargetVolumes(const std::vector<double> & volumes);

  /** Puts the level where the boundary encloses the organ's volume. */
  void
  updateLevel(const Eigen::VectorXd & x);

  /** Cells whose Bezier coefficients are pushed above the margin; weight 0: none. */
  void
  setBarrier(std::vector<std::size_t> cells, double margin, double weight);

  /** Cells whose corners are lifted towards the scaled Jacobian `goal`; weight 0: none. */
  void
  setCornerBarrier(std::vector<std::size_t> cells, double goal, double weight);

  /** What the lattice is tied to. */
  void
  setTies(TieEnergy ties);

  /** E and its gradient at x. */
  [[nodiscard]] double
  energy(const Eigen::VectorXd & x, const EqualisationStage & stage, Eigen::VectorXd & gradient) const;

  LimitedMemoryBfgsResult
  minimise(Eigen::VectorXd &         x,
           const EqualisationStage & stage,
           double                    smallestDecrease,
           const ProgressCallback &  progress);

private:
  /** Before a minimisation by a stage: the shapes' energy depends on it. */
  void
  updateRestGradient(const EqualisationStage & stage);

  LatticeLayout            m_Layout;
  SurfaceAttraction        m_Attraction;
  SurfaceCoverage          m_Coverage;
  EmbeddedOperator         m_InverseLaplacian;
  double                   m_Volume;
  unsigned int             m_Threads;
  Eigen::VectorXd          m_TargetVolumes;
  std::vector<std::size_t> m_BarrierCells;
  double                   m_BarrierMargin{ 0.0 };
  double                   m_BarrierWeight{ 0.0 };
  std::vector<std::size_t> m_CornerCells;
  double                   m_CornerGoal{ 1.0 };
  double                   m_CornerWeight{ 0.0 };
  TieEnergy                m_Ties;
  Eigen::VectorXd          m_RestGradient; ///< of the cells' shapes at the lattice at rest; empty: there is none
};

} // namespace moserhex
