#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <vector>

namespace moserhex
{

/** How a cell has changed its shape, growth of the whole organ removed. F~ = F g^(-1/3), E = (F~^T F~ - I) / 2. */
struct CellStrain
{
  Matrix3 tensor{ Matrix3::Zero() };         ///< E, Green-Lagrange, in LPS axes of the baseline [1]
  Vector3 principal{ Vector3::Zero() };      ///< eigenvalues of E, largest first [1]
  Matrix3 directions{ Matrix3::Identity() }; ///< columns: unit eigenvectors, their largest entry positive [1]
  double  deviatoric{ 0.0 };                 ///< |E - tr(E)/3 I|, Frobenius [1]
  double  largestStretch{ 1.0 };             ///< length after / before of the fibre that grew most, sqrt(1 + 2 E_1) [1]
};

/** \param F  mean deformation gradient, det F > 0 \param growth  g > 0 [1] */
[[nodiscard]] CellStrain
cellStrain(const Matrix3 & F, double growth);

/** What lies between a baseline X and a follow-up x with the same lattice, for each of its (n-1)^3 cells. */
struct CellDeformation
{
  double                  growth{ 1.0 }; ///< g: volume of the follow-up over that of the baseline [1]
  std::vector<Matrix3>    gradient;      ///< F, mean over the cell of dx/dX [1]
  std::vector<double>     volumeRatio;   ///< J, mean over the cell of det dx/dX: volume after / before, exactly [1]
  std::vector<double>     volumetric;    ///< J / g - 1: growth beyond that of the whole organ [1]
  std::vector<CellStrain> strain;        ///< of F and g
};

/** Mean deformation gradient of every cell, and what follows from it.
 *
 *   F = (1/V_X) integral over the cell of dx/dX dV_X
 *     = (1/V_X) integral over [0,1]^3 of  x_xi (X_eta x X_zeta)^T + x_eta (X_zeta x X_xi)^T + x_zeta (X_xi x X_eta)^T
 *   J = (1/V_X) integral over the cell of det(dx/dX) dV_X = V_x / V_X
 *   g = sum V_x / sum V_X
 *
 * The integrand of F is at most quadratic in each variable, so 2 x 2 x 2 Gauss points give the mean exactly; no inverse
 * is taken, so flat corners do no harm. The gradient at the centre alone would cost less, but does not see what the
 * corners do (hourglass modes), and its mean over cells is not that of the organ. Exact for affine deformations in any
 * cells; of a smooth deformation F is the gradient at the cell's centroid up to O(h^2), h the edge of a cell. det F
 * differs from J by O(h^2); J is what the volumes say, so J is reported.
 *
 * In meshes of equal cells J = g in all of them by construction, so `volumetric` is zero up to rounding: see README.
 * \param threads  as in parallelFor; the result does not depend on it
 * \throws InvalidInput  as requireComparable, or a cell of either mesh has no positive volume (names it)
 * \note O(cells) */
[[nodiscard]] CellDeformation
cellDeformation(const HexMesh & baseline, const HexMesh & followUp, unsigned int threads = 1);

} // namespace moserhex
