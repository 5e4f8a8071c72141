#pragma once

#include "LatticeVector.h"
#include "moserhex/HexMap/LatticeTies.h"

namespace moserhex
{

/** How far an image, at the lattice's samples, is from the values that belong there,
 *
 *   E(x) = w / 2 sum over cells of 1/8 sum over the cell's samples of (I(sum_a N_a x_a) - value)^2
 *
 * \param x         positions in units of a cell's edge, as is the image's argument; a layout without padding
 * \param gradient  dE/dx is added
 * \return E; the same bits for any number of threads */
[[nodiscard]] double
addImageEnergy(const LatticeLayout &   layout,
               const Eigen::VectorXd & x,
               const LatticeImage &    image,
               double                  weight,
               unsigned int            threads,
               Eigen::VectorXd &       gradient);

} // namespace moserhex
