#include "LineTransform.h"
#include "PanelKernels.h"

#include "moserhex/Numerics/CosineTransform.h"

#include <cmath>

namespace moserhex
{
namespace
{
using Basis = CubeTransform::Basis;

/** Halves at least this long are folded again; shorter ones cost more to fold than to multiply. */
constexpr std::size_t smallestFoldedHalf = 12;

class FoldedTransform;

/** The even or the odd rows of a transform on half lines: a matrix, or the same transform of half the length. */
struct HalfTransform
{
  FactorMatrix                     rows;
  FactorMatrix                     rowsTransposed; // for the inverse
  std::unique_ptr<FoldedTransform> folded;
  Eigen::MatrixXd                  line; // scratch: a half line a column of lanes

  [[nodiscard]] PanelColumns
  columns()
  {
    return { line.data(), static_cast<std::size_t>(line.rows()) };
  }

  void
  forward(const PanelColumns & out, std::size_t lanes);

  void
  inverse(const PanelColumns & in, std::size_t lanes);
};

/** Row a of the cosine and of the sine matrix is even (a even) or odd (a odd) under i -> n-1-i. So with the half lines
 * e_i = x_i + x_{n-1-i}, o_i = x_i - x_{n-1-i}, the even rows of the result need e alone and the odd rows o: n^2 / 2
 * products. The even rows of the cosine transform of even length are a cosine transform of e / sqrt(2), and the odd
 * rows of the sine transform of odd length a sine transform of o / sqrt(2), which is folded again: towards n^2 / 3. */
class FoldedTransform
{
public:
  FoldedTransform(std::size_t n, Basis basis) : m_N(n)
  {
    const auto            size = static_cast<int>(n);
    const Eigen::MatrixXd matrix = basis == Basis::Cosine ? cosineMatrix(size) : sineMatrix(size);
    const auto            setRows = [&](HalfTransform & half, Eigen::Index count, Eigen::Index firstRow) {
      half.rows.resize(count, count);
      for (Eigen::Index a = 0; a < count; ++a)
      {
        half.rows.row(a) = matrix.row(2 * a + firstRow).head(count);
      }
      half.rowsTransposed = half.rows.transpose();
    };
    setRows(m_Even, (size + 1) / 2, 0);
    setRows(m_Odd, size / 2, 1);
    if (n / 2 >= smallestFoldedHalf && basis == Basis::Cosine && n % 2 == 0)
    {
      m_Even.folded = std::make_unique<FoldedTransform>(n / 2, basis);
      m_Scales.even = std::sqrt(0.5);
    }
    if (n / 2 >= smallestFoldedHalf && basis == Basis::Sine && n % 2 == 1)
    {
      m_Odd.folded = std::make_unique<FoldedTransform>(n / 2, basis);
      m_Scales.odd = std::sqrt(0.5);
    }
  }

  /** `out` may be `in`. */
  void
  forward(const PanelColumns & in, const PanelColumns & out, std::size_t lanes)
  {
    resizeScratch(lanes);
    foldColumns(in, m_N, lanes, m_Scales, m_Even.columns(), m_Odd.columns());
    m_Even.forward({ out.values, 2 * out.stride }, lanes);
    m_Odd.forward({ out.values + out.stride, 2 * out.stride }, lanes);
  }

  /** `out` may be `in`. */
  void
  inverse(const PanelColumns & in, const PanelColumns & out, std::size_t lanes)
  {
    resizeScratch(lanes);
    m_Even.inverse({ in.values, 2 * in.stride }, lanes);
    m_Odd.inverse({ in.values + in.stride, 2 * in.stride }, lanes);
    unfoldColumns(m_Even.columns(), m_Odd.columns(), m_N, lanes, m_Scales, out);
  }

private:
  void
  resizeScratch(std::size_t lanes)
  {
    m_Even.line.resize(static_cast<Eigen::Index>(lanes), m_Even.rows.cols());
    m_Odd.line.resize(static_cast<Eigen::Index>(lanes), m_Odd.rows.cols());
  }

  std::size_t   m_N;
  FoldScales    m_Scales;
  HalfTransform m_Even;
  HalfTransform m_Odd;
};

void
HalfTransform::forward(const PanelColumns & out, std::size_t lanes)
{
  if (folded)
  {
    folded->forward(columns(), out, lanes);
    return;
  }
  multiplyColumns(rows, columns(), out, lanes);
}

void
HalfTransform::inverse(const PanelColumns & in, std::size_t lanes)
{
  if (folded)
  {
    folded->inverse(in, columns(), lanes);
    return;
  }
  multiplyColumns(rowsTransposed, in, columns(), lanes);
}

class DenseLineTransform : public LineTransform
{
public:
  DenseLineTransform(int n, Basis basis) : m_N(n), m_Basis(basis), m_Folded(static_cast<std::size_t>(n), basis)
  {}

  void
  forward(LinePanel & panel) override
  {
    m_Folded.forward(columnsOf(panel), columnsOf(panel), static_cast<std::size_t>(panel.rows()));
  }

  void
  inverse(LinePanel & panel) override
  {
    m_Folded.inverse(columnsOf(panel), columnsOf(panel), static_cast<std::size_t>(panel.rows()));
  }

  [[nodiscard]] std::unique_ptr<LineTransform>
  clone() const override
  {
    return std::make_unique<DenseLineTransform>(m_N, m_Basis);
  }

private:
  static PanelColumns
  columnsOf(LinePanel & panel)
  {
    return { panel.data(), static_cast<std::size_t>(panel.rows()) };
  }

  int             m_N;
  Basis           m_Basis;
  FoldedTransform m_Folded;
};
} // namespace

std::unique_ptr<LineTransform>
makeDenseLineTransform(int n, CubeTransform::Basis basis)
{
  return std::make_unique<DenseLineTransform>(n, basis);
}

} // namespace moserhex
