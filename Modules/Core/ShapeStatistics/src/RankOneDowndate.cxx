#include "RankOneDowndate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

constexpr double smallestPart = 1e-14;   ///< of |y|
constexpr double smallestGap = 1e-14;    ///< of the largest d: nearer ones are the same
constexpr double smallestMode = 1e-10;   ///< of the largest d, as for fitShapeModel: below it is rounding
constexpr int    maximumBisections = 80; ///< of the logarithm-like search; doubles have 53 bits

struct Pole
{
  double d;
  double squaredPart; ///< y^2
};

/** The poles of the secular equation, equal ones together, and the eigenvalues that stay as they are. */
std::vector<Pole>
polesOf(const Eigen::VectorXd & d, const Eigen::VectorXd & y, std::vector<DowndatedMode> & untouched)
{
  const double      gap = smallestGap * d[0];
  const double      part = smallestPart * y.norm();
  std::vector<Pole> poles;
  for (Eigen::Index j = 0; j < d.size(); ++j)
  {
    if (!(std::abs(y[j]) > part))
    {
      untouched.push_back({ d[j], 0.0 });
    }
    else if (!poles.empty() && poles.back().d - d[j] <= gap)
    {
      poles.back().squaredPart += y[j] * y[j];
      untouched.push_back({ d[j], 0.0 });
    }
    else
    {
      poles.push_back({ d[j], y[j] * y[j] });
    }
  }
  return poles;
}

/** sum_j y_j^2 / (d_j - mu)^power with mu = origin + offset: the differences lose no digits near the origin. */
double
secularSum(const std::vector<Pole> & poles, double origin, double offset, int power)
{
  double sum = 0.0;
  for (const Pole & pole : poles)
  {
    const double distance = (pole.d - origin) - offset;
    sum += pole.squaredPart / (power == 1 ? distance : distance * distance);
  }
  return sum;
}

/** The root between `lower` and pole k. The sum grows with mu, from -infinity to infinity. */
DowndatedMode
rootBelow(const std::vector<Pole> & poles, std::size_t k, double lower, double rho)
{
  const double upper = poles[k].d;
  const double half = 0.5 * (upper - lower);
  const bool   isUpperHalf = rho * secularSum(poles, lower, half, 1) < 1.0;
  const double origin = isUpperHalf ? upper : lower;
  const double direction = isUpperHalf ? -1.0 : 1.0;
  double       inner = 0.0; // distances from the origin
  double       outer = half;
  for (int step = 0; step < maximumBisections; ++step)
  {
    const double middle = 0.5 * (inner + outer);
    const bool   isBelowRoot = rho * secularSum(poles, origin, direction * middle, 1) < 1.0;
    (isBelowRoot == isUpperHalf ? outer : inner) = middle;
    if (outer - inner <= 4.0 * std::numeric_limits<double>::epsilon() * outer)
    {
      break;
    }
  }
  const double offset = direction * 0.5 * (inner + outer);
  return { origin + offset, 1.0 / secularSum(poles, origin, offset, 2) };
}

} // namespace

std::vector<DowndatedMode>
downdatedModes(const Eigen::VectorXd & d, const Eigen::VectorXd & y, double rho, std::size_t count)
{
  std::vector<DowndatedMode> modes;
  const std::vector<Pole>    poles = polesOf(d, y, modes);
  for (std::size_t k = 0; k < std::min(count, poles.size()); ++k)
  {
    const bool   isLast = k + 1 == poles.size();
    const double lower = isLast ? poles[k].d - 2.0 * rho * y.squaredNorm() : poles[k + 1].d;
    modes.push_back(rootBelow(poles, k, lower, rho));
    if (modes.back().eigenvalue <= smallestMode * d[0])
    {
      modes.back().explained = 0.0; // a direction in which y alone lies: there is no such mode
    }
  }
  std::stable_sort(modes.begin(), modes.end(), [](const DowndatedMode & a, const DowndatedMode & b) {
    return a.eigenvalue > b.eigenvalue;
  });
  modes.resize(std::min(count, modes.size()));
  return modes;
}

} // namespace moserhex
