#pragma once

#include <string>

namespace moserhex
{

/** VTK's legacy readers trust the counts of POINTS, POLYGONS, CELLS and the like, and those within the list of cells,
 * and read beyond their memory when they lie.
 * \throws BadInput  a count is larger than the file or its list, or the list longer than its cells */
void
requireHonestCounts(const std::string & fileName);

} // namespace moserhex
