#include "AtlasPage.h"

#include "GroupPage.h"
#include "HtmlText.h"
#include "PageFrame.h"
#include "Version.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr Eigen::Index mostModes = 6; ///< columns of the table

constexpr double level = 0.05; ///< at which nodes are counted

std::string
tableOf(const std::string &                           caption,
        const std::vector<std::string> &              columns,
        const std::vector<std::vector<std::string>> & rows)
{
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"" + caption +
                     "\"><table><caption>" + caption + "</caption><thead><tr>";
  for (const std::string & column : columns)
  {
    html += "<th scope=\"col\">" + column + "</th>";
  }
  html += "</tr></thead><tbody>\n";
  for (const std::vector<std::string> & row : rows)
  {
    html += "<tr>";
    for (std::size_t cell = 0; cell < row.size(); ++cell)
    {
      html += cell == 0 ? "<th scope=\"row\">" + row[cell] + "</th>" : "<td>" + row[cell] + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string
modelSection(const AtlasResult & result)
{
  const ShapeModel &                    shape = result.model.shape;
  std::vector<std::vector<std::string>> rows;
  double                                held = 0.0;
  for (Eigen::Index mode = 0; mode < shape.variances.size(); ++mode)
  {
    const auto place = static_cast<std::size_t>(mode);
    held += shape.variances[mode];
    std::vector<std::string> row{ std::to_string(mode + 1),
                                  fixedNumber(100.0 * shape.variances[mode] / shape.totalVariance, 1),
                                  fixedNumber(100.0 * held / shape.totalVariance, 1) };
    const bool               isKnown = place < result.quality.generalisation.size();
    row.push_back(isKnown ? shortNumber(result.quality.generalisation[place]) : "&ndash;");
    row.push_back(isKnown ? shortNumber(result.quality.specificity[place]) : "&ndash;");
    rows.push_back(row);
  }
  return section("model",
                 "Modes of variation",
                 "<p>The mean has " + fixedNumber(result.mean.volume / 1000.0, 2) + " mL; " +
                   (result.mean.exact ? "all its cells have the same volume and are certified." : "it is NOT exact.") +
                   " Subjects lie " + shortNumber(result.alignment.deviation) +
                   " mm from it (root mean square over the nodes).</p>\n" +
                   tableOf("Modes, the first holds most of the variance",
                           { "Mode", "Variance (%)", "Together (%)", "Generalisation (mm)", "Specificity (mm)" },
                           rows));
}

std::string
testsSection(const AtlasResult & result)
{
  std::vector<std::vector<std::string>> rows;
  for (const AtlasTest & test : result.tests)
  {
    const std::string what =
      test.groups.empty() ? test.column : test.column + ": " + test.groups[1] + " against " + test.groups[0];
    rows.push_back({ escapeHtml(what),
                     std::to_string(test.subjects.size()),
                     std::to_string(test.result.permutations),
                     shortNumber(test.result.pFamilyWise.minCoeff()),
                     std::to_string((test.result.pFamilyWise.array() <= level).count()),
                     std::to_string((test.result.qFalseDiscovery.array() <= level).count()) });
  }
  return rows.empty() ? ""
                      : section("tests",
                                "Tests at every node",
                                tableOf("Report the family-wise p",
                                        { "Test",
                                          "Subjects",
                                          "Permutations",
                                          "Smallest p, family-wise",
                                          "Nodes at 0.05, family-wise",
                                          "Nodes at 0.05, false discovery" },
                                        rows));
}

/** The mean over a cell's nodes of the subjects' standard deviation there. */
CellField
deviationField(const AtlasResult & result)
{
  CellField field;
  field.id = "deviation";
  field.name = "Standard deviation (mm)";
  for (std::size_t cell = 0; cell < result.mean.mesh.cellCount(); ++cell)
  {
    double sum = 0.0;
    for (const std::size_t node : result.mean.mesh.cellNodes(cell))
    {
      sum += std::sqrt(result.covariances[node].trace());
    }
    field.values.push_back(sum / 8.0);
  }
  field.shown = { 0.0, *std::max_element(field.values.begin(), field.values.end()) };
  return field;
}

} // namespace

void
writeAtlasPage(const std::string & fileName, const AtlasResult & result)
{
  const Eigen::Index modes = std::min(mostModes, result.scores.cols());
  GroupContent       content;
  content.heading = "Atlas of " + std::to_string(result.subjects.subjects.size()) + " subjects";
  content.subtitle = "Mean, modes and tests over meshes with one lattice";
  content.caseName = "subject";
  content.version = version;
  content.warnings = result.warnings;
  content.introduction = modelSection(result) + testsSection(result);
  content.columns = { { "volume", "volume (mL)", true, true },
                      { "size", "size (mm)", false, true },
                      { "distance", "distance to the mean (mm)", true, true } };
  for (Eigen::Index mode = 0; mode < modes; ++mode)
  {
    const std::string number = std::to_string(mode + 1);
    content.columns.push_back({ "mode-" + number, "mode " + number + " (sd)", mode == 0, true });
  }
  for (std::size_t i = 0; i < result.subjects.subjects.size(); ++i)
  {
    PageRow row{ result.subjects.subjects[i].name, "done", "", "", {}, "", result.figures[i].outline };
    row.figures = { result.figures[i].volume / 1000.0, result.figures[i].centroidSize, result.distances[i] };
    for (Eigen::Index mode = 0; mode < modes; ++mode)
    {
      row.figures.push_back(result.scores(static_cast<Eigen::Index>(i), mode));
    }
    content.rows.push_back(row);
  }
  content.mesh = &result.mean.mesh;
  content.fields = cellFieldsOf(result.mean.mesh, {});
  content.fields.push_back(deviationField(result));
  writeGroupPage(fileName, content);
}

} // namespace moserhex::app
