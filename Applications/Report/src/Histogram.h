#pragma once

#include "CellField.h"

#include <string>

namespace moserhex::app
{

/** A histogram as an <svg> with a title, an axis with numbers, and the acceptable range shaded and named; bars outside
 * of it are hatched. Forty classes over rangeOf(field).
 * \param field  of at least one cell */
[[nodiscard]] std::string
histogramSvg(const CellField & field);

/** Smallest, 5 %, median, mean, 95 % and largest value and the part that is acceptable, as the rows of a <dl>. */
[[nodiscard]] std::string
distributionList(const CellField & field);

} // namespace moserhex::app
