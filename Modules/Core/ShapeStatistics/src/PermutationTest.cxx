#include "moserhex/ShapeStatistics/PermutationTest.h"

#include "Arrangements.h"
#include "Slabs.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

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
constexpr double       smallestLeftOver = 1e-10; ///< of the effect's squares, after the nuisance
constexpr double       ridge = 1e-12;            ///< of the trace, added to a scatter
constexpr double       roundOff = 1e-24;         ///< of the sum of squares: a scatter below it is none
constexpr double       tie = 1e-10;              ///< explained parts that differ by less, relatively, are equal

void
requireArguments(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
{
  const auto require = [](bool holds, const std::string & what) {
    if (!holds)
    {
      throw InvalidInput("permutation test: " + what);
    }
  };
  const auto subjects = static_cast<Eigen::Index>(table.subjects());
  require(subjects <= std::numeric_limits<std::uint16_t>::max(), "more than 65535 subjects");
  require(design.effect.size() == subjects,
          std::to_string(design.effect.size()) + " values of the effect for " + std::to_string(subjects) + " subjects");
  require(design.nuisance.cols() == 0 || design.nuisance.rows() == subjects,
          std::to_string(design.nuisance.rows()) + " values of the nuisance for " + std::to_string(subjects) +
            " subjects");
  require(design.effect.allFinite() && design.nuisance.allFinite(), "a value of the design is not finite");
  require(options.permutations >= 1, "no permutation");
  require(options.componentsPerPlace >= 1 && options.componentsPerPlace <= 3, "1 to 3 components a place");
  require(table.columns() > 0 && table.columns() % options.componentsPerPlace == 0,
          std::to_string(table.columns()) + " columns, need some for each place");
}

/** Orthonormal columns: constant and nuisance, then what is left of the effect. */
struct OrthonormalDesign
{
  Matrix nuisance;            ///< N x (rank of constant and nuisance); the first is the constant
  Vector effect;              ///< N
  double effectLength{ 0.0 }; ///< of what was left of the effect
};

OrthonormalDesign
orthonormalised(const LinearDesign & design)
{
  const Eigen::Index subjects = design.effect.size();
  OrthonormalDesign  result;
  result.nuisance = Matrix::Constant(subjects, 1, 1.0 / std::sqrt(static_cast<double>(subjects)));
  if (design.nuisance.cols() > 0)
  {
    // Columns of equal length, so that a covariate's unit does not decide its rank.
    Matrix centred = design.nuisance.rowwise() - design.nuisance.colwise().mean();
    centred.colwise().normalize();
    const Eigen::ColPivHouseholderQR<Matrix> qr(centred);
    const Eigen::Index                       rank = qr.rank();
    const Matrix                             basis = qr.householderQ() * Matrix::Identity(subjects, rank);
    result.nuisance.conservativeResize(Eigen::NoChange, 1 + rank);
    result.nuisance.rightCols(rank) = basis;
  }
  const Vector centred = design.effect.array() - design.effect.mean();
  result.effect = centred - result.nuisance * (result.nuisance.transpose() * centred);
  result.effect -= result.nuisance * (result.nuisance.transpose() * result.effect); // the rounding of the first time
  if (!(result.effect.squaredNorm() > smallestLeftOver * centred.squaredNorm()))
  {
    throw InvalidInput("permutation test: the effect is constant, or the nuisance explains it");
  }
  result.effectLength = result.effect.norm();
  result.effect /= result.effectLength;
  return result;
}

/** The columns that are permuted: the effect first, then the nuisance without the constant, to which residuals are
 * orthogonal in every order. */
Matrix
permutedColumns(const OrthonormalDesign & design)
{
  Matrix columns(design.effect.size(), design.nuisance.cols());
  columns.col(0) = design.effect;
  columns.rightCols(design.nuisance.cols() - 1) = design.nuisance.rightCols(design.nuisance.cols() - 1);
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

/** r = a^T (1 - B^T B)^-1 a, the part that the effect explains of white residuals, of which the permuted nuisance
 * takes B. \param products  columns x q: a in the first row, B below */
double
explainedPart(const Eigen::Ref<const Matrix> & products)
{
  const auto effect = products.row(0);
  if (products.rows() == 1)
  {
    return effect.squaredNorm();
  }
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  const Eigen::Index q = products.cols();
  const auto         nuisance = products.bottomRows(products.rows() - 1);
  Small              left = Small::Identity(q, q);
  left.noalias() -= nuisance.transpose().lazyProduct(nuisance);
  left.diagonal().array() += ridge;
  const Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1> a = effect.transpose();
  return a.dot(left.llt().solve(a));
}

class Test
{
public:
  Test(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
    : m_Table(table)
    , m_Options(options)
    , m_Design(orthonormalised(design))
    , m_Columns(permutedColumns(m_Design))
    , m_Components(static_cast<Eigen::Index>(options.componentsPerPlace))
    , m_Places(static_cast<Eigen::Index>(table.columns() / options.componentsPerPlace))
  {
    const Eigen::Index rank = m_Design.nuisance.cols() + 1;
    if (design.effect.size() - rank < m_Components)
    {
      throw InvalidInput("permutation test: " + std::to_string(design.effect.size()) + " subjects for " +
                         std::to_string(rank) + " effects and " + std::to_string(m_Components) + " components");
    }
    m_Result.degreesOfFreedom = static_cast<std::size_t>(design.effect.size() - rank);
    Matrix rows(design.effect.size(), 1 + design.nuisance.cols());
    rows << design.effect, design.nuisance;
    m_Arrangements = arrangementsOf(rows, options.permutations, options.seed);
    m_Result.isExact = m_Arrangements.isExact;
    m_Result.permutations = m_Arrangements.orders.size();
  }

  PermutationResult
  run()
  {
    m_Result.slope.resize(m_Components, m_Places);
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
      auto block = residuals.middleCols(q * place, q);
      m_Result.slope.col(begin + place) = block.transpose() * m_Design.effect / m_Design.effectLength;
      whitenInPlace(block, values.middleCols(q * place, q).squaredNorm());
    }
    return residuals;
  }

  /** p of a block of places. \return the largest explained part of every order */
  std::vector<double>
  testPlaces(Eigen::Index begin, Eigen::Index count)
  {
    const Matrix             residuals = fitPlaces(begin, count);
    const auto               orders = static_cast<Eigen::Index>(m_Arrangements.orders.size());
    std::vector<double>      largest(m_Arrangements.orders.size(), 0.0);
    std::vector<std::size_t> atLeast(static_cast<std::size_t>(count), 0);
    for (Eigen::Index first = 0; first < orders; first += ordersPerBatch)
    {
      const Eigen::Index last = std::min(first + ordersPerBatch, orders);
      const Matrix       products = arranged(m_Columns, m_Arrangements, first, last).transpose() * residuals;
      for (Eigen::Index place = 0; place < count; ++place)
      {
        for (Eigen::Index order = first; order < last; ++order)
        {
          const double part = explainedPart(
            products.block(m_Columns.cols() * (order - first), m_Components * place, m_Columns.cols(), m_Components));
          if (order == 0)
          {
            m_Explained[begin + place] = part;
          }
          atLeast[static_cast<std::size_t>(place)] += isAtLeast(part, m_Explained[begin + place]) ? 1 : 0;
          double & largestOfOrder = largest[static_cast<std::size_t>(order)];
          largestOfOrder = std::max(largestOfOrder, part);
        }
      }
    }
    for (Eigen::Index place = 0; place < count; ++place)
    {
      m_Result.p[begin + place] =
        static_cast<double>(atLeast[static_cast<std::size_t>(place)]) / static_cast<double>(orders);
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
    // Less the ridge's share, r stays below 1.
    const Vector unexplained = (1.0 - m_Explained.array()).max(ridge);
    m_Result.statistic = df * m_Explained.cwiseQuotient(unexplained);
    m_Result.partialCorrelation = m_Explained.cwiseMin(1.0).cwiseSqrt();
  }

  const SubjectTable & m_Table;
  PermutationOptions   m_Options;
  OrthonormalDesign    m_Design;
  Matrix               m_Columns;
  Eigen::Index         m_Components;
  Eigen::Index         m_Places;
  Arrangements         m_Arrangements;
  Vector               m_Explained;
  PermutationResult    m_Result;
};

/** The larger of exactly two different values less the other; 0: there are more. */
double
differenceOfTwoValues(const Vector & effect)
{
  const double low = effect.minCoeff();
  const double high = effect.maxCoeff();
  const bool   areTwo = ((effect.array() == low) || (effect.array() == high)).all();
  return areTwo ? high - low : 0.0;
}

} // namespace

PermutationResult
permutationTest(const SubjectTable & table, const LinearDesign & design, const PermutationOptions & options)
{
  requireArguments(table, design, options);
  PermutationResult result = Test(table, design, options).run();
  const double      difference = differenceOfTwoValues(design.effect);
  if (difference > 0.0)
  {
    // T^2 = b^T Sigma^-1 b |effect left|^2
    const double length = orthonormalised(design).effectLength;
    result.standardisedDifference = result.statistic.cwiseSqrt() * (difference / length);
  }
  return result;
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
