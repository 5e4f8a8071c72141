#include "moserhex/LevelSet/RegularGrid.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <limits>

namespace moserhex
{

void
requireValid(const RegularGrid & grid, const std::string & what)
{
  std::size_t nodes = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = grid.size[static_cast<std::size_t>(axis)];
    if (size < 4)
    {
      throw InvalidInput(what + ": " + std::to_string(size) + " nodes along axis " + std::to_string(axis) +
                         ", need at least 4");
    }
    nodes *= static_cast<std::size_t>(size);
    if (nodes > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    {
      throw InvalidInput(what + ": more than 2^31 nodes; use a larger spacing");
    }
  }
  if (!(grid.spacing > 0.0) || !std::isfinite(grid.spacing))
  {
    throw InvalidInput(what + ": spacing " + std::to_string(grid.spacing) + " mm, need > 0");
  }
  const double error = (grid.direction.transpose() * grid.direction - Matrix3::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= 1e-6))
  {
    throw InvalidInput(what + ": direction is not orthonormal (error " + std::to_string(error) + ", allowed 1e-6)");
  }
  if (!grid.origin.allFinite())
  {
    throw InvalidInput(what + ": origin is not finite");
  }
}

} // namespace moserhex
