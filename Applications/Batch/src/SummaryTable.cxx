#include "Summary.h"

#include "TextTable.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

double
figureOf(const SummaryRow & row, const std::string & name)
{
  const auto figure = row.figures.find(name);
  return figure == row.figures.end() ? std::nan("") : figure->second;
}

/** Those that are always there, and seconds and memory if a row has them. */
std::vector<std::string>
figureColumns(const std::vector<SummaryRow> & rows)
{
  std::vector<std::string> columns;
  for (const std::string & name : summaryFigures())
  {
    const bool isAlwaysThere = name != "seconds" && name != "peak_memory_mib";
    if (isAlwaysThere || std::any_of(rows.begin(), rows.end(), [&name](const SummaryRow & row) {
          return std::isfinite(figureOf(row, name));
        }))
    {
      columns.push_back(name);
    }
  }
  return columns;
}

} // namespace

void
writeSummaryTable(const std::string &              fileName,
                  const std::vector<SummaryRow> &  rows,
                  const std::vector<std::string> & keptColumns)
{
  const std::vector<std::string> figures = figureColumns(rows);
  std::vector<std::string>       header{ "case", "status", "code", "message", "input", "labels", "label_name" };
  header.insert(header.end(), figures.begin(), figures.end());
  for (const std::string & name : keptColumns)
  {
    const bool isTaken = std::find(header.begin(), header.end(), name) != header.end();
    header.push_back(isTaken ? "list_" + name : name);
  }
  std::string text = tableLine(header, ',');
  for (const SummaryRow & row : rows)
  {
    std::vector<std::string> cells{ row.name,  nameOf(row.status), row.code,     row.message,
                                    row.input, row.labels,         row.labelName };
    for (const std::string & name : figures)
    {
      cells.push_back(numberText(figureOf(row, name)));
    }
    cells.insert(cells.end(), row.kept.begin(), row.kept.end());
    cells.resize(header.size());
    text += tableLine(cells, ',');
  }
  writeTextFile(fileName, text);
}

} // namespace moserhex::app
