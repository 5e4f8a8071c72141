#pragma once

#include "moserhex/Common/Types.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct ListedPoint
{
  std::string              name;        ///< as messages call it: its label, or "line 7"
  std::string              label;       ///< empty: none
  std::string              description; ///< empty: none
  std::optional<Vector3>   position;    ///< LPS [mm]
  std::optional<Vector3>   cube;        ///< c in [0,1]^3; only tables have it
  std::vector<std::string> others;      ///< as many as there are other columns
  std::size_t              row{ 0 };    ///< of the list, from 1; blank rows of a table, which are no points, count
};

/** Points of a file, with the columns of a table that are not theirs. */
struct PointList
{
  std::vector<std::string> otherColumns;
  std::vector<ListedPoint> points;
  std::vector<std::string> warnings{}; ///< of reading, one line each
};

/** Whether the name ends like a list of points: .fcsv .mrk.json .csv .tsv (any case). */
[[nodiscard]] bool
isPointFileName(const std::string & fileName);

/** Reads
 *
 * - .fcsv: Slicer's fiducials. "# CoordinateSystem" is LPS, RAS, or a number as Slicer wrote it (0 RAS, 1 LPS); without
 *   it the points are RAS, with a warning. Columns as its header names them; of the cells that Slicer writes behind
 * them since version 5 the first is the status of the position, 2 where it is defined.
 * - .mrk.json: Slicer's markups, the control points of all of them; coordinateSystem LPS (also without it) or RAS.
 * - .csv, .tsv: a table with columns x, y, z (LPS mm), c1, c2, c3 (cube coordinates), or both; label and description if
 *   there are any; other columns are kept.
 *
 * A point without a position (empty cells; positionStatus other than "defined") is kept as one.
 * \throws BadInput  missing or damaged file, other columns, other units than mm, another coordinate system, a
 * coordinate that is no finite number; IOError */
[[nodiscard]] PointList
readPoints(const std::string & fileName);

/** Writes one of these formats, complete or not at all: LPS, numbers that come back the same. Tables have the columns
 * label, description, the others, x, y, z, and c1, c2, c3 where any point has them; what a point has not is empty. In
 * .mrk.json a point without a position is "undefined"; .fcsv has no such points, they are left out. Other columns are
 * only in tables. Texts are written as they are, also those that a spreadsheet takes for formulas.
 * \throws BadInput (Usage)  another ending; IOError */
void
writePoints(const std::string & fileName, const PointList & list);

} // namespace moserhex::app
