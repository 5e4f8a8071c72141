#include "GroupPage.h"

#include "Histogram.h"
#include "HtmlText.h"
#include "PageFrame.h"
#include "PageName.h"
#include "ReportAssets.h"
#include "ViewerSection.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/Quality/HexQuality.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::ordered_json;
using Outliers = std::vector<std::vector<int>>; ///< by column, then by row

constexpr double      farFromMedian = 3.5;
constexpr double      normalDeviation = 1.4826;
constexpr double      roundOff = 1e-9; ///< of the median: numbers nearer to it are the same
constexpr std::size_t fewestForOutliers = 6;
constexpr std::size_t mostNamed = 12; ///< failed and missing cases in the list of what to look at, and outliers

bool
isDone(const PageRow & row)
{
  return row.status == "done";
}

/** Finite numbers of the rows that are done. */
std::vector<double>
valuesOf(const GroupContent & content, std::size_t column)
{
  std::vector<double> values;
  for (const PageRow & row : content.rows)
  {
    if (isDone(row) && std::isfinite(row.figures[column]))
    {
      values.push_back(row.figures[column]);
    }
  }
  return values;
}

Outliers
allOutliers(const GroupContent & content)
{
  Outliers outliers;
  for (std::size_t column = 0; column < content.columns.size(); ++column)
  {
    outliers.push_back(content.columns[column].hasOutliers ? outliersOf(content, column)
                                                           : std::vector<int>(content.rows.size(), 0));
  }
  return outliers;
}

/** "mesh volume (mL) above the others" */
std::string
reasonsOf(const GroupContent & content, const Outliers & outliers, std::size_t row)
{
  std::string text;
  for (std::size_t column = 0; column < content.columns.size(); ++column)
  {
    if (outliers[column][row] != 0)
    {
      text += (text.empty() ? "" : ", ") + content.columns[column].name +
              (outliers[column][row] > 0 ? " above the others" : " below the others");
    }
  }
  return text;
}

std::string
countsSection(const GroupContent & content)
{
  const auto count = [&content](const std::string & status) {
    return std::to_string(std::count_if(
      content.rows.begin(), content.rows.end(), [&status](const PageRow & row) { return row.status == status; }));
  };
  const auto card = [](const std::string & name, const std::string & value) {
    return "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>\n";
  };
  return "<dl class=\"cards\">\n" + card(content.caseName + "s", std::to_string(content.rows.size())) +
         card("&#10003; Done", count("done")) + card("&#10005; Failed", count("failed")) +
         card("? Missing", count("missing")) + "</dl>\n";
}

/** Entries of the list of what to look at; those above mostNamed are counted only. */
class LookList
{
public:
  LookList(const char * kind, const char * sign) : m_Kind(kind), m_Sign(sign)
  {}

  /** \param page  of the name, empty: none */
  void
  add(const std::string & name, const std::string & page, const std::string & why)
  {
    if (++m_Count <= mostNamed)
    {
      m_Html += "<li class=\"" + m_Kind + "\"><span class=\"sign\" aria-hidden=\"true\">" + m_Sign + "</span>" +
                (name.empty() ? "" : "<strong>" + linked(name, page) + "</strong>: ") + escapeHtml(why) + "</li>\n";
    }
  }

  [[nodiscard]] std::string
  html() const
  {
    const std::string more = m_Count > mostNamed
                               ? "<li class=\"" + m_Kind + "\">and " + std::to_string(m_Count - mostNamed) +
                                   " more: sort and filter the table below</li>\n"
                               : "";
    return m_Html + more;
  }

private:
  static std::string
  linked(const std::string & name, const std::string & page)
  {
    return page.empty() ? escapeHtml(name) : "<a href=\"" + escapeHtml(page) + "\">" + escapeHtml(name) + "</a>";
  }

  std::string m_Kind;
  std::string m_Sign;
  std::string m_Html;
  std::size_t m_Count{ 0 };
};

std::string
lookSection(const GroupContent & content, const Outliers & outliers)
{
  LookList undone("bad", "&#10005;");
  LookList far("caution", "!");
  LookList warnings("caution", "!");
  for (std::size_t row = 0; row < content.rows.size(); ++row)
  {
    const PageRow &   of = content.rows[row];
    const std::string reasons = reasonsOf(content, outliers, row);
    if (!isDone(of))
    {
      undone.add(of.name, of.page, of.status + (of.code.empty() ? "" : " " + of.code) + ", " + of.message);
    }
    else if (!reasons.empty())
    {
      far.add(of.name, of.page, reasons);
    }
  }
  for (const std::string & warning : content.warnings)
  {
    warnings.add("", "", warning);
  }
  const std::string list = undone.html() + far.html() + warnings.html();
  if (list.empty())
  {
    return section("look",
                   "Look at these first",
                   "<p>Nothing stands out: no " + content.caseName +
                     " failed, is missing, or is far from the others in one of its numbers.</p>\n");
  }
  return section(
    "look",
    "Look at these first",
    "<p>Failed and missing ones, then those whose numbers are far from the others' (more than 3.5 robust "
    "standard deviations from the median). Far from the others need not be wrong: look at the segmentation "
    "first.</p>\n<ul class=\"reasons\">\n" +
      list + "</ul>\n");
}

std::string
histogramsSection(const GroupContent & content)
{
  std::string html;
  for (std::size_t column = 0; column < content.columns.size(); ++column)
  {
    CellField field;
    field.id = content.columns[column].id;
    field.name = content.columns[column].name;
    field.values = valuesOf(content, column);
    if (!content.columns[column].hasHistogram || field.values.empty())
    {
      continue;
    }
    const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
    field.shown = { *least, *most };
    html += "<div class=\"measure\"><h3>" + escapeHtml(field.name) + "</h3>\n" + histogramSvg(field) +
            distributionList(field) + "</div>\n";
  }
  return html.empty()
           ? ""
           : section("histograms", "How the numbers are spread", "<div class=\"histograms\">\n" + html + "</div>\n");
}

std::string
tableSection(const GroupContent & content)
{
  return section(
    "table",
    "All " + content.caseName + "s",
    "<div id=\"group-controls\" class=\"group-controls\">\n<div><label for=\"group-search\">Find</label><input "
    "type=\"search\" id=\"group-search\" placeholder=\"name, code or message\" "
    "autocomplete=\"off\"></div>\n<div><label "
    "for=\"group-status\">Status</label><select id=\"group-status\"><option value=\"\">all</option><option "
    "value=\"done\">done</option><option value=\"failed\">failed</option><option value=\"missing\">missing</option>"
    "</select></div>\n<div class=\"check\"><input type=\"checkbox\" id=\"group-outliers\"><label "
    "for=\"group-outliers\">Only those far from the others</label></div>\n<div><label for=\"group-size\">Rows a "
    "page</label><select id=\"group-size\"><option selected>50</option><option>200</option><option "
    "value=\"0\">all</option></select></div>\n</div>\n<p id=\"group-count\" role=\"status\"></p>\n<div "
    "class=\"scroll\" "
    "id=\"group-scroll\" tabindex=\"0\" role=\"group\" aria-label=\"The table\"><p>The table needs JavaScript; the "
    "same "
    "numbers are in the .csv file beside this page.</p></div>\n<div class=\"actions pager\"><button type=\"button\" "
    "id=\"group-previous\">Previous</button><span id=\"group-page\"></span><button type=\"button\" "
    "id=\"group-next\">Next</button></div>\n<p class=\"hint\">&#9650; and &#9660; mark numbers far above and below the "
    "others'. Press a heading to sort.</p>\n");
}

std::string
groupData(const GroupContent & content, const Outliers & outliers)
{
  Json json{ { "caseName", content.caseName }, { "columns", Json::array() }, { "rows", Json::array() } };
  for (const PageColumn & column : content.columns)
  {
    json["columns"].push_back({ { "id", column.id }, { "name", column.name } });
  }
  for (std::size_t row = 0; row < content.rows.size(); ++row)
  {
    const PageRow & of = content.rows[row];
    Json            figures = Json::array();
    Json            marks = Json::array();
    for (std::size_t column = 0; column < content.columns.size(); ++column)
    {
      const double value = of.figures[column];
      figures.push_back(std::isfinite(value) ? Json(value) : Json());
      marks.push_back(outliers[column][row]);
    }
    json["rows"].push_back({ { "name", of.name },
                             { "status", of.status },
                             { "code", of.code },
                             { "message", of.message },
                             { "page", of.page },
                             { "outline", of.outline },
                             { "figures", figures },
                             { "marks", marks } });
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace

std::vector<int>
outliersOf(const GroupContent & content, std::size_t column)
{
  std::vector<int>    marks(content.rows.size(), 0);
  std::vector<double> values = valuesOf(content, column);
  if (values.size() < fewestForOutliers)
  {
    return marks;
  }
  const double median = distributionOf(values).median;
  for (double & value : values)
  {
    value = std::abs(value - median);
  }
  const double limit = farFromMedian * normalDeviation * distributionOf(values).median;
  for (std::size_t row = 0; row < content.rows.size(); ++row)
  {
    const double difference = content.rows[row].figures[column] - median;
    if (isDone(content.rows[row]) && limit > 0.0 && std::abs(difference) > limit &&
        std::abs(difference) > roundOff * std::abs(median))
    {
      marks[row] = difference > 0.0 ? 1 : -1;
    }
  }
  return marks;
}

std::string
groupPage(const GroupContent & content)
{
  requirePagesFor("page");
  const Outliers outliers = allOutliers(content);
  PageFrame      frame;
  frame.heading = content.heading;
  frame.title = shortFileName(content.heading, 50) + " - MoserHex";
  frame.subtitle = content.subtitle;
  frame.body = countsSection(content) + content.introduction + lookSection(content, outliers) + tableSection(content) +
               histogramsSection(content);
  if (content.mesh)
  {
    frame.body += viewerSection(*content.mesh, content.fields);
  }
  frame.body += content.conclusion + dataElement("group-data", groupData(content, outliers));
  frame.script = content.mesh ? reportAssets()->viewerScript : reportAssets()->groupScript;
  frame.footer = "<p>Written by MoserHex " + escapeHtml(content.version) +
                 ". This page needs no network; links lead to files beside it.</p>\n" +
                 (content.mesh ? licenceDetails() : "");
  return pageText(frame);
}

void
writeGroupPage(const std::string & fileName, const GroupContent & content)
{
  writeTextFile(fileName, groupPage(content));
}

} // namespace moserhex::app
