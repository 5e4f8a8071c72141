#pragma once

#include "LatticeVector.h"

#include <vector>

namespace moserhex
{

/** Lifts the scaled Jacobians q of corners that are below a goal, for chosen cells,
 *
 *   E(x) = w / 2 sum over cells and their 8 corners of max(0, 1 - q / q0)^2,   q = det(a,b,c) / (|a| |b| |c|)
 *
 * a, b, c being the three edges at the corner. q does not see the size of a cell, so corners are judged by their angles
 * alone, as the quality figures do; dq/da = (b x c) / (|a| |b| |c|) - q a / |a|^2, and cyclically. C1 but where an edge
 * vanishes; such a corner is left alone.
 *
 * \param cells  their numbers
 * \param goal        q0 > 0 [1]
 * \param gradient    dE/dx is added
 * \return E */
[[nodiscard]] double
addScaledJacobianBarrier(const LatticeLayout &            layout,
                         const Eigen::VectorXd &          x,
                         const std::vector<std::size_t> & cells,
                         double                           goal,
                         double                           weight,
                         Eigen::VectorXd &                gradient);

} // namespace moserhex
