#pragma once

#include "moserhex/DiscreteCalculus/CubeLatticeOperators.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Numerics/CosineTransform.h"

#include <Eigen/Core>

#include <vector>

namespace moserhex
{

/** What all passes of the flow over one lattice share. */
struct MoserFlowOperators
{
  explicit MoserFlowOperators(int nodesPerSide);

  NeumannPoissonSolver               poisson;           ///< inverse of d2 *2^-1 d2^T
  CubeLatticeOperators::SparseMatrix fluxFromPotential; ///< *2^-1 d2^T
};

/** The velocity X_t = -v / ((1-t) rho + t) of Moser's flow on the cube lattice with unit cells, rho = |Df|.
 *
 * v is a 2-form (one flux per face, zero on the cube's surface) with d2 v = 1 - rho in every cell and v = *2^-1 d2^T
 * theta, so the least such flux in the norm of *2. Points are lattice coordinates in [0, n-1]^3. */
class MoserVelocity
{
public:
  /** \param nodesPerSide  n >= 2
   *  \param volumes       of the (n-1)^3 cells; positive mean */
  MoserVelocity(int nodesPerSide, const std::vector<double> & volumes, const MoserFlowOperators & operators);

  /** X_t at a point. Each component of v is trilinear between the centres of its own faces, rho between cell centres;
   * both are constant beyond the outermost centres, except that normal components fall to zero at the surface. */
  [[nodiscard]] Vector3
  at(const Vector3 & point, double t) const;

  /** Where the trajectory that is at `point` at t = 1 was at t = 0: g_1^-1(point). Classical Runge-Kutta of order 4. */
  [[nodiscard]] Vector3
  originOf(const Vector3 & point, int steps) const;

  /** Largest speed at the lattice nodes over the first and the last moment of the flow [cells]. */
  [[nodiscard]] double
  largestSpeed() const;

private:
  int                            m_N;
  std::array<Eigen::VectorXd, 3> m_Flux;    // by normal axis, first index fastest
  Eigen::VectorXd                m_Density; // rho, floored
};

} // namespace moserhex
