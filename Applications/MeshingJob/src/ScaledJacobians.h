#pragma once

#include "moserhex/Quality/HexQuality.h"

#include <vector>

namespace moserhex::app
{

/** Verdict's scaled Jacobian of every cell [1]. */
[[nodiscard]] inline std::vector<double>
scaledJacobiansOf(const HexMesh & mesh)
{
  std::vector<double> values;
  values.reserve(mesh.cellCount());
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    values.push_back(hexCellQuality(cellCorners(mesh, cell)).scaledJacobian);
  }
  return values;
}

} // namespace moserhex::app
