#pragma once

#include "moserhex/Common/Parallel.h"
#include "moserhex/HexMap/CellMeasure.h"

namespace moserhex
{

/** Derivative of a cell's measure, one corner a column. */
using CornerGradient = Eigen::Matrix<double, 3, 8>;

/** Calls measure(corners, gradient) -> double for every cell, in parallel over blocks of cells, and stores the results.
 * gradient is null when `gradients` is; else measure sets it. */
template <typename TMeasure>
void
evaluateCells(const HexMesh &       mesh,
              std::size_t           cellsPerBlock,
              unsigned int          threads,
              std::vector<double> & measures,
              CellGradients *       gradients,
              const TMeasure &      measure)
{
  const std::size_t cells = mesh.cellCount();
  measures.resize(cells);
  if (gradients != nullptr)
  {
    gradients->resize(24, static_cast<Eigen::Index>(cells));
  }
  parallelForBlocks(cells, cellsPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    CornerGradient gradient;
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      measures[cell] = measure(cellCorners(mesh, cell), gradients != nullptr ? &gradient : nullptr);
      if (gradients != nullptr)
      {
        gradients->col(static_cast<Eigen::Index>(cell)) =
          Eigen::Map<const Eigen::Matrix<double, 24, 1>>(gradient.data());
      }
    }
  });
}

} // namespace moserhex
