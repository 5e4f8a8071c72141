#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** One number of every cell, as a page shows it. All are without unit. */
struct CellField
{
  struct Range
  {
    double low{ 0.0 };
    double high{ 0.0 };
  };

  std::string          id; ///< a word for identifiers
  std::string          name;
  std::string          meaning;          ///< what is good and what is bad, for people
  std::vector<double>  values;           ///< one per cell
  std::optional<Range> acceptable;       ///< CUBIT's range; empty: it has none
  Range                shown;            ///< of the histogram and the colours, at least; they are widened to the values
  bool                 isWhole{ false }; ///< whole numbers: no histogram
};

/** Volume ratio, scaled Jacobian, aspect ratio and taper (Verdict's definitions, see moserhex::HexCellQuality), shell,
 * and the label where there are labels.
 * \param labels  one per cell, or empty */
[[nodiscard]] std::vector<CellField>
cellFieldsOf(const HexMesh & mesh, const std::vector<std::int32_t> & labels);

/** The shown range widened to the values; where these are the same but for rounding, by 5 % of them, or 0 to 1 where
 * they are 0: it is never empty. */
[[nodiscard]] CellField::Range
rangeOf(const CellField & field);

/** Part of the cells whose value is acceptable, in [0,1]; 1 where CUBIT has no range. */
[[nodiscard]] double
acceptablePart(const CellField & field);

} // namespace moserhex::app
