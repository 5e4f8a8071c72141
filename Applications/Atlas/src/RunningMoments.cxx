#include "RunningMoments.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace moserhex::app
{

void
RunningMoments::add(const std::vector<double> & values)
{
  if (m_Count == 0)
  {
    m_Mean.assign(values.size(), 0.0);
    m_Squares.assign(values.size(), 0.0);
  }
  if (values.size() != m_Mean.size())
  {
    throw InvalidInput("moments: " + std::to_string(values.size()) + " numbers, those before " +
                       std::to_string(m_Mean.size()));
  }
  ++m_Count;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double toOldMean = values[i] - m_Mean[i];
    m_Mean[i] += toOldMean / static_cast<double>(m_Count);
    m_Squares[i] += toOldMean * (values[i] - m_Mean[i]);
  }
}

std::vector<double>
RunningMoments::standardDeviation() const
{
  std::vector<double> result(m_Squares.size());
  const double        divisor = static_cast<double>(m_Count) - 1.0;
  std::transform(m_Squares.begin(), m_Squares.end(), result.begin(), [divisor](double squares) {
    return std::sqrt(squares / divisor);
  });
  return result;
}

} // namespace moserhex::app
