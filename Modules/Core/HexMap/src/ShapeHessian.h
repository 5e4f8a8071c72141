#pragma once

#include "ShapeEnergy.h"

namespace moserhex
{

/** Which second derivative of the shape energy is meant. */
enum class HessianForm
{
  Full,       ///< the second derivative itself: indefinite away from a minimiser
  GaussNewton ///< its positive semidefinite part
};

/** Second derivative of the shape energy times a vector, for p = 1. A corner, t = chi^(-2/3), D the motion of J:
 *
 *   Hf D = alpha D + beta [(C:D) J + (J:D) C] + gamma (C:D) C + f_d dC(D),   C = cof J, dC its derivative along D
 *   alpha = 2/3 t,  beta = -4/9 t/r,  f_d = -2/3 f/r,  gamma = f/r^2 (4/9 + 2/3 d/r)
 *
 * Gauss-Newton's form is what |J|^2 / chi^(2/3), jointly convex in (J, chi), leaves when chi'' and the second
 * derivative of det J are dropped: gamma = 10/9 f/r^2 and f_d = 0. It is positive semidefinite, as with |J:D| <= |J|
 * |D|
 *
 *   D:Hf D >= alpha |D|^2 - 2 |beta| |J| |D| |C:D| + gamma (C:D)^2,   alpha gamma = 20/81 (t |J| / r)^2
 *                                                                    > 16/81 (t |J| / r)^2 = beta^2 |J|^2
 *
 * Of the volumes it keeps w_v / v*^2 dv dv^T; the full form adds w_v (v - v*) / v*^2 times the second derivative of v.
 *
 * \param x              positions in units of a cell's edge
 * \param direction      the vector; padding entries zero
 * \param targetVolumes  as addShapeEnergy
 * \param product        H direction is added
 * \throws InvalidInput  weights.power is not 1, or there is padding: no product is written for these
 * \note The same bits for any number of threads. */
void
addShapeHessianProduct(const LatticeLayout &      layout,
                       const Eigen::VectorXd &    x,
                       const Eigen::VectorXd &    direction,
                       const Eigen::VectorXd &    targetVolumes,
                       const ShapeEnergyWeights & weights,
                       HessianForm                form,
                       unsigned int               threads,
                       Eigen::VectorXd &          product);

} // namespace moserhex
