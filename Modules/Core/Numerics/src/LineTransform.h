#pragma once

#include "moserhex/Numerics/CubeTransform.h"

#include <Eigen/Core>

#include <memory>

namespace moserhex
{

/** Engines take lines in multiples of this number. */
constexpr Eigen::Index linesTogether = 8;

/** `lanes` lines of n values side by side: a row for each line, a multiple of linesTogether. Column major, so that
 * value i of all lines lies together. */
using LinePanel = Eigen::MatrixXd;

/** Transforms a panel's lines in place. An object carries its own scratch: one for each thread at work. */
class LineTransform
{
public:
  virtual ~LineTransform() = default;

  virtual void
  forward(LinePanel & panel) = 0;

  virtual void
  inverse(LinePanel & panel) = 0;

  /** Another object that gives the same numbers, with scratch of its own. Tables of more than O(n) are shared. */
  [[nodiscard]] virtual std::unique_ptr<LineTransform>
  clone() const = 0;
};

/** O(n^2) a line: products with the matrix of even rows and the matrix of odd rows, each half as large. */
[[nodiscard]] std::unique_ptr<LineTransform>
makeDenseLineTransform(int n, CubeTransform::Basis basis);

/** O(n log n) a line when n (cosine) or n + 1 (sine) has small prime factors, up to O(n^2) for others. */
[[nodiscard]] std::unique_ptr<LineTransform>
makeFastLineTransform(int n, CubeTransform::Basis basis);

/** Whether the fast transform is the faster one, as measured. */
[[nodiscard]] bool
fastLineTransformPays(int n, CubeTransform::Basis basis);

} // namespace moserhex
