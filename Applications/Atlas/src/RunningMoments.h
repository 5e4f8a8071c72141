#pragma once

#include <cstddef>
#include <vector>

namespace moserhex::app
{

/** Mean and standard deviation of many lists of equal length, one after the other, in the memory of two
 * [welford1962]:
 *
 *   m_k = m_(k-1) + (x_k - m_(k-1)) / k,    s_k = s_(k-1) + (x_k - m_(k-1)) (x_k - m_k) */
class RunningMoments
{
public:
  /** \throws InvalidInput  another length than the first list's */
  void
  add(const std::vector<double> & values);

  [[nodiscard]] std::size_t
  count() const
  {
    return m_Count;
  }

  [[nodiscard]] const std::vector<double> &
  mean() const
  {
    return m_Mean;
  }

  /** sqrt(s / (count - 1)). \pre count() >= 2 */
  [[nodiscard]] std::vector<double>
  standardDeviation() const;

private:
  std::size_t         m_Count{ 0 };
  std::vector<double> m_Mean;
  std::vector<double> m_Squares;
};

} // namespace moserhex::app
