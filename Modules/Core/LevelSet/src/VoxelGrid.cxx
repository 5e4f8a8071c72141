#include "moserhex/LevelSet/VoxelGrid.h"

#include "moserhex/Common/Errors.h"

#include <cmath>

namespace moserhex
{

void
requireValid(const VoxelGrid & grid, const std::string & what)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double spacing = grid.spacing[static_cast<int>(axis)];
    if (grid.size[axis] < 1 || !(spacing > 0.0) || !std::isfinite(spacing))
    {
      throw InvalidInput(what + ": " + std::to_string(grid.size[axis]) + " voxels of " + std::to_string(spacing) +
                         " mm along axis " + std::to_string(axis) + ", need at least 1 of a positive size");
    }
  }
  const double error = (grid.direction.transpose() * grid.direction - Matrix3::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= 1e-6))
  {
    throw InvalidInput(what + ": image direction is not orthonormal (error " + std::to_string(error) +
                       ", allowed 1e-6)");
  }
  if (!grid.origin.allFinite())
  {
    throw InvalidInput(what + ": image origin is not finite");
  }
}

} // namespace moserhex
