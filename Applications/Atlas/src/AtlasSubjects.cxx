#include "AtlasSubjects.h"

#include "CommandErrors.h"
#include "SameFile.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

bool
isTableName(const std::string & name)
{
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".csv" || ending == ".tsv";
}

bool
isHidden(const fs::path & path)
{
  return path.filename().string().front() == '.';
}

/** The meshes of a folder and of those below it, sorted by their paths. */
std::vector<fs::path>
meshesBelow(const std::string & folder, const std::string & outputFolder)
{
  std::vector<fs::path> meshes;
  std::error_code       error;
  auto                  entry = fs::recursive_directory_iterator(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
  {
    const fs::path & path = entry->path();
    std::error_code  ignored;
    if (entry->is_directory(ignored))
    {
      if (isHidden(path) || sameFile(path.string(), outputFolder))
      {
        entry.disable_recursion_pending();
      }
    }
    else if (!isHidden(path) && isHexCellName(path.string()))
    {
      meshes.push_back(path);
    }
  }
  if (error)
  {
    throw IOError(ErrorCode::InputOutput, folder, "cannot read the folder (" + error.message() + ")", "check it");
  }
  if (meshes.empty())
  {
    throw BadInput(ErrorCode::NoInput, folder, "no mesh in the folder", "give meshes, .vtu .vtk .msh .mesh .inp");
  }
  std::sort(meshes.begin(), meshes.end());
  return meshes;
}

std::string
withoutEnding(fs::path path)
{
  return path.replace_extension().generic_string();
}

void
addMesh(AtlasSubjects & subjects, const fs::path & mesh, const std::string & name)
{
  const bool isTaken = std::any_of(subjects.subjects.begin(),
                                   subjects.subjects.end(),
                                   [&](const AtlasSubject & subject) { return subject.name == name; });
  subjects.subjects.push_back({ isTaken ? withoutEnding(mesh) : name, mesh.string() });
}

std::size_t
columnNumber(const TextTable & table, const std::string & column)
{
  return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                  table.columns.begin());
}

void
addTable(AtlasSubjects & subjects, const std::string & fileName)
{
  subjects.table = readTextTable(fileName);
  subjects.tableFolder = fs::path(fileName).parent_path().string();
  const TextTable & table = subjects.table;
  const std::size_t meshColumn = columnNumber(table, "mesh");
  const std::size_t nameColumn = columnNumber(table, "subject");
  if (meshColumn == table.columns.size())
  {
    throw BadInput(ErrorCode::Format, fileName, "no column mesh", "name the column of the mesh files so");
  }
  for (const TextTable::Row & row : table.rows)
  {
    const std::string & mesh = row.cells[meshColumn];
    if (mesh.empty())
    {
      throw BadInput(ErrorCode::Format, fileName, "no mesh in line " + std::to_string(row.line), "fill in or drop it");
    }
    const fs::path path = fs::path(subjects.tableFolder) / mesh;
    const bool     isNamed = nameColumn < table.columns.size() && !row.cells[nameColumn].empty();
    subjects.subjects.push_back({ isNamed ? row.cells[nameColumn] : withoutEnding(mesh), path.string() });
  }
}

void
addInput(AtlasSubjects & subjects, const std::string & input, const std::string & outputFolder)
{
  std::error_code ignored;
  if (fs::is_directory(input, ignored))
  {
    for (const fs::path & mesh : meshesBelow(input, outputFolder))
    {
      addMesh(subjects, mesh, withoutEnding(mesh.lexically_relative(input)));
    }
    return;
  }
  addMesh(subjects, input, withoutEnding(fs::path(input).filename()));
}

void
requireUnique(const AtlasSubjects & subjects)
{
  std::set<std::string> files;
  std::set<std::string> names;
  for (const AtlasSubject & subject : subjects.subjects)
  {
    std::error_code ignored;
    if (!files.insert(fs::weakly_canonical(subject.mesh, ignored).string()).second)
    {
      throw UsageError(fileMessage(subject.mesh, "given twice", "give every subject once"));
    }
    if (!names.insert(subject.name).second)
    {
      throw UsageError(
        fileMessage(subject.mesh, "a second subject " + subject.name, "give every subject its own name"));
    }
  }
}

bool
isMissing(const std::string & cell)
{
  return cell.empty() || cell == "n/a";
}

std::optional<double>
numberOf(const std::string & cell)
{
  double     value = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool isNumber = result.ec == std::errc() && result.ptr == cell.data() + cell.size() && std::isfinite(value);
  return isNumber ? std::optional<double>(value) : std::nullopt;
}

std::vector<std::string>
cellsOf(const AtlasSubjects & subjects, const std::string & column)
{
  const TextTable & table = subjects.table;
  const std::size_t number = columnNumber(table, column);
  if (number == table.columns.size())
  {
    throw BadInput(ErrorCode::Format,
                   column,
                   "no such column",
                   table.columns.empty() ? "give a table (.csv .tsv) with it and a column mesh"
                                         : "name one of the table's columns");
  }
  std::vector<std::string> cells;
  for (const TextTable::Row & row : table.rows)
  {
    cells.push_back(row.cells[number]);
  }
  return cells;
}

bool
areNumbers(const std::vector<std::string> & cells)
{
  return std::all_of(cells.begin(), cells.end(), [](const std::string & cell) { return numberOf(cell).has_value(); });
}

/** Different cells that are not missing, ascending: as numbers where all are numbers, else in the alphabet. */
std::vector<std::string>
differentCells(const std::vector<std::string> & cells)
{
  std::set<std::string> different;
  std::copy_if(cells.begin(), cells.end(), std::inserter(different, different.end()), [](const std::string & cell) {
    return !isMissing(cell);
  });
  std::vector<std::string> values(different.begin(), different.end());
  if (areNumbers(values))
  {
    std::sort(values.begin(), values.end(), [](const std::string & a, const std::string & b) {
      return *numberOf(a) < *numberOf(b);
    });
  }
  return values;
}

} // namespace

AtlasSubjects
listAtlasSubjects(const std::vector<std::string> & inputs, const std::string & outputFolder)
{
  AtlasSubjects subjects;
  if (inputs.size() == 1 && isTableName(inputs.front()))
  {
    addTable(subjects, inputs.front());
  }
  else
  {
    for (const std::string & input : inputs)
    {
      if (isTableName(input))
      {
        throw UsageError(fileMessage(input, "a table among other inputs", "give the table alone"));
      }
      addInput(subjects, input, outputFolder);
    }
  }
  requireUnique(subjects);
  return subjects;
}

std::vector<std::optional<double>>
numbersOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const auto cells = cellsOf(subjects, column);
  const auto different = differentCells(cells);
  if (!areNumbers(different))
  {
    if (different.size() != 2)
    {
      throw BadInput(ErrorCode::Format,
                     column,
                     std::to_string(different.size()) + " different values in the column, need 2 words or numbers",
                     "choose another column or code it");
    }
    return groupsOfColumn(subjects, column).numbers;
  }
  std::vector<std::optional<double>> numbers;
  for (const std::string & cell : cells)
  {
    numbers.push_back(isMissing(cell) ? std::nullopt : numberOf(cell));
  }
  return numbers;
}

std::vector<std::optional<std::string>>
filesOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  std::vector<std::optional<std::string>> files;
  for (const std::string & cell : cellsOf(subjects, column))
  {
    files.push_back(isMissing(cell) ? std::nullopt
                                    : std::optional<std::string>((fs::path(subjects.tableFolder) / cell).string()));
  }
  return files;
}

GroupColumn
groupsOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const auto  cells = cellsOf(subjects, column);
  GroupColumn groups{ {}, differentCells(cells) };
  if (groups.names.size() < 2 || (groups.names.size() > 2 && areNumbers(groups.names)))
  {
    throw BadInput(ErrorCode::Format,
                   column,
                   std::to_string(groups.names.size()) + " different " +
                     (areNumbers(groups.names) ? "numbers" : "values") +
                     " in the column, need two groups, or more that are words",
                   "choose another column, write the groups as words, or use --regress");
  }
  for (const std::string & cell : cells)
  {
    const auto place = std::find(groups.names.begin(), groups.names.end(), cell) - groups.names.begin();
    groups.numbers.push_back(isMissing(cell) ? std::nullopt : std::optional<double>(static_cast<double>(place)));
  }
  return groups;
}

} // namespace moserhex::app
