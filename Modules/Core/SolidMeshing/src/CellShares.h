#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <vector>

namespace moserhex
{

/** Volume of every cell over the mean of all [1]. */
[[nodiscard]] std::vector<double>
cellShares(const HexMesh & mesh);

/** Shares of the organ for every cell, and what was done to get them. */
struct GrownShares
{
  std::vector<double> shares;       ///< of mean 1
  std::size_t         limited{ 0 }; ///< cells that would have grown or shrunk more than what is allowed
};

/** The shares that a lattice shows whose cells were hardly held to their volumes. Growth, the ratio of its shares to
 * those before, is kept within what is allowed, a factor of 8 either way; so are cells that are flat or inverted.
 * \param loosened  as many cells as `before` \param before  shares of the template's cells, > 0 [1] */
[[nodiscard]] GrownShares
grownShares(const HexMesh & loosened, const std::vector<double> & before);

/** Smallest and largest ratio of shares. \return with no cells limited */
[[nodiscard]] LocalGrowth
growthBetween(const std::vector<double> & before, const std::vector<double> & after);

/** Half-way and so on: before^(1 - part) x after^part, of mean 1. \param part  in [0,1] */
[[nodiscard]] std::vector<double>
partlyGrown(const std::vector<double> & before, const std::vector<double> & after, double part);

} // namespace moserhex
