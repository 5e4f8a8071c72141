#pragma once

#include "moserhex/HexMap/CellMeasure.h"
#include "moserhex/LevelSet/Density.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** Options of MassMeasure. */
struct MassMeasureOptions
{
  int pointsPerAxis{ 4 }; ///< Gauss points along each axis of a cell, 2 to 48; see chooseMassQuadrature [1]
};

/** Mass of a trilinear cell under a density, by the tensor Gauss rule with q = pointsPerAxis points a side:
 *
 *   m = integral over the cell of mu  ~  sum_q w_q mu(x(xi_q)) det J(xi_q),      x(xi) = sum_a N_a(xi) x_a
 *   dm/dx_a = sum_q w_q (N_a det J grad mu + mu cof(J) grad N_a)                  the sum's own derivative, exact
 *
 * Exact (to round-off) for constant and linear densities in every trilinear cell, and in a parallelepiped for a density
 * that is a polynomial of degree 2 q - 1 along each edge. Otherwise the error falls exponentially with q for an
 * analytic density and about like q^-3 for a DensityImage: estimateError measures it.
 *
 * Keeps a reference: the density must outlive the object. O(q^3) evaluations of the density a cell. */
class MassMeasure : public CellMeasure
{
public:
  /** \throws InvalidInput  points per axis outside 2..48 */
  explicit MassMeasure(const Density & density, const MassMeasureOptions & options = {});
  explicit MassMeasure(Density &&, const MassMeasureOptions & = {}) = delete;

  void
  evaluate(const HexMesh &       mesh,
           unsigned int          threads,
           std::vector<double> & measures,
           CellGradients *       gradients = nullptr) const override;

  /** Largest |m - m'| over the cells, m' their masses by the next finer rule (q + q/2 points), over the mean mass: the
   * estimated relative error of the worst cell [1].
   * \throws InvalidInput  q above 32, which leaves no finer rule; or as measureEquality */
  [[nodiscard]] double
  estimateError(const HexMesh & mesh, unsigned int threads = 0) const;

  /** As given to the constructor. */
  [[nodiscard]] const MassMeasureOptions &
  options() const
  {
    return m_Options;
  }

private:
  /** The quadrature points of equal (eta, zeta). x is linear in xi along them, between the faces xi = 0 and xi = 1. */
  struct Line
  {
    Eigen::Matrix<double, 4, 3> basis;  ///< row: corner of a face; columns: N, dN/deta, dN/dzeta of that face
    double                      weight; ///< sum over the lines 1
  };

  [[nodiscard]] double
  massOfCell(const HexCorners & corners, Eigen::Matrix<double, 3, 8> * gradient) const;

  const Density &     m_Density;
  MassMeasureOptions  m_Options;
  std::vector<Line>   m_Lines;     ///< q^2
  std::vector<double> m_Abscissae; ///< q, of xi in (0,1)
  std::vector<double> m_Weights;   ///< q, sum 1
};

/** A rule and what it reaches on one mesh. */
struct MassQuadrature
{
  MassMeasureOptions options;              ///< of the rule
  double             relativeError{ 0.0 }; ///< MassMeasure::estimateError of the rule [1]
  bool               reached{ false };     ///< relativeError <= the accuracy asked for
};

/** The cheapest of the rules with 2, 3, 4, 6 and 9 points a side whose estimated error on the mesh is at most
 * `relativeAccuracy`; the last of them when none is, with `reached` false: then the density changes a lot within a
 * cell, and more cells or a smoother density are the remedy.
 *
 * Choose once, on a mesh near the final one: a measure whose rule changes is not a smooth function of the nodes.
 * \throws InvalidInput  accuracy not positive, or as measureEquality */
[[nodiscard]] MassQuadrature
chooseMassQuadrature(const HexMesh & mesh, const Density & density, double relativeAccuracy, unsigned int threads = 0);

} // namespace moserhex
