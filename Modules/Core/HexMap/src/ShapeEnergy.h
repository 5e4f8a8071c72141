#pragma once

#include "LatticeVector.h"

namespace moserhex
{

struct ShapeEnergyWeights
{
  double regularisation{ 0.1 }; ///< epsilon of chi, relative to a cell's volume [1]
  double volume{ 50.0 };        ///< w_v [1]
  int    power{ 1 };            ///< p >= 1 [1]
  double angle{ 0.0 };          ///< w_a [1]
};

/** Shape and volume of the cells,
 *
 *   E(x) = sum over cells of 1/8 sum over corners of (f^p + w_a (1 - q)^2) + w_v / 2 (v / v* - 1)^2,
 *   f = |J|^2 / (3 chi(det J)^(2/3)),   chi(d) = (d + sqrt(epsilon^2 + d^2)) / 2,   q = det J / (|a| |b| |c|)
 *
 * f is the mean ratio, 1 for a cube and infinite for a flat corner, regularised so that it is finite for inverted
 * corners too and falls on the way out (Garanzha et al., "Foldover-free maps in 50 lines of code", 2021). J holds the
 * three edges at the corner as columns,
 *
 *   df/dJ = 2/3 chi^(-2/3) J - 2/3 f / r cof J,   r = sqrt(epsilon^2 + d^2),  as chi' = chi / r.
 *
 * q is the scaled Jacobian, 1 for right angles whatever the lengths of the edges a, b, c; dq/da = b x c / (|a| |b| |c|)
 * - q a / |a|^2, and cyclically. It grades what is sound already: it does not undo what is inverted.
 *
 * \param x              positions in units of a cell's edge
 * \param targetVolumes  v* in the cells' slots [unit^3], 0 elsewhere; layout.slotCount() entries
 * \param gradient       dE/dx is added
 * \return E; the same bits for any number of threads and any instruction set */
[[nodiscard]] double
addShapeEnergy(const LatticeLayout &      layout,
               const Eigen::VectorXd &    x,
               const Eigen::VectorXd &    targetVolumes,
               const ShapeEnergyWeights & weights,
               unsigned int               threads,
               Eigen::VectorXd &          gradient);

/** The volumes of the cells in their slots [unit^3], 0 elsewhere; layout.slotCount() entries. */
[[nodiscard]] Eigen::VectorXd
latticeVolumes(const LatticeLayout & layout, const Eigen::VectorXd & x, unsigned int threads);

/** 1 in the cells' slots, 0 elsewhere; layout.slotCount() entries. */
[[nodiscard]] Eigen::VectorXd
unitTargetVolumes(const LatticeLayout & layout);

} // namespace moserhex
