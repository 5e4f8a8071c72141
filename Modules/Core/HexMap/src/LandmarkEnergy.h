#pragma once

#include "LatticeVector.h"
#include "moserhex/HexMap/LatticeTies.h"

namespace moserhex
{

/** How far places of the lattice are from where they belong,
 *
 *   E(x) = w / 2 sum over landmarks of |sum_a w_a x_a - p|^2
 *
 * \param x         positions in units of a cell's edge, as are the landmarks'
 * \param gradient  dE/dx is added
 * \return E */
[[nodiscard]] double
addLandmarkEnergy(const LatticeLayout &                layout,
                  const Eigen::VectorXd &              x,
                  const std::vector<LatticeLandmark> & landmarks,
                  double                               weight,
                  Eigen::VectorXd &                    gradient);

} // namespace moserhex
