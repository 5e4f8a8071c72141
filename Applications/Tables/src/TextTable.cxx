#include "TextTable.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

namespace moserhex::app
{
namespace
{

const std::string blanks = " \t";

[[noreturn]] void
refuse(const std::string & fileName, std::size_t line, const std::string & cause, const std::string & remedy)
{
  throw BadInput(ErrorCode::Format, fileName, "line " + std::to_string(line) + ": " + cause, remedy);
}

[[nodiscard]] std::size_t
lineOf(const std::string & text, std::size_t position)
{
  return 1 +
         static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

/** All of a file in UTF-8, without its byte order mark. */
[[nodiscard]] std::string
textOf(const std::string & fileName)
{
  std::error_code unknown;
  if (!std::filesystem::exists(fileName, unknown) || std::filesystem::is_directory(fileName, unknown))
  {
    throw BadInput(ErrorCode::NoInput, fileName, "there is no such file", "check the name");
  }
  errno = 0;
  std::ifstream file(fileName, std::ios::binary);
  if (!file.is_open())
  {
    throwUnopened(fileName, errno);
  }
  std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (file.bad())
  {
    throw IOError(ErrorCode::InputOutput, fileName, "reading failed", "check the disk");
  }
  if (const std::size_t zero = text.find('\0'); zero != std::string::npos)
  {
    refuse(fileName, lineOf(text, zero), "a zero byte", "save it as UTF-8 text");
  }
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.compare(0, mark.size(), mark) == 0 ? text.substr(mark.size()) : text;
}

/** Takes a text apart into rows of cells. */
class RowReader
{
public:
  RowReader(const std::string & fileName, const std::string & text, char separator, std::size_t firstLine = 1)
    : m_FileName(fileName), m_Text(text), m_Separator(separator), m_Line(firstLine)
  {}

  /** The next row that has any text. \return false at the end */
  [[nodiscard]] bool
  next(TextTable::Row & row)
  {
    while (m_Position < m_Text.size())
    {
      row = { m_Line, {}, m_Number++ };
      bool more = true;
      while (more)
      {
        row.cells.push_back(nextCell());
        more = passSeparator();
      }
      if (std::any_of(row.cells.begin(), row.cells.end(), [](const std::string & cell) { return !cell.empty(); }))
      {
        return true;
      }
    }
    return false;
  }

private:
  /** Up to the separator or the end of the line. */
  [[nodiscard]] std::string
  nextCell()
  {
    skipBlanks();
    if (at() == '"')
    {
      return quotedCell();
    }
    const char        ends[] = { m_Separator, '\r', '\n', '\0' };
    const std::size_t end = std::min(m_Text.find_first_of(ends, m_Position), m_Text.size());
    const std::string cell = m_Text.substr(m_Position, end - m_Position);
    m_Position = end;
    return withoutBlanksAround(cell);
  }

  [[nodiscard]] std::string
  quotedCell()
  {
    const std::size_t begin = m_Line;
    std::string       cell;
    for (++m_Position; m_Position < m_Text.size(); ++m_Position)
    {
      if (at() == '"' && m_Text.compare(m_Position, 2, "\"\"") == 0)
      {
        ++m_Position;
      }
      else if (at() == '"')
      {
        ++m_Position;
        skipBlanks();
        return cell;
      }
      m_Line += at() == '\n' ? 1 : 0;
      cell += at();
    }
    refuse(m_FileName, begin, "a quote is not closed", "close it; a quote within quotes is written twice");
  }

  /** Goes behind what ends a cell. \return whether another one follows in the row */
  [[nodiscard]] bool
  passSeparator()
  {
    if (m_Position >= m_Text.size())
    {
      return false;
    }
    if (at() == m_Separator)
    {
      ++m_Position;
      return true;
    }
    m_Position += m_Text.compare(m_Position, 2, "\r\n") == 0 ? 1 : 0;
    if (at() == '\r')
    {
      refuse(m_FileName, m_Line, "a carriage return in the line", "save it with lines that end in LF or CRLF");
    }
    if (at() != '\n')
    {
      refuse(m_FileName, m_Line, "text behind a closing quote", "a quote within quotes is written twice");
    }
    ++m_Position;
    ++m_Line;
    return false;
  }

  /** Tabs only where they separate nothing. */
  void
  skipBlanks()
  {
    while (at() != m_Separator && at() != '\0' && blanks.find(at()) != std::string::npos)
    {
      ++m_Position;
    }
  }

  /** The character that comes next; zero at the end. */
  [[nodiscard]] char
  at() const
  {
    return m_Position < m_Text.size() ? m_Text[m_Position] : '\0';
  }

  const std::string & m_FileName;
  const std::string & m_Text;
  char                m_Separator;
  std::size_t         m_Position{ 0 };
  std::size_t         m_Line;
  std::size_t         m_Number{ 0 }; ///< of the next row
};

[[nodiscard]] char
separatorOf(const std::string & fileName, const std::string & text)
{
  std::string ending = std::filesystem::path(fileName).extension().string();
  if (ending == ".tsv" || ending == ".TSV")
  {
    return '\t';
  }
  const std::size_t begin = text.find_first_not_of("\r\n");
  const std::string names = begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
  return names.find(';') != std::string::npos && names.find(',') == std::string::npos ? ';' : ',';
}

void
requireColumnNames(const std::string & fileName, const TextTable::Row & names)
{
  std::set<std::string> seen;
  for (std::size_t n = 0; n < names.cells.size(); ++n)
  {
    if (names.cells[n].empty())
    {
      refuse(fileName, names.line, "column " + std::to_string(n + 1) + " has no name", "name all columns");
    }
    if (!seen.insert(names.cells[n]).second)
    {
      refuse(fileName, names.line, "two columns are called " + oneLine(names.cells[n], 40), "give each another name");
    }
  }
}

/** As a spreadsheet reads it: digits with a sign, a point and an exponent. */
[[nodiscard]] bool
isNumber(const std::string & cell)
{
  const std::size_t sign = cell.front() == '+' || cell.front() == '-' ? 1 : 0;
  double            value = 0.0;
  const char *      end = cell.data() + cell.size();
  return cell.size() > sign && std::string_view("0123456789.").find(cell[sign]) != std::string_view::npos &&
         std::from_chars(cell.data() + sign, end, value).ptr == end;
}

[[nodiscard]] std::string
withoutFormula(const std::string & cell)
{
  const bool suspicious = !cell.empty() && std::string_view("=+-@\t\r").find(cell.front()) != std::string_view::npos;
  return suspicious && !isNumber(cell) ? "'" + cell : cell;
}

[[nodiscard]] bool
needsQuotes(const std::string & cell, char separator)
{
  const char special[] = { separator, '"', '\r', '\n', '\0' };
  return cell.find_first_of(special) != std::string::npos ||
         (!cell.empty() &&
          (blanks.find(cell.front()) != std::string::npos || blanks.find(cell.back()) != std::string::npos));
}

} // namespace

TextTable
readTextTable(const std::string & fileName)
{
  const std::string text = textOf(fileName);
  RowReader         reader(fileName, text, separatorOf(fileName, text));
  TextTable::Row    row;
  if (!reader.next(row))
  {
    throw BadInput(ErrorCode::Empty, fileName, "there are no column names", "name the columns in the first line");
  }
  requireColumnNames(fileName, row);
  const std::size_t names = row.number;
  TextTable         table{ row.cells, {} };
  while (reader.next(row))
  {
    if (row.cells.size() != table.columns.size())
    {
      refuse(fileName,
             row.line,
             std::to_string(row.cells.size()) + " cells for " + std::to_string(table.columns.size()) + " columns",
             "give each column a cell; quote a cell that holds the separator");
    }
    row.number -= names;
    table.rows.push_back(std::move(row));
  }
  return table;
}

TextTable
readTextLines(const std::string & fileName, const std::string & column)
{
  const std::string text = textOf(fileName);
  TextTable         table{ { column }, {} };
  std::size_t       number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string       line = text.substr(begin, end - begin);
    line.erase(line.size() - (!line.empty() && line.back() == '\r' ? 1 : 0));
    if (line.find('\r') != std::string::npos)
    {
      refuse(fileName, number, "a carriage return in the line", "save it with lines that end in LF or CRLF");
    }
    line = withoutBlanksAround(line);
    if (!line.empty())
    {
      table.rows.push_back({ number, { line } });
    }
    begin = end + 1;
  }
  return table;
}

std::vector<std::string>
cellsOfLine(const std::string & fileName, std::size_t number, const std::string & line, char separator)
{
  RowReader      reader(fileName, line, separator, number);
  TextTable::Row row;
  return reader.next(row) ? row.cells : std::vector<std::string>();
}

std::string
tableLine(const std::vector<std::string> & cells, char separator)
{
  std::vector<std::string> safe;
  std::transform(cells.begin(), cells.end(), std::back_inserter(safe), withoutFormula);
  return exactLine(safe, separator);
}

std::string
exactLine(const std::vector<std::string> & cells, char separator)
{
  std::string line;
  for (std::size_t n = 0; n < cells.size(); ++n)
  {
    line += n == 0 ? "" : std::string(1, separator);
    if (!needsQuotes(cells[n], separator))
    {
      line += cells[n];
      continue;
    }
    line += '"';
    for (const char c : cells[n])
    {
      line += c == '"' ? "\"\"" : std::string(1, c);
    }
    line += '"';
  }
  return line + '\n';
}

std::string
withoutBlanksAround(const std::string & text)
{
  const std::size_t begin = text.find_first_not_of(blanks);
  const std::size_t end = text.find_last_not_of(blanks);
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

bool
isTableName(const std::string & fileName)
{
  std::string ending = std::filesystem::path(fileName).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".csv" || ending == ".tsv";
}

std::string
numberText(double value)
{
  constexpr double largestWhole = 1e15;
  if (!std::isfinite(value))
  {
    return "";
  }
  std::array<char, 32> text{};
  char * const         end = text.data() + text.size();
  const bool           isWhole = std::floor(value) == value && std::abs(value) < largestWhole;
  const auto           result =
    isWhole ? std::to_chars(text.data(), end, value, std::chars_format::fixed) : std::to_chars(text.data(), end, value);
  return { text.data(), result.ptr };
}

} // namespace moserhex::app
