#include "SummaryPage.h"

#include "GroupPage.h"
#include "HtmlText.h"
#include "Version.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;

/** A column of the page and the figure it shows. */
struct ShownFigure
{
  PageColumn   column;
  const char * figure;
  double       factor; ///< from the figure's unit to the page's
};

const std::vector<ShownFigure> &
shownFigures()
{
  static const std::vector<ShownFigure> shown{
    { { "volume", "mesh volume (mL)", true, true }, "mesh_volume_mm3", 1e-3 },
    { { "variance", "volume variance", false, false }, "volume_variance", 1.0 },
    { { "sj-min", "scaled Jacobian, smallest", true, true }, "sj_min", 1.0 },
    { { "sj-mean", "scaled Jacobian, mean", true, true }, "sj_mean", 1.0 },
    { { "dice", "Dice", true, true }, "dice", 1.0 },
    { { "surface", "surface within (mm)", true, true }, "surface_max_mm", 1.0 },
    { { "repair", "repaired (%)", true, true }, "repair_percent", 1.0 },
    { { "warnings", "warnings", false, false }, "warnings", 1.0 },
    { { "seconds", "seconds", true, false }, "seconds", 1.0 },
  };
  return shown;
}

double
figureOf(const SummaryRow & row, const ShownFigure & shown)
{
  const auto figure = row.figures.find(shown.figure);
  return figure == row.figures.end() ? std::nan("") : shown.factor * figure->second;
}

/** Columns that no case has (seconds of reproducible runs) are left out. */
std::vector<ShownFigure>
figuresOf(const std::vector<SummaryRow> & rows)
{
  std::vector<ShownFigure> figures;
  for (const ShownFigure & shown : shownFigures())
  {
    for (const SummaryRow & row : rows)
    {
      if (std::isfinite(figureOf(row, shown)))
      {
        figures.push_back(shown);
        break;
      }
    }
  }
  return figures;
}

std::string
linkTo(const std::string & page, const std::string & fromFile)
{
  if (page.empty())
  {
    return "";
  }
  const fs::path folder = fs::absolute(fromFile).parent_path();
  return urlOfPath(fs::absolute(page).lexically_relative(folder).generic_string());
}

} // namespace

void
writeSummaryPage(const std::string & fileName, const std::vector<SummaryRow> & rows)
{
  GroupContent content;
  content.heading = "Meshes of " + std::to_string(rows.size()) + (rows.size() == 1 ? " case" : " cases");
  content.subtitle = "Structured hexahedral meshes of many labelmaps";
  content.caseName = "case";
  content.version = version;
  const std::vector<ShownFigure> figures = figuresOf(rows);
  for (const ShownFigure & shown : figures)
  {
    content.columns.push_back(shown.column);
  }
  for (const SummaryRow & row : rows)
  {
    PageRow shown{ row.name, nameOf(row.status), row.code, row.message, {}, linkTo(row.page, fileName), row.outline };
    for (const ShownFigure & figure : figures)
    {
      shown.figures.push_back(figureOf(row, figure));
    }
    content.rows.push_back(shown);
  }
  writeGroupPage(fileName, content);
}

} // namespace moserhex::app
