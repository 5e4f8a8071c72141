#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace moserhex
{

/** Columns of numbers, `lanes` in each, where lanes is a multiple of linesTogether (LineTransform.h): value i of many
 * lines lies together in column i. Column i begins at values + i * stride. */
struct PanelColumns
{
  double *    values;
  std::size_t stride;
};

using FactorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** out_a = sum over k of factors(a, k) in_k. `out` must not overlap `in`. */
void
multiplyColumns(const FactorMatrix & factors, const PanelColumns & in, const PanelColumns & out, std::size_t lanes);

/** to[i * toStride + l] = from[l * fromStride + i] for l < lines and i < n. */
void
transposeLines(const double * from,
               std::size_t    fromStride,
               std::size_t    lines,
               std::size_t    n,
               double *       to,
               std::size_t    toStride);

/** Weights of the two halves of a line. */
struct FoldScales
{
  double even{ 1.0 };
  double odd{ 1.0 };
};

/** Of lines of n values x: even_i = scale (x_i + x_{n-1-i}), odd_i = scale (x_i - x_{n-1-i}) for i < n / 2; the middle
 * value of an odd n becomes the last even one, unscaled. */
void
foldColumns(const PanelColumns & lines,
            std::size_t          n,
            std::size_t          lanes,
            const FoldScales &   scales,
            const PanelColumns & even,
            const PanelColumns & odd);

/** The transpose of foldColumns. */
void
unfoldColumns(const PanelColumns & even,
              const PanelColumns & odd,
              std::size_t          n,
              std::size_t          lanes,
              const FoldScales &   scales,
              const PanelColumns & lines);

} // namespace moserhex
