#pragma once

#include "AtlasRun.h"
#include "CellField.h"

#include <vector>

namespace moserhex::app
{

/** What is known of the cells of the mean mesh, for colours: quality and shell; the mean over a cell's nodes of the
 * subjects' standard deviation; mean and standard deviation of the images in the middle of the cell (first component);
 * of every test at the nodes how far they moved and the effect size (means over the cell's nodes), and the smallest
 * family-wise p of its nodes; of tests of the images the cell's own change, effect size and family-wise p. */
[[nodiscard]] std::vector<CellField>
atlasCellFields(const AtlasResult & result);

} // namespace moserhex::app
