#include "RegionChoice.h"

#include "CommandErrors.h"
#include "TextTable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace moserhex::app
{
namespace
{

/** Column of lower, upper of i, j, k, after that of the name. */
constexpr std::array<const char *, 7> columnNames{ "name", "imin", "imax", "jmin", "jmax", "kmin", "kmax" };

[[noreturn]] void
refuse(const std::string & file, std::size_t line, const std::string & cause)
{
  throw BadInput(ErrorCode::Format,
                 file,
                 "line " + std::to_string(line) + ": " + cause,
                 "give name, imin, imax, jmin, jmax, kmin, kmax in [0,1]");
}

std::array<std::size_t, 7>
columnsOf(const TextTable & table, const std::string & file)
{
  std::array<std::size_t, 7> places{};
  for (std::size_t column = 0; column < places.size(); ++column)
  {
    const auto found = std::find(table.columns.begin(), table.columns.end(), columnNames[column]);
    if (found == table.columns.end())
    {
      refuse(file, 1, std::string("no column ") + columnNames[column]);
    }
    places[column] = static_cast<std::size_t>(found - table.columns.begin());
  }
  return places;
}

double
numberOf(const std::string & file, std::size_t line, const std::string & cell)
{
  double     value = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (result.ec != std::errc() || result.ptr != cell.data() + cell.size())
  {
    refuse(file, line, "\"" + cell + "\" is no number");
  }
  return value;
}

CubeRegion
regionOf(const std::string & file, const TextTable::Row & row, const std::array<std::size_t, 7> & columns)
{
  CubeRegion region{ row.cells[columns[0]], {}, {} };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<Eigen::Index>(axis);
    region.box.lower[at] = numberOf(file, row.line, row.cells[columns[1 + 2 * axis]]);
    region.box.upper[at] = numberOf(file, row.line, row.cells[columns[2 + 2 * axis]]);
  }
  try
  {
    requireValid(region);
  }
  catch (const InvalidInput & error)
  {
    refuse(file, row.line, error.what());
  }
  return region;
}

RegionSet
readRegions(const std::string & file)
{
  const TextTable       table = readTextTable(file);
  const auto            columns = columnsOf(table, file);
  RegionSet             set{ "boxes", {}, inputFile(file) };
  std::set<std::string> names;
  for (const TextTable::Row & row : table.rows)
  {
    set.regions.push_back(regionOf(file, row, columns));
    const std::string & name = set.regions.back().name;
    if (name.empty() || !names.insert(name).second)
    {
      refuse(file, row.line, name.empty() ? "no name" : "the name " + name + " again");
    }
  }
  if (set.regions.empty())
  {
    refuse(file, 1, "no region below the names of the columns");
  }
  return set;
}

bool
areOverlapping(const CubeBox & a, const CubeBox & b)
{
  constexpr double rounding = 1e-9; // boxes that touch [1]
  return ((a.upper.cwiseMin(b.upper) - a.lower.cwiseMax(b.lower)).array() > rounding).all();
}

void
addWarningOfOverlaps(const RegionSet & boxes, std::vector<std::string> & warnings)
{
  std::size_t pairs = 0;
  std::string first;
  for (std::size_t b = 0; b < boxes.regions.size(); ++b)
  {
    for (std::size_t a = 0; a < b; ++a)
    {
      if (areOverlapping(boxes.regions[a].box, boxes.regions[b].box))
      {
        first =
          pairs++ == 0 ? oneLine(boxes.regions[a].name, 20) + " and " + oneLine(boxes.regions[b].name, 20) : first;
      }
    }
  }
  if (pairs > 0)
  {
    warnings.push_back(fileMessage(boxes.table.name,
                                   first + " overlap" + (pairs > 1 ? ", as others do" : ""),
                                   "in the table both count what is in both, the array Boxes shows the first"));
  }
}

void
addWarningsOfThinBoxes(const RegionSet & boxes, int nodesPerSide, std::vector<std::string> & warnings)
{
  for (const CubeRegion & region : boxes.regions)
  {
    const std::vector<int> numbers = regionOfCells({ region }, nodesPerSide);
    if (std::all_of(numbers.begin(), numbers.end(), [](int number) { return number == 0; }))
    {
      warnings.push_back(fileMessage(boxes.table.name,
                                     oneLine(region.name, 20) + " has more than half of no cell",
                                     "the table counts its parts of cells, the array Boxes does not show it"));
    }
  }
}

RegionSet
setOf(const std::string & choice, int nodesPerSide)
{
  if (choice == "octants")
  {
    return { choice, octantRegions(), {} };
  }
  if (choice == "halves")
  {
    return { choice, halfRegions(), {} };
  }
  if (choice == "shells")
  {
    return { choice, shellRegions(nodesPerSide), {} };
  }
  if (isTableName(choice))
  {
    return readRegions(choice);
  }
  throw UsageError("no regions " + choice + "; give octants, halves, shells, or a table .csv or .tsv");
}

} // namespace

std::vector<RegionSet>
chosenRegions(const std::vector<std::string> & choices, int nodesPerSide)
{
  std::vector<RegionSet> sets;
  std::set<std::string>  names;
  for (const std::string & choice : choices)
  {
    sets.push_back(setOf(choice, nodesPerSide));
    if (!names.insert(sets.back().name).second)
    {
      throw UsageError("--regions names " + sets.back().name + " twice; give each once, and one table");
    }
  }
  return sets;
}

std::vector<std::string>
regionWarnings(const std::vector<RegionSet> & sets, int nodesPerSide)
{
  std::vector<std::string> warnings;
  for (const RegionSet & set : sets)
  {
    if (!set.table.name.empty())
    {
      addWarningOfOverlaps(set, warnings);
      addWarningsOfThinBoxes(set, nodesPerSide, warnings);
    }
  }
  return warnings;
}

} // namespace moserhex::app
