#pragma once

#include "TextTable.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Whether a cell says that there is no value: empty, or n/a, na, nan, null or a point, in small letters or capitals.
 */
[[nodiscard]] bool
isMissing(const std::string & cell);

/** The number in a cell, with a sign of either kind; nothing where it is no number, or not finite. */
[[nodiscard]] std::optional<double>
numberOf(const std::string & cell);

/** The column's number; as many as there are columns where there is none of that name. */
[[nodiscard]] std::size_t
columnNumber(const TextTable & table, const std::string & column);

enum class CellKind
{
  Numbers, ///< or no value at all
  Words
};

/** What a column's cells are, missing ones apart.
 * \param number  of the column \throws BadInput  numbers and words: names the line and the word */
[[nodiscard]] CellKind
kindOfColumn(const TextTable & table, std::size_t number);

/** The numbers of a column; nothing where a cell is missing.
 * \throws BadInput  a cell that is no number: names the line and the cell */
[[nodiscard]] std::vector<std::optional<double>>
numbersIn(const TextTable & table, std::size_t number);

/** \throws BadInput  a word begins like a number, with a digit, a sign or a point: names the line and the cell */
void
requirePlainWords(const TextTable & table, std::size_t number);

} // namespace moserhex::app
