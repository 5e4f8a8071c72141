#include "LineTransform.h"

#include "moserhex/Numerics/CosineTransform.h"

#include <cmath>

namespace moserhex
{
namespace
{
using Basis = CubeTransform::Basis;

/** Halves at least this long are folded again; shorter ones cost more to fold than to multiply. */
constexpr int smallestFoldedHalf = 12;

class DenseLineTransform;

/** The even or the odd rows of a transform on half lines: a matrix, or the same transform of half the length. */
struct HalfTransform
{
  Eigen::MatrixXd                     rows;           // applied from the right: transposed
  Eigen::MatrixXd                     rowsTransposed; // for the inverse
  std::unique_ptr<DenseLineTransform> folded;
  LinePanel                           in;
  LinePanel                           out;

  void
  apply(bool isInverse);
};

/** Row a of the cosine and of the sine matrix is even (a even) or odd (a odd) under i -> n-1-i. So with the half lines
 * e_i = x_i + x_{n-1-i}, o_i = x_i - x_{n-1-i}, the even rows of the result need e alone and the odd rows o: n^2 / 2
 * products. The even rows of the cosine transform of even length are a cosine transform of e / sqrt(2), and the odd
 * rows of the sine transform of odd length a sine transform of o / sqrt(2), which is folded again: towards n^2 / 3. */
class DenseLineTransform : public LineTransform
{
public:
  DenseLineTransform(int n, Basis basis) : m_N(n), m_Basis(basis), m_EvenCount((n + 1) / 2), m_OddCount(n / 2)
  {
    const Eigen::MatrixXd matrix = basis == Basis::Cosine ? cosineMatrix(n) : sineMatrix(n);
    const auto            setRows = [&](HalfTransform & half, Eigen::Index count, Eigen::Index firstRow) {
      half.rowsTransposed.resize(count, count);
      for (Eigen::Index a = 0; a < count; ++a)
      {
        half.rowsTransposed.row(a) = matrix.row(2 * a + firstRow).head(count);
      }
      half.rows = half.rowsTransposed.transpose();
    };
    setRows(m_Even, m_EvenCount, 0);
    setRows(m_Odd, m_OddCount, 1);
    if (n / 2 >= smallestFoldedHalf && m_Basis == Basis::Cosine && n % 2 == 0)
    {
      m_Even.folded = std::make_unique<DenseLineTransform>(n / 2, m_Basis);
    }
    if (n / 2 >= smallestFoldedHalf && m_Basis == Basis::Sine && n % 2 == 1)
    {
      m_Odd.folded = std::make_unique<DenseLineTransform>(n / 2, m_Basis);
    }
  }

  void
  forward(LinePanel & panel) override
  {
    resizeHalves(panel.rows());
    const double evenScale = m_Even.folded ? std::sqrt(0.5) : 1.0;
    const double oddScale = m_Odd.folded ? std::sqrt(0.5) : 1.0;
    for (Eigen::Index i = 0; i < m_OddCount; ++i)
    {
      m_Even.in.col(i) = evenScale * (panel.col(i) + panel.col(m_N - 1 - i));
      m_Odd.in.col(i) = oddScale * (panel.col(i) - panel.col(m_N - 1 - i));
    }
    if (m_EvenCount > m_OddCount)
    {
      m_Even.in.col(m_OddCount) = panel.col(m_OddCount); // the middle value of an odd number stands alone
    }
    m_Even.apply(false);
    m_Odd.apply(false);
    for (Eigen::Index a = 0; a < m_N; ++a)
    {
      panel.col(a) = (a % 2 == 0 ? m_Even : m_Odd).out.col(a / 2);
    }
  }

  void
  inverse(LinePanel & panel) override
  {
    resizeHalves(panel.rows());
    for (Eigen::Index a = 0; a < m_N; ++a)
    {
      (a % 2 == 0 ? m_Even : m_Odd).in.col(a / 2) = panel.col(a);
    }
    m_Even.apply(true);
    m_Odd.apply(true);
    const double evenScale = m_Even.folded ? std::sqrt(0.5) : 1.0;
    const double oddScale = m_Odd.folded ? std::sqrt(0.5) : 1.0;
    for (Eigen::Index i = 0; i < m_OddCount; ++i)
    {
      panel.col(i) = evenScale * m_Even.out.col(i) + oddScale * m_Odd.out.col(i);
      panel.col(m_N - 1 - i) = evenScale * m_Even.out.col(i) - oddScale * m_Odd.out.col(i);
    }
    if (m_EvenCount > m_OddCount)
    {
      panel.col(m_OddCount) = m_Even.out.col(m_OddCount);
    }
  }

  [[nodiscard]] std::unique_ptr<LineTransform>
  clone() const override
  {
    return std::make_unique<DenseLineTransform>(static_cast<int>(m_N), m_Basis);
  }

private:
  void
  resizeHalves(Eigen::Index lanes)
  {
    m_Even.in.resize(lanes, m_EvenCount);
    m_Odd.in.resize(lanes, m_OddCount);
  }

  Eigen::Index  m_N;
  Basis         m_Basis;
  Eigen::Index  m_EvenCount;
  Eigen::Index  m_OddCount;
  HalfTransform m_Even;
  HalfTransform m_Odd;
};

void
HalfTransform::apply(bool isInverse)
{
  if (!folded)
  {
    out.noalias() = in * (isInverse ? rowsTransposed : rows);
    return;
  }
  if (isInverse)
  {
    folded->inverse(in);
  }
  else
  {
    folded->forward(in);
  }
  in.swap(out);
}
} // namespace

std::unique_ptr<LineTransform>
makeDenseLineTransform(int n, CubeTransform::Basis basis)
{
  return std::make_unique<DenseLineTransform>(n, basis);
}

} // namespace moserhex
