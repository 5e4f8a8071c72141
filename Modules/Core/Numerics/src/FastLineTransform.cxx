#include "LineTransform.h"

#include "moserhex/Common/Types.h"

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

// Our own copy of the class, which no other of the program's can be taken for: it is compiled with an option of its
// own. All headers that it includes come before.
namespace
{
#include <kissfft/kissfft.hh>
}

namespace moserhex
{
namespace
{
using Complex = std::complex<double>;

/** Two real lines go through one complex transform z = x + i y of their length. Values i of both lie side by side in
 * the panel, so a pair of lines is a line of complex numbers. */
class FastLineTransform : public LineTransform
{
public:
  explicit FastLineTransform(std::size_t length)
    : m_Length(length), m_Fourier(length, false), m_In(length), m_Out(length)
  {}

  void
  forward(LinePanel & panel) override
  {
    transformPairs(panel, [this](Complex * line, Eigen::Index step) { forward(line, step); });
  }

  void
  inverse(LinePanel & panel) override
  {
    transformPairs(panel, [this](Complex * line, Eigen::Index step) { inverse(line, step); });
  }

protected:
  virtual void
  forward(Complex * line, Eigen::Index step) = 0;

  virtual void
  inverse(Complex * line, Eigen::Index step) = 0;

  std::size_t          m_Length;
  kissfft<double>      m_Fourier;
  std::vector<Complex> m_In;
  std::vector<Complex> m_Out;

private:
  template <class Body>
  void
  transformPairs(LinePanel & panel, const Body & body)
  {
    const Eigen::Index pairs = panel.rows() / 2;
    for (Eigen::Index pair = 0; pair < pairs; ++pair)
    {
      body(reinterpret_cast<Complex *>(panel.data()) + pair, pairs);
    }
  }
};

/** DCT-II by one Fourier transform of the even values forwards and the odd values backwards,
 * v = (x_0, x_2, x_4, ... x_5, x_3, x_1): with V the transform of v,
 *
 *   sum x_i cos(pi k (i + 1/2) / n) = Re(exp(-i pi k / 2n) V_k)                                    [Makhoul 1980]
 *
 * V_{n-k} is the conjugate of V_k for each of the two lines, so entries k and n-k of the result are a rotation of
 * (Re V_k, Im V_k), which is undone for the inverse. */
class FastCosineTransform : public FastLineTransform
{
public:
  explicit FastCosineTransform(std::size_t n) : FastLineTransform(n), m_FourierInverse(n, true), m_Rotation(n)
  {
    for (std::size_t k = 0; k < n; ++k)
    {
      m_Rotation[k] = std::polar(1.0 / std::sqrt(2.0 * static_cast<double>(n)),
                                 pi * static_cast<double>(k) / (2.0 * static_cast<double>(n)));
    }
    m_ScaleOfConstant = 1.0 / std::sqrt(static_cast<double>(n));
  }

  [[nodiscard]] std::unique_ptr<LineTransform>
  clone() const override
  {
    return std::make_unique<FastCosineTransform>(*this);
  }

protected:
  void
  forward(Complex * line, Eigen::Index step) override
  {
    const std::size_t n = m_Length;
    for (std::size_t i = 0; i < n; ++i)
    {
      m_In[i] = line[static_cast<Eigen::Index>(reordered(i)) * step];
    }
    m_Fourier.transform(m_In.data(), m_Out.data());
    line[0] = m_ScaleOfConstant * m_Out[0];
    for (std::size_t k = 1; 2 * k <= n; ++k)
    {
      // V + conj(V') and (V - conj(V')) / i: twice the spectra of the two lines
      const Complex a = m_Out[k];
      const Complex b = m_Out[n - k];
      const double  firstRe = a.real() + b.real();
      const double  firstIm = a.imag() - b.imag();
      const double  secondRe = a.imag() + b.imag();
      const double  secondIm = b.real() - a.real();
      const double  c = m_Rotation[k].real();
      const double  s = m_Rotation[k].imag();
      line[static_cast<Eigen::Index>(k) * step] = { c * firstRe + s * firstIm, c * secondRe + s * secondIm };
      line[static_cast<Eigen::Index>(n - k) * step] = { s * firstRe - c * firstIm, s * secondRe - c * secondIm };
    }
  }

  void
  inverse(Complex * line, Eigen::Index step) override
  {
    const std::size_t n = m_Length;
    m_In[0] = m_ScaleOfConstant * line[0];
    for (std::size_t k = 1; 2 * k <= n; ++k)
    {
      const Complex a = line[static_cast<Eigen::Index>(k) * step];
      const Complex b = line[static_cast<Eigen::Index>(n - k) * step];
      const double  c = m_Rotation[k].real();
      const double  s = m_Rotation[k].imag();
      const double  firstRe = c * a.real() + s * b.real();
      const double  firstIm = s * a.real() - c * b.real();
      const double  secondRe = c * a.imag() + s * b.imag();
      const double  secondIm = s * a.imag() - c * b.imag();
      m_In[k] = { firstRe - secondIm, firstIm + secondRe };
      m_In[n - k] = { firstRe + secondIm, secondRe - firstIm };
    }
    m_FourierInverse.transform(m_In.data(), m_Out.data());
    for (std::size_t i = 0; i < n; ++i)
    {
      line[static_cast<Eigen::Index>(reordered(i)) * step] = m_Out[i];
    }
  }

private:
  [[nodiscard]] std::size_t
  reordered(std::size_t i) const
  {
    return 2 * i < m_Length ? 2 * i : 2 * (m_Length - i) - 1;
  }

  kissfft<double>      m_FourierInverse;
  std::vector<Complex> m_Rotation; // exp(i pi k / 2n) / sqrt(2n)
  double               m_ScaleOfConstant;
};

/** DST-I of n = N - 1 values by one Fourier transform of length N: with x_0 = 0 and
 *
 *   y_j = sin(pi j / N) (x_j + x_{N-j}) + (x_j - x_{N-j}) / 2,   F_k = sum x_j sin(pi j k / N)
 *   -Im Y_k = F_{2k},   Re Y_k = F_{2k+1} - F_{2k-1},   Re Y_0 = 2 F_1                          [Numerical Recipes] */
class FastSineTransform : public FastLineTransform
{
public:
  explicit FastSineTransform(std::size_t n) : FastLineTransform(n + 1), m_Sines(n + 1)
  {
    const double length = static_cast<double>(m_Length);
    m_Scale = std::sqrt(2.0 / length);
    for (std::size_t j = 0; j <= n; ++j)
    {
      m_Sines[j] = m_Scale * std::sin(pi * static_cast<double>(j) / length);
    }
  }

  [[nodiscard]] std::unique_ptr<LineTransform>
  clone() const override
  {
    return std::make_unique<FastSineTransform>(*this);
  }

protected:
  void
  forward(Complex * line, Eigen::Index step) override
  {
    const std::size_t N = m_Length;
    const auto        value = [&](std::size_t j) -> Complex & { return line[static_cast<Eigen::Index>(j - 1) * step]; };
    m_In[0] = 0.0;
    for (std::size_t j = 1; 2 * j <= N; ++j)
    {
      const Complex even = m_Sines[j] * (value(j) + value(N - j));
      const Complex odd = 0.5 * m_Scale * (value(j) - value(N - j));
      m_In[j] = even + odd;
      m_In[N - j] = even - odd;
    }
    m_Fourier.transform(m_In.data(), m_Out.data());
    Complex sum = 0.5 * m_Out[0];
    if (N > 1)
    {
      value(1) = sum;
    }
    for (std::size_t k = 1; 2 * k < N; ++k)
    {
      const Complex a = m_Out[k];
      const Complex b = m_Out[N - k];
      value(2 * k) = { 0.5 * (b.imag() - a.imag()), 0.5 * (a.real() - b.real()) };
      sum += 0.5 * (a + b);
      if (2 * k + 1 < N)
      {
        value(2 * k + 1) = sum;
      }
    }
  }

  void
  inverse(Complex * line, Eigen::Index step) override
  {
    forward(line, step);
  }

private:
  double              m_Scale;
  std::vector<double> m_Sines; // sqrt(2/N) sin(pi j / N)
};
} // namespace

std::unique_ptr<LineTransform>
makeFastLineTransform(int n, CubeTransform::Basis basis)
{
  if (basis == CubeTransform::Basis::Cosine)
  {
    return std::make_unique<FastCosineTransform>(static_cast<std::size_t>(n));
  }
  return std::make_unique<FastSineTransform>(static_cast<std::size_t>(n));
}

bool
fastLineTransformPays(int n, CubeTransform::Basis basis)
{
  // Time a value there and back, measured in one run with the kernels for AVX-512: dense 20 + 0.4 n ns; fast 140 ns,
  // and about 14 p ns more for each prime factor p that kissfft has no butterfly for. AVX2 makes the dense one slower
  // by half.
  constexpr int shortest = 240;
  constexpr int perPrime = 35;
  const int     length = basis == CubeTransform::Basis::Cosine ? n : n + 1;
  int           required = shortest;
  int           rest = length;
  for (int p = 2; p <= rest; ++p)
  {
    for (; rest % p == 0; rest /= p)
    {
      required += p > 5 ? perPrime * p : 0;
    }
  }
  return length >= required;
}

} // namespace moserhex
