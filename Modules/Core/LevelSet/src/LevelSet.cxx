#include "moserhex/LevelSet/LevelSet.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <limits>

namespace moserhex
{

void
requireValid(const LevelSet & levelSet, const std::string & what)
{
  requireValid(levelSet.grid, what);
  if (levelSet.values.size() != levelSet.grid.nodeCount())
  {
    throw InvalidInput(what + ": " + std::to_string(levelSet.values.size()) + " values for " +
                       std::to_string(levelSet.grid.nodeCount()) + " nodes");
  }
  for (std::size_t node = 0; node < levelSet.values.size(); ++node)
  {
    if (!(levelSet.values[node] > -std::numeric_limits<double>::infinity()))
    {
      throw InvalidInput(what + ": value of node " + std::to_string(node) + " is NaN or -infinity");
    }
  }
}

} // namespace moserhex
