#pragma once

#include "LineTransform.h"

namespace moserhex
{

/** Lines of one field: line l begins at (l % inner) + (l / inner) * outerStep and goes on in steps of `step`. */
struct LineSet
{
  Eigen::Index count;
  Eigen::Index step;
  Eigen::Index inner;
  Eigen::Index outerStep;

  [[nodiscard]] Eigen::Index
  start(Eigen::Index line) const
  {
    return line % inner + line / inner * outerStep;
  }

  /** Neighbouring lines begin at neighbouring values. */
  [[nodiscard]] bool
  liesSideBySide() const
  {
    return inner >= count;
  }

  /** A line's values are neighbours, and lines begin in equal steps. */
  [[nodiscard]] bool
  isContiguous() const
  {
    return step == 1 && inner == 1;
  }
};

/** Copies `count` lines from line `first` on into a panel, whose other rows become zero. */
void
loadLines(LinePanel & panel, const double * values, const LineSet & lines, Eigen::Index first, Eigen::Index count);

/** Copies `count` lines of a panel back. */
void
storeLines(const LinePanel & panel, double * values, const LineSet & lines, Eigen::Index first, Eigen::Index count);

} // namespace moserhex
