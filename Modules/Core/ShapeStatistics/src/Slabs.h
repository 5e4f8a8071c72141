#pragma once

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/ShapeStatistics/SubjectTable.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace moserhex
{

/** Slabs in memory together. */
inline constexpr std::size_t slabsAtOnce = 4;

/** Columns of a slab of so many bytes: a multiple of 3, at least 3. Depends on the table's size only. */
[[nodiscard]] inline std::size_t
slabColumns(const SubjectTable & table, std::size_t bytes)
{
  return 3 * std::max<std::size_t>(1, bytes / (3 * sizeof(double) * std::max<std::size_t>(1, table.subjects())));
}

/** The slab less the mean of each column, which is returned in `mean`.
 * \throws InvalidInput  a value is not finite (names subject and column) */
[[nodiscard]] inline Eigen::MatrixXd
centredSlab(const SubjectTable & table, std::size_t first, std::size_t count, Eigen::RowVectorXd & mean)
{
  Eigen::MatrixXd slab = table.read(first, count);
  if (!slab.allFinite())
  {
    for (Eigen::Index column = 0; column < slab.cols(); ++column)
    {
      for (Eigen::Index row = 0; row < slab.rows(); ++row)
      {
        if (!std::isfinite(slab(row, column)))
        {
          throw InvalidInput("statistics: subject " + std::to_string(row) + ", number " +
                             std::to_string(first + static_cast<std::size_t>(column)) + " is not finite");
        }
      }
    }
  }
  mean = slab.colwise().mean();
  slab.rowwise() -= mean;
  return slab;
}

/** Calls work(slot, first column, number of columns) for every slab, in parallel; then done(slot), in order.
 * slot < slabsAtOnce: slabsAtOnce slabs at a time, for any number of threads. */
template <typename TWork, typename TDone>
void
forEachSlab(const SubjectTable & table, std::size_t width, unsigned int threads, const TWork & work, const TDone & done)
{
  const std::size_t slabs = (table.columns() + width - 1) / width;
  for (std::size_t begin = 0; begin < slabs; begin += slabsAtOnce)
  {
    const std::size_t size = std::min(slabsAtOnce, slabs - begin);
    parallelFor(size, threads, [&](std::size_t slot) {
      const std::size_t first = (begin + slot) * width;
      work(slot, first, std::min(width, table.columns() - first));
    });
    for (std::size_t slot = 0; slot < size; ++slot)
    {
      done(slot);
    }
  }
}

} // namespace moserhex
