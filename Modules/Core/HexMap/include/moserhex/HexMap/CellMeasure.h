#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace moserhex
{

/** Column c: derivative of the measure of cell c with respect to its 24 corner coordinates. Corner a (VTK_HEXAHEDRON
 * order), coordinate k is row 3 a + k. */
using CellGradients = Eigen::Matrix<double, 24, Eigen::Dynamic>;

/** What every cell of the mesh gets the same amount of: its volume, or its mass under a density.
 *
 * A measure is additive over cells, a C1 function of the node positions with a Lipschitz gradient, and knows that
 * gradient exactly, so that Newton's method on "all measures are equal" converges quadratically. */
class CellMeasure
{
public:
  CellMeasure() = default;
  virtual ~CellMeasure() = default;
  CellMeasure(const CellMeasure &) = delete;
  CellMeasure &
  operator=(const CellMeasure &) = delete;

  /** Measure of every cell, negative where a cell is inverted.
   *
   * \param mesh       n^3 finite nodes, n >= 2; not checked
   * \param threads    0: all of the machine's; the result does not depend on it, bit for bit
   * \param measures   resized to (n-1)^3                                     [unit of the measure]
   * \param gradients  when not null: resized to 24 x (n-1)^3                 [unit of the measure / mm] */
  virtual void
  evaluate(const HexMesh &       mesh,
           unsigned int          threads,
           std::vector<double> & measures,
           CellGradients *       gradients = nullptr) const = 0;
};

/** Exact volume of the trilinear hexahedron [mm^3].
 *
 * Its boundary are six bilinear faces, and the cone over a bilinear face abcd has the mean volume of the cones over its
 * two triangulations, so with the corners counter-clockwise seen from outside
 *   12 dV/da = b x c + c x d + b x d      (summed over the faces that meet in a),      3 V = sum_a x_a . dV/da */
class VolumeMeasure : public CellMeasure
{
public:
  void
  evaluate(const HexMesh &       mesh,
           unsigned int          threads,
           std::vector<double> & measures,
           CellGradients *       gradients = nullptr) const override;
};

/** Volume of every cell over the share of the organ that is wanted of it [mm^3],
 *
 *   m_c = V_c / w_c,      w of mean 1,
 *
 * so that all m_c are equal where the volumes are as the shares w_c. */
class SharedVolumeMeasure : public CellMeasure
{
public:
  /** \param shares  of every cell in the order of the cells, > 0; divided by their mean [1]
   * \throws InvalidInput  none, or one that is not positive and finite */
  explicit SharedVolumeMeasure(std::vector<double> shares);

  /** \pre as many cells as shares */
  void
  evaluate(const HexMesh &       mesh,
           unsigned int          threads,
           std::vector<double> & measures,
           CellGradients *       gradients = nullptr) const override;

private:
  std::vector<double> m_Shares; ///< of mean 1
};

/** How equal the measures of a mesh are: with a density, the mass counterpart of volume variance and ratios. */
struct MeasureEquality
{
  double total{ 0.0 };    ///< sum over the cells [unit of the measure]
  double variance{ 0.0 }; ///< population variance of measure / mean [1]
  double ratioMin{ 0.0 }; ///< smallest measure / mean [1]
  double ratioMax{ 0.0 }; ///< largest measure / mean [1]
};

/** \throws InvalidInput  no measure, or a mean that is not positive and finite */
[[nodiscard]] MeasureEquality
measureEquality(const std::vector<double> & measures);

/** The same of a mesh. The mass variance is measureEquality(mesh, MassMeasure(density)).variance.
 * \throws InvalidInput  the number of nodes is not n^3 with n >= 2, or as above */
[[nodiscard]] MeasureEquality
measureEquality(const HexMesh & mesh, const CellMeasure & measure, unsigned int threads = 0);

} // namespace moserhex
