#pragma once

#include "AtlasRun.h"
#include "CellField.h"

#include <vector>

namespace moserhex::app
{

/** What is known of the cells of the mean mesh, for colours: quality and shell; the mean over a cell's nodes of the
 * subjects' standard deviation; mean and standard deviation of the images in the middle of the cell (first component);
 * of every test how far the nodes moved and the effect size (means over the cell's nodes), and the smallest family-wise
 * p of its nodes. */
[[nodiscard]] std::vector<CellField>
atlasCellFields(const AtlasResult & result);

} // namespace moserhex::app
