#pragma once

#include "LatticeVector.h"

#include <vector>

namespace moserhex
{

/** Pushes the Bernstein-Bezier coefficients b of det J above a margin, for chosen cells,
 *
 *   E(x) = w / 2 sum over cells and their 27 coefficients of max(0, delta - b)^2
 *
 * with b in units of a cell's target volume. Coefficients above 0 certify the whole cell, where positive corners do
 * not. C1.
 *
 * \param cells  their numbers
 * \param gradient    dE/dx is added
 * \return E */
[[nodiscard]] double
addBezierBarrier(const LatticeLayout &            layout,
                 const Eigen::VectorXd &          x,
                 const std::vector<std::size_t> & cells,
                 double                           margin,
                 double                           weight,
                 Eigen::VectorXd &                gradient);

} // namespace moserhex
