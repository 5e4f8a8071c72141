#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace moserhex
{

/** What the repair of an equalised mesh works at: below these nothing is left to repair. Lengths in edges of a cell. */
struct FlawLimits
{
  double distance;
  double uncovered;
  double scaledJacobian;
};

/** What keeps a mesh of equal cells from being exact, and what it is repaired for besides. Lengths in edges of a cell.
 */
struct EqualisationFlaws
{
  std::size_t uncertified{ 0 };      ///< cells
  double      distance{ 0.0 };       ///< largest, of the boundary to the surface
  double      uncovered{ 0.0 };      ///< largest, of the surface to the boundary
  double      scaledJacobian{ 1.0 }; ///< smallest
  bool        unequal{ false };      ///< a projection did not make the cells equal

  [[nodiscard]] bool
  none(const FlawLimits & limits) const
  {
    return !unequal && uncertified == 0 && distance <= limits.distance && uncovered <= limits.uncovered &&
           scaledJacobian >= limits.scaledJacobian;
  }

  /** What is better than its limit does not count. */
  [[nodiscard]] bool
  fewerThan(const EqualisationFlaws & other, const FlawLimits & limits) const
  {
    return inOrderOfWeight(limits) < other.inOrderOfWeight(limits);
  }

  /** A round was worth its work: a fifth fewer uncertified cells, or no more of them and a length that mattered better
   * by 3 % or the scaled Jacobian by a quarter, which wavers by less where there is nothing to gain. */
  [[nodiscard]] bool
  worthwhileAfter(const EqualisationFlaws & other, const FlawLimits & limits) const
  {
    constexpr double fewer = 0.8;
    constexpr double nearer = 0.97;
    constexpr double narrower = 0.8;
    return static_cast<double>(uncertified) < fewer * static_cast<double>(other.uncertified) ||
           (uncertified <= other.uncertified && (isWorthwhile(distance, other.distance, limits.distance, nearer) ||
                                                 isWorthwhile(uncovered, other.uncovered, limits.uncovered, nearer) ||
                                                 (other.scaledJacobian < limits.scaledJacobian &&
                                                  narrower * scaledJacobian > std::max(0.0, other.scaledJacobian))));
  }

private:
  static bool
  isWorthwhile(double length, double before, double limit, double factor)
  {
    return before > limit && length < factor * before;
  }

  [[nodiscard]] std::tuple<bool, std::size_t, double, double, double>
  inOrderOfWeight(const FlawLimits & limits) const
  {
    return { unequal,
             uncertified,
             std::max(distance, limits.distance),
             std::max(uncovered, limits.uncovered),
             -std::min(scaledJacobian, limits.scaledJacobian) };
  }
};

} // namespace moserhex
