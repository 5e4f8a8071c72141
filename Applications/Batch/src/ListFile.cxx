#include "ListFile.h"

#include "CaseNames.h"
#include "CommandErrors.h"
#include "MeshArguments.h"
#include "TextTable.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <algorithm>
#include <filesystem>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

[[nodiscard]] bool
contains(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** As people write it who do not know it exactly. */
[[nodiscard]] std::string
loosely(const std::string & name)
{
  std::string loose = lowerCase(name);
  std::replace_if(
    loose.begin(), loose.end(), [](char c) { return c == '_' || c == ' '; }, '-');
  return loose;
}

[[noreturn]] void
refuseColumn(const std::string & list, const std::string & column)
{
  std::vector<std::string> known = meshingOptionNames();
  known.insert(known.end(), { "input", "output" });
  const auto meant = std::find(known.begin(), known.end(), loosely(column));
  throw UsageError(usageMessage(list,
                                "column '" + oneLine(column, 40) + "' is no option of mesh",
                                meant == known.end() ? "correct its name, or take it over with --keep-columns"
                                                     : "write '" + *meant + "', or take it over with --keep-columns"));
}

/** \throws UsageError  no input; a column that is neither an option nor kept */
void
requireKnownColumns(const std::string & list, const std::vector<std::string> & columns, const CaseListOptions & options)
{
  for (const std::string & column : columns)
  {
    if (!isListOption(column) && !contains(options.keepColumns, column))
    {
      refuseColumn(list, column);
    }
  }
  if (!contains(columns, "input"))
  {
    throw UsageError(usageMessage(list, "no column is called input", "name the columns in the first line"));
  }
}

/** \throws UsageError  not a path below the output folder, or no ending of a mesh */
[[nodiscard]] std::string
checkedOutput(const CaseRequest & request, const std::string & cell)
{
  const fs::path output = fs::path(cell).lexically_normal();
  if (!staysBelow(output))
  {
    refuse(request, "the path leaves the output folder: " + shortName(cell), "give one below it");
  }
  if (!isHexMeshName(cell))
  {
    refuse(request,
           shortName(cell) + " is not a mesh file's name",
           std::string("give an output that ends with ") + hexMeshEndings);
  }
  return output.generic_string();
}

using Values = std::vector<std::pair<std::string, std::string>>;

/** The options of a row, over those that hold for all. */
void
setOptions(const Values & values, CaseRequest & request)
{
  Values     own = values;
  const auto all = std::find(own.begin(), own.end(), Values::value_type("label", "all"));
  const bool everyLabel = all != own.end();
  if (everyLabel)
  {
    own.erase(all);
    request.options.input.label.reset();
    request.options.input.segment.reset();
    request.options.input.threshold.reset();
  }
  const bool chosen = std::any_of(own.begin(), own.end(), [](const Values::value_type & value) {
    return value.first == "label" || value.first == "segment" || value.first == "threshold";
  });
  if (everyLabel && chosen)
  {
    refuse(request, "all labels, and a segment or threshold", "leave one of the cells empty");
  }
  request.allLabels = everyLabel || (request.allLabels && !chosen);
  if (own.empty())
  {
    return;
  }
  try
  {
    setMeshingOptions(own, request.options);
  }
  catch (const UsageError & error)
  {
    refuse(request, error.what(), "correct the cell, or leave it empty");
  }
}

[[nodiscard]] CaseRequest
requestOfRow(const std::string &              list,
             const std::vector<std::string> & columns,
             const TextTable::Row &           row,
             const CaseListOptions &          options)
{
  const fs::path folder = fs::path(list).parent_path();
  CaseRequest    request;
  request.list = list;
  request.line = row.line;
  request.base = options.base.empty() ? folder.string() : options.base;
  request.options = options.defaults;
  request.allLabels = options.allLabels;
  request.kept.resize(options.keepColumns.size());
  Values values;
  for (std::size_t n = 0; n < columns.size(); ++n)
  {
    const std::string & column = columns[n];
    const std::string & cell = row.cells[n];
    const auto          kept = std::find(options.keepColumns.begin(), options.keepColumns.end(), column);
    if (kept != options.keepColumns.end())
    {
      request.kept[static_cast<std::size_t>(kept - options.keepColumns.begin())] = cell;
    }
    else if (cell.empty() || cell == "n/a")
    {
      continue;
    }
    else if (column == "input")
    {
      request.options.input.file = (folder / cell).string();
    }
    else if (column == "output")
    {
      request.output = checkedOutput(request, cell);
    }
    else
    {
      const bool isFile = isFileOption(column, cell);
      values.emplace_back(column, isFile ? (folder / cell).string() : cell);
    }
  }
  if (request.options.input.file.empty())
  {
    refuse(request, "no input", "give one, or delete the line");
  }
  setOptions(values, request);
  return request;
}

} // namespace

bool
isListName(const std::string & fileName)
{
  const std::string ending = lowerCase(fs::path(fileName).extension().string());
  return ending == ".csv" || ending == ".tsv" || ending == ".txt";
}

bool
isListOption(const std::string & column)
{
  return column == "input" || column == "output" || contains(meshingOptionNames(), column);
}

std::vector<CaseRequest>
requestsOfList(const std::string & list, const CaseListOptions & options, std::set<std::string> & found)
{
  const bool      oneColumn = lowerCase(fs::path(list).extension().string()) == ".txt";
  const TextTable table = oneColumn ? readTextLines(list, "input") : readTextTable(list);
  requireKnownColumns(list, table.columns, options);
  found.insert(table.columns.begin(), table.columns.end());
  if (table.rows.empty())
  {
    throw UsageError(usageMessage(list, "the list names no input", "give a line for each"));
  }
  std::vector<CaseRequest> requests;
  requests.reserve(table.rows.size());
  for (const TextTable::Row & row : table.rows)
  {
    requests.push_back(requestOfRow(list, table.columns, row, options));
  }
  return requests;
}

} // namespace moserhex::app
