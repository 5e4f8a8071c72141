#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** A table in a text file. */
struct TextTable
{
  struct Row
  {
    std::size_t              line{ 0 };   ///< of the file, from 1
    std::vector<std::string> cells;       ///< as many as there are columns
    std::size_t              number{ 0 }; ///< from 1 after the column names; rows that do not count have one, too
  };

  std::vector<std::string> columns;
  std::vector<Row>         rows;
};

/** Reads a table with a first line of column names: .csv by RFC 4180, separated by commas, or by semicolons where the
 * first line has those and no comma; .tsv separated by tabs. UTF-8 with or without a byte order mark; lines end in LF
 * or CRLF; lines of blanks and empty cells alone do not count; blanks around a cell are cut, those within its quotes
 * are not; a quote that does not begin a cell is a character like others.
 * \throws BadInput  missing; no column names or the same one twice; a row with other than so many cells, a quote that
 * is not closed, a carriage return in a line or a zero byte, with the number of the line
 * \throws IOError   the file cannot be read */
[[nodiscard]] TextTable
readTextTable(const std::string & fileName);

/** Reads a text with one cell a line, as a table of one column: blanks around it are cut, blank lines do not count, and
 * no character means anything. Encoding and ends of lines as above.
 * \throws BadInput, IOError  as above */
[[nodiscard]] TextTable
readTextLines(const std::string & fileName, const std::string & column);

/** Whether a name ends with .csv or .tsv, in any case. */
[[nodiscard]] bool
isTableName(const std::string & fileName);

/** The cells of one line of a table, apart from its end.
 * \param number  of the line, in messages \throws BadInput  as readTextTable */
[[nodiscard]] std::vector<std::string>
cellsOfLine(const std::string & fileName, std::size_t number, const std::string & line, char separator);

/** One line of a table, with its end. Cells are quoted where they must be; where a spreadsheet would take a cell for a
 * formula (it begins with = + - @, a tab or a carriage return, and is not a number), an apostrophe is put before it.
 * \param separator  ',' or '\t' */
[[nodiscard]] std::string
tableLine(const std::vector<std::string> & cells, char separator);

/** The same with every cell as it is, of files that are read back: cells like "-" and "+L1" stay what they were. */
[[nodiscard]] std::string
exactLine(const std::vector<std::string> & cells, char separator);

/** The text without spaces and tabs before and behind it. */
[[nodiscard]] std::string
withoutBlanksAround(const std::string & text);

/** A number in a cell: the shortest that is read back as the same number, in the C locale; whole numbers without an
 * exponent; empty when not finite. */
[[nodiscard]] std::string
numberText(double value);

} // namespace moserhex::app
