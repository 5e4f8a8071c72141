#include "ArrayValues.h"

#include "CommandErrors.h"
#include "FigureOptions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace moserhex::app
{
namespace
{

constexpr std::size_t longestRefusal = 183; ///< what a line of 200 characters has left
constexpr std::size_t longestName = 40;

/** An array, and the component that is asked for. */
struct ArrayChoice
{
  const NamedArray * array{ nullptr };
  bool               isOfCells{ false };
  std::optional<int> component; ///< empty: the norm
};

const NamedArray *
find(const std::vector<NamedArray> & arrays, const std::string & name)
{
  const auto found =
    std::find_if(arrays.begin(), arrays.end(), [&name](const NamedArray & array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

ArrayChoice
chooseArray(const HexCellArrays & arrays, const std::string & name)
{
  const NamedArray * ofCells = find(arrays.ofCells, name);
  return { ofCells != nullptr ? ofCells : find(arrays.ofNodes, name), ofCells != nullptr, {} };
}

/** How many letters must be put in, left out or changed, large and small ones being the same (Levenshtein). */
std::size_t
editsBetween(const std::string & a, const std::string & b)
{
  const auto               small = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  std::vector<std::size_t> edits(b.size() + 1); // from what is read of a to the first letters of b
  std::iota(edits.begin(), edits.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = std::exchange(edits[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t changed = diagonal + (small(a[i]) == small(b[j]) ? 0 : 1);
      diagonal = edits[j + 1];
      edits[j + 1] = std::min({ changed, edits[j] + 1, edits[j + 1] + 1 });
    }
  }
  return edits.back();
}

/** What there is to colour by, as much as a line holds, what is spelt like `wanted` first. */
std::string
namesOf(const HexCellArrays & arrays, const std::string & wanted, std::size_t length)
{
  std::vector<std::string> names;
  for (const auto * some : { &arrays.ofCells, &arrays.ofNodes })
  {
    for (const NamedArray & array : *some)
    {
      names.push_back(oneLine(array.name, longestName));
    }
  }
  names.insert(names.end(), figureColours.begin(), figureColours.end());
  std::stable_sort(names.begin(), names.end(), [&wanted](const std::string & a, const std::string & b) {
    return editsBetween(wanted, a) < editsBetween(wanted, b);
  });
  std::string list = names.front();
  for (std::size_t next = 1; next < names.size(); ++next)
  {
    const std::string rest = " and " + std::to_string(names.size() - next) + " more";
    if (list.size() + 2 + names[next].size() + rest.size() > length)
    {
      return list + rest;
    }
    list += ", " + names[next];
  }
  return list;
}

[[noreturn]] void
refuse(const DrawnMesh & mesh, const std::string & name)
{
  const std::string wanted = oneLine(name, longestName);
  const std::string cause = "--colour " + wanted + ": no such measure or array; there are ";
  throw UsageError(cause + namesOf(mesh.arrays, wanted, longestRefusal - cause.size()));
}

/** \throws UsageError  no such array or component */
ArrayChoice
requireArray(const DrawnMesh & mesh, const std::string & name)
{
  ArrayChoice choice = chooseArray(mesh.arrays, name);
  if (choice.array != nullptr)
  {
    return choice;
  }
  const std::size_t colon = name.rfind(':');
  const std::string digits = colon == std::string::npos ? "" : name.substr(colon + 1);
  if (digits.empty() || digits.size() > 4 || digits.find_first_not_of("0123456789") != std::string::npos)
  {
    refuse(mesh, name);
  }
  choice = chooseArray(mesh.arrays, name.substr(0, colon));
  if (choice.array == nullptr)
  {
    refuse(mesh, name);
  }
  choice.component = std::stoi(digits);
  if (*choice.component >= choice.array->components)
  {
    throw UsageError("--colour " + oneLine(name, longestName) + ": components go from 0 to " +
                     std::to_string(choice.array->components - 1));
  }
  return choice;
}

/** One number of one tuple. */
double
numberOf(const std::vector<double> & tuple, const std::optional<int> & component)
{
  if (component)
  {
    return tuple[static_cast<std::size_t>(*component)];
  }
  if (tuple.size() == 1)
  {
    return tuple[0];
  }
  double sum = 0.0;
  for (std::size_t one = 0; one < tuple.size(); ++one)
  {
    const double times = tuple.size() == 6 && one >= 3 ? 2.0 : 1.0;
    sum += times * tuple[one] * tuple[one];
  }
  return std::sqrt(sum);
}

/** The mean of those of some tuples that are finite; NaN: none is. */
template <typename TNumbers>
std::vector<double>
meanTuple(const NamedArray & array, const TNumbers & numbers)
{
  const auto          width = static_cast<std::size_t>(array.components);
  std::vector<double> sum(width, 0.0);
  double              count = 0.0;
  for (const std::size_t number : numbers)
  {
    const double * const tuple = array.values.data() + number * width;
    if (std::all_of(tuple, tuple + width, [](double value) { return std::isfinite(value); }))
    {
      std::transform(tuple, tuple + width, sum.begin(), sum.begin(), std::plus<>());
      count += 1.0;
    }
  }
  for (double & value : sum)
  {
    value /= count;
  }
  return sum;
}

} // namespace

std::vector<double>
valuesOfArray(const DrawnMesh & mesh, const std::string & name)
{
  const ArrayChoice   choice = requireArray(mesh, name);
  std::vector<double> values;
  for (std::size_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
  {
    const std::vector<double> tuple = choice.isOfCells
                                        ? meanTuple(*choice.array, std::array<std::size_t, 1>{ { cell } })
                                        : meanTuple(*choice.array, mesh.cells.cells[cell]);
    values.push_back(numberOf(tuple, choice.component));
  }
  if (std::none_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
  {
    throw InvalidInput("array " + oneLine(name, longestName) + " has no number in any cell");
  }
  return values;
}

} // namespace moserhex::app
