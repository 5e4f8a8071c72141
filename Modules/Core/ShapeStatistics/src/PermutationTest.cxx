#include "moserhex/ShapeStatistics/PermutationTest.h"

#include "Arrangements.h"
#include "OrthonormalDesign.h"
#include "Slabs.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace moserhex
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr std::size_t  placesPerBlock = 256;
constexpr Eigen::Index ordersPerBatch = 64;
constexpr double       ridge = 1e-12;    ///< of the trace, added to a scatter
constexpr double       roundOff = 1e-24; ///< of the sum of squares: a scatter below it is none
constexpr double       tie = 1e-10;      ///< explained parts that differ by less, relatively, are equal

void
require(bool holds, const std::string & what)
{
  if (!holds)
  {
    throw InvalidInput("permutation test: " + what);
  }
}

void
requireArguments(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
{
  const auto subjects = static_cast<Eigen::Index>(table.subjects());
  require(design.effect.cols() == 0 || design.effect.rows() == subjects,
          std::to_string(design.effect.rows()) + " values of the effect for " + std::to_string(subjects) + " subjects");
  require(options.permutations >= 1, "no permutation");
}

/** The design made orthonormal, when there are enough subjects for it. \throws InvalidInput  as requireTestable */
OrthonormalDesign
testableDesign(const LinearDesign & design, std::size_t componentsPerPlace)
{
  const Eigen::Index subjects = design.effect.rows();
  require(subjects <= std::numeric_limits<std::uint16_t>::max(), "more than 65535 subjects");
  require(design.effect.cols() >= 1, "no effect");
  require(design.nuisance.cols() == 0 || design.nuisance.rows() == subjects,
          std::to_string(design.nuisance.rows()) + " values of the nuisance for " + std::to_string(subjects) +
            " subjects");
  require(design.effect.allFinite() && design.nuisance.allFinite(), "a value of the design is not finite");
  require(componentsPerPlace >= 1 && componentsPerPlace <= 3, "1 to 3 components a place");
  OrthonormalDesign  result = orthonormalised(design);
  const Eigen::Index rank = result.nuisance.cols() + result.effect.cols();
  require(subjects - rank >= static_cast<Eigen::Index>(componentsPerPlace),
          std::to_string(subjects) + " subjects for " + std::to_string(rank) + " effects and " +
            std::to_string(componentsPerPlace) + " components");
  return result;
}

/** Effect and nuisance of every subject, without the columns that are left out. */
Matrix
differentRows(const LinearDesign & design, const std::vector<std::size_t> & nuisanceLeftOut)
{
  Matrix       rows(design.effect.rows(), design.effect.cols() + design.nuisance.cols());
  Eigen::Index count = design.effect.cols();
  rows.leftCols(count) = design.effect;
  for (Eigen::Index column = 0; column < design.nuisance.cols(); ++column)
  {
    if (std::find(nuisanceLeftOut.begin(), nuisanceLeftOut.end(), static_cast<std::size_t>(column)) ==
        nuisanceLeftOut.end())
    {
      rows.col(count++) = design.nuisance.col(column);
    }
  }
  return rows.leftCols(count);
}

/** The columns that are permuted: the effect first, then the nuisance without the constant, to which residuals are
 * orthogonal in every order. */
Matrix
permutedColumns(const OrthonormalDesign & design)
{
  Matrix columns(design.effect.rows(), design.effect.cols() + design.nuisance.cols() - 1);
  columns << design.effect, design.nuisance.rightCols(design.nuisance.cols() - 1);
  return columns;
}

/** N x (columns x orders): column c in order o is number c + columns x o. */
Matrix
arranged(const Matrix & columns, const Arrangements & arrangements, Eigen::Index begin, Eigen::Index end)
{
  Matrix result(columns.rows(), columns.cols() * (end - begin));
  for (Eigen::Index o = begin; o < end; ++o)
  {
    const auto & order = arrangements.orders[static_cast<std::size_t>(o)];
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
    {
      double * target = result.col(c + columns.cols() * (o - begin)).data();
      for (std::size_t s = 0; s < order.size(); ++s)
      {
        target[s] = columns(order[s], c);
      }
    }
  }
  return result;
}

/** What is left of a place's numbers after the nuisance, made white: their scatter becomes the identity. Zeros where
 * nothing is left. \param squares  of the place's numbers as they are */
void
whitenInPlace(Eigen::Ref<Matrix> residuals, double squares)
{
  Matrix       scatter = residuals.transpose() * residuals;
  const double trace = scatter.trace();
  if (!(trace > roundOff * squares))
  {
    residuals.setZero();
    return;
  }
  scatter.diagonal().array() += ridge * trace;
  const Eigen::LLT<Matrix> factors(scatter);
  residuals = factors.matrixU().solve<Eigen::OnTheRight>(residuals).eval();
}

/** V = tr((1 - B^T B)^-1 A^T A), the part that the effect explains of white residuals, of which the permuted nuisance
 * takes B: Pillai's trace. \param products  columns x q: A in the first `effects` rows, B below */
double
explainedPart(const Eigen::Ref<const Matrix> & products, Eigen::Index effects)
{
  const auto effect = products.topRows(effects);
  if (products.rows() == effects)
  {
    return effect.squaredNorm();
  }
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  const Eigen::Index q = products.cols();
  const auto         nuisance = products.bottomRows(products.rows() - effects);
  Small              left = Small::Identity(q, q);
  left.noalias() -= nuisance.transpose().lazyProduct(nuisance);
  left.diagonal().array() += ridge;
  const Eigen::LLT<Small> factors(left);
  double                  sum = 0.0;
  for (Eigen::Index row = 0; row < effects; ++row)
  {
    const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1> a = effect.row(row).transpose();
    sum += a.dot(factors.solve(a));
  }
  return sum;
}

/** The larger of exactly two different values less the other; 0: there are more, or several columns. */
double
differenceOfTwoValues(const Matrix & effect)
{
  if (effect.cols() > 1)
  {
    return 0.0;
  }
  const double low = effect.minCoeff();
  const double high = effect.maxCoeff();
  const bool   areTwo = ((effect.array() == low) || (effect.array() == high)).all();
  return areTwo ? high - low : 0.0;
}

class Test
{
public:
  Test(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
    : m_Table(table)
    , m_Options(options)
    , m_Design(testableDesign(design, options.componentsPerPlace))
    , m_Columns(permutedColumns(m_Design))
    , m_Effects(design.effect.cols())
    , m_Components(static_cast<Eigen::Index>(options.componentsPerPlace))
    , m_Places(static_cast<Eigen::Index>(table.columns() / options.componentsPerPlace))
  {
    const Eigen::Index rank = m_Design.nuisance.cols() + m_Effects;
    require(m_Places > 0 && table.columns() % options.componentsPerPlace == 0,
            std::to_string(table.columns()) + " columns, need some for each place");
    m_Result.degreesOfFreedom = static_cast<std::size_t>(design.effect.rows() - rank);
    m_Result.nuisanceLeftOut = m_Design.nuisanceLeftOut;
    m_TwoValues = differenceOfTwoValues(design.effect);
    m_Arrangements =
      arrangementsOf(differentRows(design, m_Design.nuisanceLeftOut), options.permutations, options.seed);
    m_Result.areAllOrders = m_Arrangements.areAll;
    m_Result.isExact = m_Arrangements.areAll && m_Design.nuisance.cols() == 1;
    m_Result.permutations = m_Arrangements.orders.size();
    m_Result.smallestPossibleP = partOfEqualOrders();
  }

  PermutationResult
  run()
  {
    m_Result.slope.resize(m_Components * m_Effects, m_Places);
    m_Explained.resize(m_Places);
    m_Result.p.resize(m_Places);
    const std::size_t blocks = (static_cast<std::size_t>(m_Places) + placesPerBlock - 1) / placesPerBlock;
    std::vector<std::vector<double>> largest(blocks);
    parallelFor(blocks, m_Options.threads, [&](std::size_t block) {
      const auto begin = static_cast<Eigen::Index>(block * placesPerBlock);
      largest[block] = testPlaces(begin, std::min<Eigen::Index>(placesPerBlock, m_Places - begin));
    });
    correctForPlaces(largest);
    m_Result.qFalseDiscovery = falseDiscoveryRates(m_Result.p);
    setStatistics();
    return std::move(m_Result);
  }

private:
  /** Calls work(first, last, products) for all orders from the subjects' own on, a batch at a time.
   * \param numbers  N x any \param work  products: those of all columns in orders first to last - 1 with the numbers */
  template <typename TWork>
  void
  forEachBatch(const Matrix & numbers, const TWork & work) const
  {
    const auto orders = static_cast<Eigen::Index>(m_Arrangements.orders.size());
    for (Eigen::Index first = 0; first < orders; first += ordersPerBatch)
    {
      const Eigen::Index last = std::min(first + ordersPerBatch, orders);
      work(first, last, Matrix(arranged(m_Columns, m_Arrangements, first, last).transpose() * numbers));
    }
  }

  /** Part of the orders whose effect spans what the subjects' own does, such as those of two groups of one size that
   * change places. Whatever the numbers, their V is not smaller: A^T A is the same, and B, which is 0 of the subjects'
   * own order, can only make it larger. */
  [[nodiscard]] double
  partOfEqualOrders() const
  {
    const Eigen::Index columns = m_Columns.cols();
    std::size_t        equal = 0;
    forEachBatch(m_Columns.leftCols(m_Effects), [&](Eigen::Index first, Eigen::Index last, const Matrix & products) {
      for (Eigen::Index order = first; order < last; ++order)
      {
        const double shared = products.middleRows(columns * (order - first), m_Effects).squaredNorm();
        equal += isAtLeast(shared, static_cast<double>(m_Effects)) ? 1 : 0;
      }
    });
    return static_cast<double>(equal) / static_cast<double>(m_Arrangements.orders.size());
  }

  /** Fits the places, and leaves their white residuals. */
  Matrix
  fitPlaces(Eigen::Index begin, Eigen::Index count)
  {
    const auto   q = m_Components;
    const Matrix values = m_Table.read(static_cast<std::size_t>(q * begin), static_cast<std::size_t>(q * count));
    if (!values.allFinite())
    {
      throw InvalidInput("permutation test: a number of places " + std::to_string(begin) + " to " +
                         std::to_string(begin + count - 1) + " is not finite");
    }
    Matrix residuals = values - m_Design.nuisance * (m_Design.nuisance.transpose() * values);
    for (Eigen::Index place = 0; place < count; ++place)
    {
      auto         block = residuals.middleCols(q * place, q);
      const Matrix slopes = m_Design.coefficients(block);
      m_Result.slope.col(begin + place) = Eigen::Map<const Vector>(slopes.data(), slopes.size());
      whitenInPlace(block, values.middleCols(q * place, q).squaredNorm());
    }
    return residuals;
  }

  /** p of a block of places. \return the largest explained part of every order */
  std::vector<double>
  testPlaces(Eigen::Index begin, Eigen::Index count)
  {
    const Matrix             residuals = fitPlaces(begin, count);
    std::vector<double>      largest(m_Arrangements.orders.size(), 0.0);
    std::vector<std::size_t> atLeast(static_cast<std::size_t>(count), 0);
    forEachBatch(residuals, [&](Eigen::Index first, Eigen::Index last, const Matrix & products) {
      for (Eigen::Index place = 0; place < count; ++place)
      {
        for (Eigen::Index order = first; order < last; ++order)
        {
          const double part = explainedPart(
            products.block(m_Columns.cols() * (order - first), m_Components * place, m_Columns.cols(), m_Components),
            m_Effects);
          if (order == 0)
          {
            m_Explained[begin + place] = part;
          }
          atLeast[static_cast<std::size_t>(place)] += isAtLeast(part, m_Explained[begin + place]) ? 1 : 0;
          double & largestOfOrder = largest[static_cast<std::size_t>(order)];
          largestOfOrder = std::max(largestOfOrder, part);
        }
      }
    });
    for (Eigen::Index place = 0; place < count; ++place)
    {
      m_Result.p[begin + place] =
        static_cast<double>(atLeast[static_cast<std::size_t>(place)]) / static_cast<double>(largest.size());
    }
    return largest;
  }

  static bool
  isAtLeast(double part, double observed)
  {
    return part >= observed * (1.0 - tie);
  }

  /** Family-wise p, by the largest part of every order over all places. */
  void
  correctForPlaces(const std::vector<std::vector<double>> & largestOfBlocks)
  {
    std::vector<double> largest = largestOfBlocks.front();
    for (const std::vector<double> & block : largestOfBlocks)
    {
      for (std::size_t order = 0; order < largest.size(); ++order)
      {
        largest[order] = std::max(largest[order], block[order]);
      }
    }
    std::sort(largest.begin(), largest.end());
    m_Result.pFamilyWise.resize(m_Places);
    for (Eigen::Index place = 0; place < m_Places; ++place)
    {
      const auto first = std::lower_bound(largest.begin(), largest.end(), m_Explained[place] * (1.0 - tie));
      m_Result.pFamilyWise[place] = static_cast<double>(largest.end() - first) / static_cast<double>(largest.size());
    }
  }

  void
  setStatistics()
  {
    const double df = static_cast<double>(m_Result.degreesOfFreedom);
    const Vector part = m_Explained / static_cast<double>(std::min(m_Effects, m_Components));
    // Less the ridge's share, the part stays below 1.
    m_Result.statistic = df * part.cwiseQuotient((1.0 - part.array()).max(ridge).matrix());
    m_Result.pillaiTrace = m_Explained;
    m_Result.partialCorrelation = part.cwiseMin(1.0).cwiseSqrt();
    if (m_TwoValues > 0.0)
    {
      // T^2 = b^T Sigma^-1 b |effect left|^2
      m_Result.standardisedDifference = m_Result.statistic.cwiseSqrt() * (m_TwoValues / m_Design.mixing(0, 0));
    }
    if (m_Components == 1 && m_Effects == 1) // of one number the effect has a direction
    {
      const Vector sign = m_Result.slope.row(0).transpose().unaryExpr([](double b) { return b < 0.0 ? -1.0 : 1.0; });
      m_Result.partialCorrelation.array() *= sign.array();
      if (m_Result.standardisedDifference.size() > 0)
      {
        m_Result.standardisedDifference.array() *= sign.array();
      }
    }
  }

  const SubjectTable & m_Table;
  PermutationOptions   m_Options;
  OrthonormalDesign    m_Design;
  Matrix               m_Columns;
  Eigen::Index         m_Effects;
  Eigen::Index         m_Components;
  Eigen::Index         m_Places;
  Arrangements         m_Arrangements;
  Vector               m_Explained;
  double               m_TwoValues{ 0.0 }; ///< difference of the effect's values where it has just two
  PermutationResult    m_Result;
};

} // namespace

void
requireTestable(const LinearDesign & design, std::size_t componentsPerPlace)
{
  (void)testableDesign(design, componentsPerPlace);
}

PermutationResult
permutationTest(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
{
  requireArguments(table, design, options);
  return Test(table, design, options).run();
}

Vector
falseDiscoveryRates(const Vector & p)
{
  std::vector<Eigen::Index> ascending(static_cast<std::size_t>(p.size()));
  std::iota(ascending.begin(), ascending.end(), Eigen::Index{ 0 });
  std::stable_sort(ascending.begin(), ascending.end(), [&](Eigen::Index a, Eigen::Index b) { return p[a] < p[b]; });
  Vector q(p.size());
  double smallest = 1.0;
  for (std::size_t rank = ascending.size(); rank-- > 0;)
  {
    const Eigen::Index place = ascending[rank];
    smallest = std::min(smallest, static_cast<double>(p.size()) * p[place] / static_cast<double>(rank + 1));
    q[place] = smallest;
  }
  return q;
}

} // namespace moserhex
