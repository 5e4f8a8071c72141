#include "LineTransform.h"
#include "PanelKernels.h"

#include "moserhex/Numerics/CosineTransform.h"

#include <cmath>
#include <utility>
#include <vector>

namespace moserhex
{
namespace
{
using Basis = CubeTransform::Basis;

/** Halves at least this long are folded again; shorter ones cost more to fold than to multiply. */
constexpr std::size_t smallestFoldedHalf = 12;

/** Half lines of one fold, a column of lanes for each value. */
struct HalfLines
{
  Eigen::MatrixXd even;
  Eigen::MatrixXd odd;
};

PanelColumns
columnsOf(Eigen::MatrixXd & panel)
{
  return { panel.data(), static_cast<std::size_t>(panel.rows()) };
}

class FoldedTransform;

/** The even or the odd rows of a transform on half lines: a matrix, or the same transform of half the length. */
struct HalfTransform
{
  Eigen::Index                           length;
  FactorMatrix                           rows;
  FactorMatrix                           rowsTransposed; // for the inverse
  std::unique_ptr<const FoldedTransform> folded;         // in their place

  void
  forward(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const;

  void
  inverse(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const;
};

/** Row a of the cosine and of the sine matrix is even (a even) or odd (a odd) under i -> n-1-i. So with the half lines
 * e_i = x_i + x_{n-1-i}, o_i = x_i - x_{n-1-i}, the even rows of the result need e alone and the odd rows o: n^2 / 2
 * products. The even rows of the cosine transform of even length are a cosine transform of e / sqrt(2), and the odd
 * rows of the sine transform of odd length a sine transform of o / sqrt(2), which is folded again: towards n^2 / 3.
 *
 * Tables only: threads share them and bring their own scratch, one entry for each of the folds(). */
class FoldedTransform
{
public:
  FoldedTransform(std::size_t n, Basis basis) : m_N(n)
  {
    const auto            size = static_cast<int>(n);
    const bool            foldsAgain = n / 2 >= smallestFoldedHalf;
    const Eigen::MatrixXd matrix = basis == Basis::Cosine ? cosineMatrix(size) : sineMatrix(size);
    const auto            set = [&](HalfTransform & half, Eigen::Index firstRow, double & scale, bool isFolded) {
      half.length = (size + 1 - firstRow) / 2;
      if (isFolded)
      {
        half.folded = std::make_unique<const FoldedTransform>(static_cast<std::size_t>(half.length), basis);
        m_Folds += half.folded->folds();
        scale = std::sqrt(0.5);
        return;
      }
      half.rows.resize(half.length, half.length);
      for (Eigen::Index a = 0; a < half.length; ++a)
      {
        half.rows.row(a) = matrix.row(2 * a + firstRow).head(half.length);
      }
      half.rowsTransposed = half.rows.transpose();
    };
    set(m_Even, 0, m_Scales.even, foldsAgain && basis == Basis::Cosine && n % 2 == 0);
    set(m_Odd, 1, m_Scales.odd, foldsAgain && basis == Basis::Sine && n % 2 == 1);
  }

  [[nodiscard]] std::size_t
  folds() const
  {
    return m_Folds;
  }

  /** `out` may be `in`. */
  void
  forward(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const
  {
    resize(*scratch, lanes);
    const PanelColumns even = columnsOf(scratch->even);
    const PanelColumns odd = columnsOf(scratch->odd);
    foldColumns(in, m_N, lanes, m_Scales, even, odd);
    m_Even.forward(even, { out.values, 2 * out.stride }, lanes, scratch + 1);
    m_Odd.forward(odd, { out.values + out.stride, 2 * out.stride }, lanes, scratch + 1);
  }

  /** `out` may be `in`. */
  void
  inverse(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const
  {
    resize(*scratch, lanes);
    const PanelColumns even = columnsOf(scratch->even);
    const PanelColumns odd = columnsOf(scratch->odd);
    m_Even.inverse({ in.values, 2 * in.stride }, even, lanes, scratch + 1);
    m_Odd.inverse({ in.values + in.stride, 2 * in.stride }, odd, lanes, scratch + 1);
    unfoldColumns(even, odd, m_N, lanes, m_Scales, out);
  }

private:
  void
  resize(HalfLines & lines, std::size_t lanes) const
  {
    lines.even.resize(static_cast<Eigen::Index>(lanes), m_Even.length);
    lines.odd.resize(static_cast<Eigen::Index>(lanes), m_Odd.length);
  }

  std::size_t   m_N;
  std::size_t   m_Folds{ 1 };
  FoldScales    m_Scales;
  HalfTransform m_Even;
  HalfTransform m_Odd;
};

void
HalfTransform::forward(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const
{
  if (folded)
  {
    folded->forward(in, out, lanes, scratch);
    return;
  }
  multiplyColumns(rows, in, out, lanes);
}

void
HalfTransform::inverse(const PanelColumns & in, const PanelColumns & out, std::size_t lanes, HalfLines * scratch) const
{
  if (folded)
  {
    folded->inverse(in, out, lanes, scratch);
    return;
  }
  multiplyColumns(rowsTransposed, in, out, lanes);
}

class DenseLineTransform : public LineTransform
{
public:
  explicit DenseLineTransform(std::shared_ptr<const FoldedTransform> tables)
    : m_Tables(std::move(tables)), m_Scratch(m_Tables->folds())
  {}

  void
  forward(LinePanel & panel) override
  {
    const PanelColumns lines = columnsOf(panel);
    m_Tables->forward(lines, lines, static_cast<std::size_t>(panel.rows()), m_Scratch.data());
  }

  void
  inverse(LinePanel & panel) override
  {
    const PanelColumns lines = columnsOf(panel);
    m_Tables->inverse(lines, lines, static_cast<std::size_t>(panel.rows()), m_Scratch.data());
  }

  [[nodiscard]] std::unique_ptr<LineTransform>
  clone() const override
  {
    return std::make_unique<DenseLineTransform>(m_Tables);
  }

private:
  std::shared_ptr<const FoldedTransform> m_Tables;
  std::vector<HalfLines>                 m_Scratch;
};
} // namespace

std::unique_ptr<LineTransform>
makeDenseLineTransform(int n, CubeTransform::Basis basis)
{
  return std::make_unique<DenseLineTransform>(
    std::make_shared<const FoldedTransform>(static_cast<std::size_t>(n), basis));
}

} // namespace moserhex
