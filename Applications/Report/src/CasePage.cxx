#include "CasePage.h"

#include "CaseSections.h"
#include "Histogram.h"
#include "HtmlText.h"
#include "MeshData.h"
#include "PageFrame.h"
#include "PageName.h"
#include "ReportAssets.h"
#include "SliceFigure.h"
#include "ViewerSection.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

namespace moserhex::app
{
namespace
{

std::string
slicesSection(const CaseContent & content)
{
  if (!content.image || content.labels.empty())
  {
    return "";
  }
  const SliceContent slices{ content.image, content.labels, content.mesh };
  const std::string  figures = sliceFigures(slices);
  return figures.empty()
           ? ""
           : section(
               "slices",
               "Slices",
               "<p>The outline of the mesh should follow the filled label within about a voxel everywhere. Corners "
               "of the label that are cut and gaps that are filled come from smoothing.</p>\n" +
                 sliceLegend(slices) + "<div class=\"slices\">" + figures + "</div>\n");
}

std::string
qualitySection(const std::vector<CellField> & fields)
{
  std::string html = "<p>The shaded ranges are those that CUBIT calls acceptable; bars outside of them are "
                     "hatched.</p>\n<div class=\"histograms\">\n";
  for (const CellField & field : fields)
  {
    if (!field.isWhole)
    {
      html += "<div class=\"measure\"><h3>" + field.name + "</h3>\n<p>" + field.meaning + "</p>\n" +
              histogramSvg(field) + distributionList(field) + "</div>\n";
    }
  }
  return section("quality", "Quality of the cells", html + "</div>\n");
}

std::string
bodyOf(const CaseContent & content)
{
  const RunReport & report = content.report;
  std::string       body = trustSection(report) + keyFigures(report) + slicesSection(content);
  if (content.mesh)
  {
    const std::vector<CellField> fields = cellFieldsOf(*content.mesh, content.labelOfCells);
    body += viewerSection(*content.mesh, fields) + qualitySection(fields);
  }
  return body + stageSection(report) + repairSection(report) + templateSection(report) + methodsSection(report) +
         provenanceSection(report) + dataElement("report-data", toJson(report));
}

std::string
subtitleOf(const CaseContent & content)
{
  if (content.report.failure)
  {
    return "No mesh was made";
  }
  return "Structured hexahedral mesh of " + std::to_string(content.report.mesh.nodes) + " nodes, in " +
         shortFileName(content.report.mesh.file);
}

} // namespace

std::string
casePage(const CaseContent & content)
{
  requirePagesFor("page");
  PageFrame frame;
  frame.heading = shortFileName(content.report.input.file, 80);
  frame.title = shortFileName(content.report.input.file, 40) + " - MoserHex report";
  frame.subtitle = subtitleOf(content);
  frame.body = bodyOf(content);
  frame.script = reportAssets()->viewerScript;
  frame.footer = "<p>Written by MoserHex " + escapeHtml(content.report.versions.moserhex) +
                 ". This page needs no other file and no network.</p>\n" + licenceDetails();
  return pageText(frame);
}

void
writeCasePage(const std::string & fileName, const CaseContent & content)
{
  writeTextFile(fileName, casePage(content));
}

} // namespace moserhex::app
