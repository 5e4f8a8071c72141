#include "FieldLines.h"

#include "PanelKernels.h"

#include <algorithm>

namespace moserhex
{

void
loadLines(LinePanel & panel, const double * values, const LineSet & lines, Eigen::Index first, Eigen::Index count)
{
  panel.bottomRows(panel.rows() - count).setZero();
  const double * const start = values + lines.start(first);
  if (lines.liesSideBySide())
  {
    for (Eigen::Index i = 0; i < panel.cols(); ++i)
    {
      std::copy_n(start + i * lines.step, count, panel.data() + i * panel.rows());
    }
    return;
  }
  if (lines.isContiguous())
  {
    transposeLines(start,
                   static_cast<std::size_t>(lines.outerStep),
                   static_cast<std::size_t>(count),
                   static_cast<std::size_t>(panel.cols()),
                   panel.data(),
                   static_cast<std::size_t>(panel.rows()));
    return;
  }
  for (Eigen::Index lane = 0; lane < count; ++lane)
  {
    const double * const line = values + lines.start(first + lane);
    for (Eigen::Index i = 0; i < panel.cols(); ++i)
    {
      panel(lane, i) = line[i * lines.step];
    }
  }
}

void
storeLines(const LinePanel & panel, double * values, const LineSet & lines, Eigen::Index first, Eigen::Index count)
{
  double * const start = values + lines.start(first);
  if (lines.liesSideBySide())
  {
    for (Eigen::Index i = 0; i < panel.cols(); ++i)
    {
      std::copy_n(panel.data() + i * panel.rows(), count, start + i * lines.step);
    }
    return;
  }
  if (lines.isContiguous())
  {
    transposeLines(panel.data(),
                   static_cast<std::size_t>(panel.rows()),
                   static_cast<std::size_t>(panel.cols()),
                   static_cast<std::size_t>(count),
                   start,
                   static_cast<std::size_t>(lines.outerStep));
    return;
  }
  for (Eigen::Index lane = 0; lane < count; ++lane)
  {
    double * const line = values + lines.start(first + lane);
    for (Eigen::Index i = 0; i < panel.cols(); ++i)
    {
      line[i * lines.step] = panel(lane, i);
    }
  }
}

} // namespace moserhex
