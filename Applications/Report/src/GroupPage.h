#pragma once

#include "CellField.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** A number that every case of a group has, or has not. */
struct PageColumn
{
  std::string id;   ///< a word for identifiers
  std::string name; ///< with its unit
  bool        hasHistogram{ false };
  bool        hasOutliers{ false }; ///< whether a case that is far from the others is worth a look
};

struct PageRow
{
  std::string         name;
  std::string         status;  ///< "done", "failed", "missing"
  std::string         code;    ///< of a failure
  std::string         message; ///< of a failure, or why a report does not count
  std::vector<double> figures; ///< one a column; NaN: not known
  std::string         page;    ///< file of its own page, relative to the group's; empty: none
  std::string         outline; ///< see silhouette(); empty: not known
};

struct GroupContent
{
  std::string              heading;
  std::string              subtitle;
  std::string              caseName; ///< what a row is: "case", "subject"
  std::vector<PageColumn>  columns;
  std::vector<PageRow>     rows;
  std::vector<std::string> warnings;
  std::string              introduction;    ///< HTML between the counts and the table; may be empty
  std::string              conclusion;      ///< HTML at the end; may be empty
  const HexMesh *          mesh{ nullptr }; ///< to be shown in 3-D: the mean; null: none
  std::vector<CellField>   fields;          ///< of that mesh
  std::string              version;         ///< of MoserHex
};

/** Cases whose number in a column is far from the others': |x - median| > 3.5 * 1.4826 * MAD over the rows that are
 * done (MAD: median absolute deviation, 1.4826 makes it a standard deviation where values are normal; Iglewicz and
 * Hoaglin 1993). None among fewer than six, and none where more than half of the values are the same.
 * \return for every row +1 above, -1 below, 0 */
[[nodiscard]] std::vector<int>
outliersOf(const GroupContent & content, std::size_t column);

/** One HTML document that needs no other file, but for links to the pages of cases: counts, what to look at first,
 * histograms, a table that can be sorted and filtered. The same content gives the same bytes.
 * \throws InvalidInput (Usage)  a program without pages */
[[nodiscard]] std::string
groupPage(const GroupContent & content);

/** Writes it, complete or not at all. \throws IOError; InvalidInput (Usage) */
void
writeGroupPage(const std::string & fileName, const GroupContent & content);

} // namespace moserhex::app
