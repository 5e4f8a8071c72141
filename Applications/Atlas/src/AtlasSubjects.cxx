#include "AtlasSubjects.h"

#include "CommandErrors.h"
#include "EarlierAtlas.h"
#include "SameFile.h"
#include "TableCells.h"
#include "TextTable.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

bool
isHidden(const fs::path & path)
{
  return path.filename().string().front() == '.';
}

/** The meshes of a folder and of those below it, sorted by their paths. \param warnings  of folders left out */
std::vector<fs::path>
meshesBelow(const std::string & folder, const std::string & outputFolder, std::vector<std::string> & warnings)
{
  std::vector<fs::path> meshes;
  std::vector<fs::path> atlases;
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
      else if (holdsAtlas(path.string()))
      {
        entry.disable_recursion_pending();
        atlases.push_back(path);
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
  std::sort(atlases.begin(), atlases.end());
  for (const fs::path & atlas : atlases)
  {
    warnings.push_back(fileMessage(atlas.string(), "an atlas, whose meshes are no subjects", "it is left out"));
  }
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
    if (isMissing(mesh))
    {
      throw BadInput(ErrorCode::Format, fileName, "no mesh in line " + std::to_string(row.line), "fill in or drop it");
    }
    const fs::path path = fs::path(subjects.tableFolder) / mesh;
    const bool     isNamed = nameColumn < table.columns.size() && !isMissing(row.cells[nameColumn]);
    subjects.subjects.push_back({ isNamed ? row.cells[nameColumn] : withoutEnding(mesh), path.string() });
  }
}

void
requireFolderOfSubjects(const std::string & folder, const std::string & outputFolder)
{
  if (sameFile(folder, outputFolder))
  {
    throw UsageError(fileMessage(folder, "an input and the output", "write to another folder"));
  }
  if (holdsAtlas(folder))
  {
    throw BadInput(
      ErrorCode::NoInput, folder, "an atlas, whose meshes are no subjects", "give the folder of the subjects' meshes");
  }
}

void
addInput(AtlasSubjects & subjects, const std::string & input, const std::string & outputFolder)
{
  std::error_code ignored;
  if (fs::is_directory(input, ignored))
  {
    requireFolderOfSubjects(input, outputFolder);
    for (const fs::path & mesh : meshesBelow(input, outputFolder, subjects.warnings))
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

/** \throws BadInput  there is none */
std::size_t
requireColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const std::size_t number = columnNumber(subjects.table, column);
  if (number == subjects.table.columns.size())
  {
    throw BadInput(ErrorCode::Format,
                   column,
                   "no such column",
                   subjects.table.columns.empty() ? "give a table (.csv .tsv) with it and a column mesh"
                                                  : "name one of the table's columns");
  }
  return number;
}

/** Of a column's words, or of its numbers, however they are written. */
GroupColumn
groupsIn(const TextTable & table, std::size_t number)
{
  const auto nameOf = [number](const TextTable::Row & row) {
    const std::optional<double> value = numberOf(row.cells[number]);
    return value ? numberText(*value + 0.0) : row.cells[number]; // of -0, 0
  };
  std::set<std::string> different;
  for (const TextTable::Row & row : table.rows)
  {
    if (!isMissing(row.cells[number]))
    {
      different.insert(nameOf(row));
    }
  }
  GroupColumn groups{ {}, { different.begin(), different.end() } };
  if (kindOfColumn(table, number) == CellKind::Numbers)
  {
    std::sort(groups.names.begin(), groups.names.end(), [](const std::string & a, const std::string & b) {
      return *numberOf(a) < *numberOf(b);
    });
  }
  for (const TextTable::Row & row : table.rows)
  {
    const auto place = std::find(groups.names.begin(), groups.names.end(), nameOf(row)) - groups.names.begin();
    groups.numbers.push_back(isMissing(row.cells[number]) ? std::nullopt
                                                          : std::optional<double>(static_cast<double>(place)));
  }
  return groups;
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
  if (subjects.subjects.empty())
  {
    throw BadInput(ErrorCode::Empty,
                   inputs.empty() ? "atlas" : inputs.front(),
                   "no subject",
                   "give the table a row for each of them");
  }
  requireUnique(subjects);
  return subjects;
}

std::vector<std::optional<double>>
numbersOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const std::vector<NumberColumn> columns = covariatesOfColumn(subjects, column);
  if (columns.size() > 1)
  {
    throw BadInput(ErrorCode::Format,
                   column,
                   std::to_string(columns.size() + 1) + " different values in the column, need 2 words or numbers",
                   "choose another column or code it");
  }
  return columns.front();
}

std::vector<NumberColumn>
covariatesOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const std::size_t number = requireColumn(subjects, column);
  if (kindOfColumn(subjects.table, number) == CellKind::Numbers)
  {
    return { numbersIn(subjects.table, number) };
  }
  requirePlainWords(subjects.table, number);
  const GroupColumn         words = groupsIn(subjects.table, number);
  std::vector<NumberColumn> columns(std::max<std::size_t>(2, words.names.size()) - 1, words.numbers);
  for (std::size_t word = 1; word <= columns.size(); ++word)
  {
    for (std::optional<double> & value : columns[word - 1])
    {
      value = value ? std::optional<double>(*value == static_cast<double>(word) ? 1.0 : 0.0) : std::nullopt;
    }
  }
  return columns;
}

std::vector<std::optional<std::string>>
filesOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const std::size_t                       number = requireColumn(subjects, column);
  std::vector<std::optional<std::string>> files;
  for (const TextTable::Row & row : subjects.table.rows)
  {
    const std::string & cell = row.cells[number];
    files.push_back(isMissing(cell) ? std::nullopt
                                    : std::optional<std::string>((fs::path(subjects.tableFolder) / cell).string()));
  }
  return files;
}

GroupColumn
groupsOfColumn(const AtlasSubjects & subjects, const std::string & column)
{
  const std::size_t number = requireColumn(subjects, column);
  const bool        areNumbers = kindOfColumn(subjects.table, number) == CellKind::Numbers;
  GroupColumn       groups = groupsIn(subjects.table, number);
  if (groups.names.size() < 2 || (groups.names.size() > 2 && areNumbers))
  {
    throw BadInput(ErrorCode::Format,
                   column,
                   std::to_string(groups.names.size()) + " different " + (areNumbers ? "numbers" : "values") +
                     " in the column, need two groups, or more that are words",
                   "choose another column, write the groups as words, or use --regress");
  }
  return groups;
}

} // namespace moserhex::app
