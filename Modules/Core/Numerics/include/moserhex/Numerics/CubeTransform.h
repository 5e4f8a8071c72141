#pragma once

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace moserhex
{

/** How several fields on one lattice share a vector; value c of point p of C components on P points. */
enum class ComponentOrder
{
  Interleaved, ///< at c + C p, as in a std::vector<Vector3>
  Stacked      ///< at p + P c
};

/** The orthonormal cosine or sine transform along all three axes of fields of n^3 values, entry (i,j,k) at i + n (j + n
 * k):
 *
 *   cosine (DCT-II, its inverse DCT-III)  C(a,i) = s_a cos(pi a (i + 1/2) / n),  s_0 = sqrt(1/n), else sqrt(2/n)
 *   sine   (DST-I, its own inverse)       S(a,i) = sqrt(2/(n+1)) sin(pi (a+1)(i+1) / (n+1))
 *   out(a,b,c) = sum C(a,i) C(b,j) C(c,k) in(i,j,k)
 *
 * Two engines give the same numbers to round-off: dense matrices, halved by their even and odd rows, O(n^4); and a
 * fast Fourier transform, O(n^3 log n) when n (sine: n + 1) has small prime factors. Automatic takes the faster one.
 * \note Const and safe to share between threads; copies share everything. The threads at work share the dense engine's
 * O(n^2) tables and have O(n) scratch each (the fast engine's O(n) tables included), allocated once and used again. The
 * same bytes for any number of threads. */
class CubeTransform
{
public:
  /** Which functions a field is a sum of along each axis. */
  enum class Basis
  {
    Cosine, ///< DCT-II: free ends
    Sine    ///< DST-I: zero beyond both ends
  };
  /** How the transform is computed; the numbers are the same to round-off. */
  enum class Engine
  {
    Automatic, ///< the faster one
    Dense,     ///< matrices
    Fast       ///< fast Fourier transform
  };

  /** \throws InvalidInput  n < 1 */
  CubeTransform(int n, Basis basis, Engine engine = Engine::Automatic);

  /** n: values a side. */
  [[nodiscard]] int
  size() const;

  /** The engine in use: Dense or Fast. */
  [[nodiscard]] Engine
  engine() const;

  /** Field to spectrum, in place. \param fields  one or more components of n^3 values; \param threads  0: all.
   * \throws InvalidInput  the number of values is not a positive multiple of n^3 */
  void
  forwardInPlace(Eigen::Ref<Eigen::VectorXd> fields,
                 ComponentOrder              order = ComponentOrder::Interleaved,
                 unsigned int                threads = 1) const;

  /** Spectrum to field: undoes forwardInPlace. \throws InvalidInput  as there */
  void
  inverseInPlace(Eigen::Ref<Eigen::VectorXd> spectra,
                 ComponentOrder              order = ComponentOrder::Interleaved,
                 unsigned int                threads = 1) const;

  /** fields := T^-1 diag(symbol) T fields, T this transform, the same symbol for every component. Cheaper than
   * transforming there and back. \param symbol  n^3 factors, (a,b,c) at a + n (b + n c)
   * \throws InvalidInput  as above, or the symbol does not have n^3 entries */
  void
  multiplySpectrumInPlace(Eigen::Ref<Eigen::VectorXd> fields,
                          const Eigen::VectorXd &     symbol,
                          ComponentOrder              order = ComponentOrder::Interleaved,
                          unsigned int                threads = 1) const;

  /** The same for a matrix with a component in each column; columns may be any distance apart. \param fields  n^3 rows
   * \throws InvalidInput  another number of rows, or as above */
  void
  multiplySpectraOfColumnsInPlace(Eigen::Ref<Eigen::MatrixXd> fields,
                                  const Eigen::VectorXd &     symbol,
                                  unsigned int                threads = 1) const;

private:
  struct Plan;
  std::shared_ptr<const Plan> m_Plan;
};

/** Eigenvalues 2 - 2 cos(pi a / n) (cosine) or 2 - 2 cos(pi (a+1) / (n+1)) (sine), a = 0 ... n-1, of the
 * one-dimensional graph Laplacian of n points whose eigenvectors are the rows of the transform: free ends (cosine) or
 * zero values beyond both ends (sine). \throws InvalidInput  n < 1 */
[[nodiscard]] Eigen::VectorXd
laplacianEigenvalues(int n, CubeTransform::Basis basis);

/** The operator T^-1 diag(symbol) T on fields of n^3 values: a function of the lattice Laplacian, for example.
 * Built once, applied often; const and safe to share between threads. */
class SpectralOperator
{
public:
  /** \param symbol  n^3 factors, (a,b,c) at a + n (b + n c). \throws InvalidInput  of another size */
  SpectralOperator(CubeTransform transform, Eigen::VectorXd symbol);

  /** \param symbol  the factor of frequency (a,b,c), each 0 ... n-1 */
  SpectralOperator(CubeTransform transform, const std::function<double(int a, int b, int c)> & symbol);

  /** As given to the constructor. */
  [[nodiscard]] const CubeTransform &
  transform() const
  {
    return m_Transform;
  }

  /** n^3 factors, (a,b,c) at a + n (b + n c). */
  [[nodiscard]] const Eigen::VectorXd &
  symbol() const
  {
    return m_Symbol;
  }

  /** \param fields  one or more components of n^3 values; \param threads  0: all.
   * \throws InvalidInput  the number of values is not a positive multiple of n^3 */
  void
  applyInPlace(Eigen::Ref<Eigen::VectorXd> fields,
               ComponentOrder              order = ComponentOrder::Interleaved,
               unsigned int                threads = 1) const;

  /** The same for a matrix with a component in each column, n^3 rows, columns any distance apart.
   * \throws InvalidInput  another number of rows */
  void
  applyToColumnsInPlace(Eigen::Ref<Eigen::MatrixXd> fields, unsigned int threads = 1) const;

private:
  CubeTransform   m_Transform;
  Eigen::VectorXd m_Symbol;
};

/** The operator g(L), L the graph Laplacian of n^3 lattice points,
 *
 *   (L u)(point) = sum over its neighbours of (u(point) - u(neighbour))                        positive semidefinite
 *
 * with free ends (cosine), or with zero values on the points around the lattice (sine: L has 6 on its diagonal).
 * (L + sigma)^-1 is g(lambda) = 1 / (lambda + sigma). \param g  at the eigenvalues: 0 <= lambda < 12
 * \throws InvalidInput  n < 1 */
[[nodiscard]] SpectralOperator
functionOfLaplacian(int n, CubeTransform::Basis basis, const std::function<double(double lambda)> & g);

} // namespace moserhex
