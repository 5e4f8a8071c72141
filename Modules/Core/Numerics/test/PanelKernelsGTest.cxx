#include "PanelKernels.h"

#include "PanelKernelsInstructionSets.h"
#include "RandomField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace moserhex;
using namespace moserhex::testing;
using Eigen::Index;
using Eigen::MatrixXd;

namespace
{
MatrixXd
randomMatrix(Index rows, Index columns, std::uint64_t seed)
{
  return Eigen::Map<const MatrixXd>(randomField(rows * columns, seed).data(), rows, columns);
}

PanelColumns
columnsOf(MatrixXd & panel)
{
  return { panel.data(), static_cast<std::size_t>(panel.rows()) };
}

constexpr std::size_t lanes = 24;
constexpr Index       rows = 24;

/** One test case for each instruction set, skipped where the machine does not have it. */
class PanelKernelsOf : public ::testing::TestWithParam<const char *>
{
protected:
  void
  SetUp() override
  {
    const std::vector<PanelKernelsVariant> variants = panelKernelsVariants();
    const auto                             found = std::find_if(
      variants.begin(), variants.end(), [](const PanelKernelsVariant & v) { return v.name == GetParam(); });
    if (found == variants.end())
    {
      GTEST_SKIP() << "not run: this machine has no " << GetParam();
    }
    variant = *found;
  }

  PanelKernelsVariant variant;
};
} // namespace

INSTANTIATE_TEST_SUITE_P(InstructionSet,
                         PanelKernelsOf,
                         ::testing::ValuesIn(panelKernelsVariantNames),
                         [](const auto & set) { return std::string(set.param); });

TEST_P(PanelKernelsOf, ProductIsThatOfTheMatrices)
{
  for (const Index results : { 1, 2, 3, 4, 5, 6, 7, 13, 32 })
  {
    const Index        terms = results + 3;
    MatrixXd           in = randomMatrix(rows, terms, 1);
    MatrixXd           out = MatrixXd::Zero(rows, results);
    MatrixXd           chosen = out;
    const FactorMatrix factors = randomMatrix(results, terms, 2);
    variant.multiply(factors, columnsOf(in), columnsOf(out), lanes);
    EXPECT_LE((out - in * factors.transpose()).cwiseAbs().maxCoeff(), 1e-14 * static_cast<double>(terms)) << results;
    multiplyColumns(factors, columnsOf(in), columnsOf(chosen), lanes);
    EXPECT_TRUE(out == chosen) << results;
  }
}

TEST_P(PanelKernelsOf, FoldIsSumAndDifferenceAndUnfoldItsTranspose)
{
  const FoldScales scales{ 0.7, 1.3 };
  for (const Index n : { 1, 2, 3, 8, 11 })
  {
    MatrixXd lines = randomMatrix(rows, n, 3);
    MatrixXd even = MatrixXd::Zero(rows, (n + 1) / 2);
    MatrixXd odd = MatrixXd::Zero(rows, std::max<Index>(n / 2, 1));
    variant.fold(columnsOf(lines), static_cast<std::size_t>(n), lanes, scales, columnsOf(even), columnsOf(odd));
    for (Index i = 0; i < n / 2; ++i)
    {
      EXPECT_TRUE(even.col(i) == scales.even * (lines.col(i) + lines.col(n - 1 - i))) << n;
      EXPECT_TRUE(odd.col(i) == scales.odd * (lines.col(i) - lines.col(n - 1 - i))) << n;
    }
    if (n % 2 == 1)
    {
      EXPECT_TRUE(even.col(n / 2) == lines.col(n / 2)) << n;
    }
    // <fold x, (e, o)> = <x, unfold (e, o)>
    MatrixXd       e = randomMatrix(even.rows(), even.cols(), 4);
    MatrixXd       o = randomMatrix(odd.rows(), odd.cols(), 5);
    MatrixXd       back = MatrixXd::Zero(rows, n);
    const MatrixXd usedOdd = o.leftCols(n / 2);
    variant.unfold(columnsOf(e), columnsOf(o), static_cast<std::size_t>(n), lanes, scales, columnsOf(back));
    EXPECT_NEAR(even.cwiseProduct(e).sum() + odd.leftCols(n / 2).cwiseProduct(usedOdd).sum(),
                lines.cwiseProduct(back).sum(),
                1e-12)
      << n;
  }
}

TEST_P(PanelKernelsOf, TransposeMovesEveryValueAndNothingElse)
{
  for (const Index lines : { 1, 4, 7, 20 })
  {
    for (const Index n : { 1, 3, 8, 13 })
    {
      const MatrixXd from = randomMatrix(n + 1, lines, 6); // a line a column, one value more than is moved
      MatrixXd       to = MatrixXd::Constant(lines + 2, n, 9.0);
      variant.transpose(from.data(),
                        static_cast<std::size_t>(n + 1),
                        static_cast<std::size_t>(lines),
                        static_cast<std::size_t>(n),
                        to.data(),
                        static_cast<std::size_t>(lines + 2));
      EXPECT_TRUE(to.topRows(lines) == from.topRows(n).transpose()) << lines << " " << n;
      EXPECT_TRUE((to.bottomRows(2).array() == 9.0).all()) << lines << " " << n;
    }
  }
}
