#include "TableCells.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace moserhex::app
{
namespace
{

constexpr std::size_t shownLength = 40;

[[noreturn]] void
refuse(const TextTable & table, std::size_t column, const TextTable::Row & row, const std::string & flaw)
{
  throw BadInput(ErrorCode::Format,
                 table.columns[column],
                 "line " + std::to_string(row.line) + ": " + oneLine(row.cells[column], shownLength) + " " + flaw,
                 "correct it, or leave it empty");
}

bool
isDigit(char c)
{
  return c >= '0' && c <= '9';
}

} // namespace

bool
isMissing(const std::string & cell)
{
  constexpr std::array<std::string_view, 6> words{ "", "n/a", "na", "nan", "null", "." };
  std::string                               small = cell;
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::find(words.begin(), words.end(), small) != words.end();
}

std::optional<double>
numberOf(const std::string & cell)
{
  const bool   isPlus = cell.size() > 1 && cell[0] == '+' && (isDigit(cell[1]) || cell[1] == '.');
  const char * begin = cell.data() + (isPlus ? 1 : 0); // from_chars knows no plus
  const char * end = cell.data() + cell.size();
  double       value = 0.0;
  const auto   result = std::from_chars(begin, end, value);
  const bool   isNumber = result.ec == std::errc() && result.ptr == end && std::isfinite(value);
  return isNumber ? std::optional<double>(value) : std::nullopt;
}

std::size_t
columnNumber(const TextTable & table, const std::string & column)
{
  return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                  table.columns.begin());
}

CellKind
kindOfColumn(const TextTable & table, std::size_t number)
{
  const TextTable::Row * word = nullptr;
  bool                   isAnyNumber = false;
  for (const TextTable::Row & row : table.rows)
  {
    const std::string & cell = row.cells[number];
    const bool          isNumber = numberOf(cell).has_value();
    isAnyNumber = isAnyNumber || isNumber;
    word = word == nullptr && !isNumber && !isMissing(cell) ? &row : word;
  }
  if (word != nullptr && isAnyNumber)
  {
    refuse(table, number, *word, "among numbers");
  }
  return word == nullptr ? CellKind::Numbers : CellKind::Words;
}

std::vector<std::optional<double>>
numbersIn(const TextTable & table, std::size_t number)
{
  std::vector<std::optional<double>> numbers;
  for (const TextTable::Row & row : table.rows)
  {
    numbers.push_back(numberOf(row.cells[number]));
    if (!numbers.back() && !isMissing(row.cells[number]))
    {
      refuse(table, number, row, "is no number");
    }
  }
  return numbers;
}

void
requirePlainWords(const TextTable & table, std::size_t number)
{
  for (const TextTable::Row & row : table.rows)
  {
    const std::string & cell = row.cells[number];
    if (!isMissing(cell) && std::string_view("0123456789+-.").find(cell.front()) != std::string_view::npos)
    {
      refuse(table, number, row, "is no number, and words begin with a letter");
    }
  }
}

} // namespace moserhex::app
