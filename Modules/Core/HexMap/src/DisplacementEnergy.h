#pragma once

#include "LatticeVector.h"

namespace moserhex
{

/** How much a lattice is bent against a reference, whatever its place,
 *
 *   E(x) = w / 2 sum over the lattice's edges (a, b) of |u_a - u_b|^2,   u = x - reference
 *
 * which is a discrete Dirichlet energy of the displacement: its minimisers under given displacements of the boundary
 * are harmonic, and where the boundary slides it slides as little unevenly as it can. Nodes of padding have no part in
 * it.
 *
 * \param x, reference  positions in units of a cell's edge; a layout without padding
 * \param gradient      dE/dx is added
 * \return E; the same bits for any number of threads */
[[nodiscard]] double
addDisplacementEnergy(const LatticeLayout &   layout,
                      const Eigen::VectorXd & x,
                      const Eigen::VectorXd & reference,
                      double                  weight,
                      unsigned int            threads,
                      Eigen::VectorXd &       gradient);

} // namespace moserhex
