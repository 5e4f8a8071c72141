#pragma once

#include "LatticeVector.h"

namespace moserhex
{

struct DisplacementWeights
{
  double bending{ 0.0 };  ///< w_r [1]
  double boundary{ 0.0 }; ///< w_b [1]
};

/** How much a lattice is bent against a reference, and how far its boundary is from that one's,
 *
 *   E(x) = w_r / 2 sum over the lattice's edges (a, b) of |u_a - u_b|^2
 *        + w_b / 2 sum over its boundary nodes a of |u_a|^2,               u = x - reference
 *
 * The first is a discrete Dirichlet energy of the displacement: its minimisers under given displacements of the
 * boundary are harmonic, and where the boundary slides it slides as little unevenly as it can. On a surface that holds
 * the boundary nodes, the second draws each to the point nearest to its place in the reference. Nodes of padding have
 * no part in it.
 *
 * \param x, reference  positions in units of a cell's edge; a layout without padding
 * \param gradient      dE/dx is added
 * \return E; the same bits for any number of threads */
[[nodiscard]] double
addDisplacementEnergy(const LatticeLayout &       layout,
                      const Eigen::VectorXd &     x,
                      const Eigen::VectorXd &     reference,
                      const DisplacementWeights & weights,
                      unsigned int                threads,
                      Eigen::VectorXd &           gradient);

} // namespace moserhex
