#include "CaseSections.h"

#include "Assessment.h"
#include "HtmlTable.h"
#include "HtmlText.h"
#include "MethodsText.h"
#include "PageFrame.h"

#include <cctype>
#include <map>

namespace moserhex::app
{
namespace
{

/** Class of the colour, and a sign for those who do not see it. */
struct Sign
{
  const char * kind;
  const char * symbol;
  const char * advice;
};

Sign
signOf(Trust trust)
{
  switch (trust)
  {
    case Trust::Trust:
      return { "good",
               "&#10003;",
               "The run reached all that it promises. Look at the slices once, then use the mesh." };
    case Trust::LookAtIt:
      return { "caution", "!", "Read the reasons marked with ! and look at the slices before you use the mesh." };
    case Trust::DoNotUse:
      return { "bad", "&#10005;", "Correct what the reasons marked with &#10005; say and run again." };
  }
  return {};
}

std::string
card(const std::string & name, const std::string & value, const std::string & note)
{
  return "<div><dt>" + name + "</dt><dd>" + value + "</dd><dd class=\"note\">" + note + "</dd></div>\n";
}

std::string
pair(const std::string & name, const std::string & value)
{
  return value.empty() ? "" : "<div><dt>" + name + "</dt><dd>" + escapeHtml(value) + "</dd></div>\n";
}

std::string
vectorText(const Vector3 & v, int decimals)
{
  return fixedNumber(v.x(), decimals) + ", " + fixedNumber(v.y(), decimals) + ", " + fixedNumber(v.z(), decimals);
}

std::string
spacingText(const Vector3 & v)
{
  return shortNumber(v.x(), 4) + " x " + shortNumber(v.y(), 4) + " x " + shortNumber(v.z(), 4) + " mm";
}

std::string
labelsText(const RunReport::Input & input)
{
  std::string text;
  for (const std::int64_t label : input.labels)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(label);
  }
  return text + (input.labelName.empty() ? "" : " (" + input.labelName + ")");
}

std::string
roleText(const std::string & role)
{
  static const std::map<std::string, std::string> texts{
    { "mesh", "Template" },       { "transform", "Transform of the template" },
    { "landmarks", "Landmarks" }, { "template_landmarks", "Landmarks of the template" },
    { "image", "Image" },         { "template_image", "Image of the template" }
  };
  return texts.at(role);
}

std::string
withSmallBeginning(std::string text)
{
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  return text;
}

std::string
alignmentText(const RunReport::Template & tied)
{
  if (tied.alignment == "none")
  {
    return "It was taken as it lies, in one space with the label.";
  }
  if (!tied.aligned)
  {
    return "It was brought to the label by a transform from a file.";
  }
  return std::string("It was brought to the label by ") +
         (tied.alignment == "affine" ? "an affine map" : "a rigid motion") + " of the surfaces: turned by " +
         fixedNumber(tied.aligned->angle, 1) + " degrees and moved by " + fixedNumber(tied.aligned->translation, 1) +
         " mm.";
}

/** How the template's mesh became the label's. */
std::string
startText(const RunReport::Template & tied)
{
  std::string text =
    tied.placed ? " It was made " + shortNumber(tied.placed->scale) + " times as large, to the label's volume." : "";
  if (tied.start == "own")
  {
    text += " No exact mesh came of bending it: the label's own mesh was drawn to it instead.";
  }
  return text;
}

/** What a residual does and does not say. */
std::string
templateAdvice(const RunReport::Template & tied)
{
  std::string text = "What is left of the surfaces' distance is the difference in shape, which the mesh follows.";
  if (!tied.landmarks && !tied.imageDifference)
  {
    return text + " Inside, surface and equal volumes alone do not show where tissue went; landmarks or images would.";
  }
  if (tied.landmarks)
  {
    text += " What is left of the landmarks' distance should not be much more than the error of placing them.";
  }
  if (tied.imageDifference)
  {
    text += " The images' difference is 0 where both show the same at the same nodes.";
  }
  if (tied.growth)
  {
    text += " Cells were free to grow as these show, by " + shortNumber(tied.growth->smallest, 2) + " to " +
            shortNumber(tied.growth->largest, 2) + " times as much as the organ: moserhex compare shows where.";
  }
  return text;
}

} // namespace

std::string
trustSection(const RunReport & report)
{
  const Assessment assessment = assess(report);
  const Sign       sign = signOf(assessment.trust);
  std::string      reasons;
  for (const Assessment::Reason & reason : assessment.reasons)
  {
    const Sign of = signOf(reason.trust);
    reasons += std::string("<li class=\"") + of.kind + "\"><span class=\"sign\" aria-hidden=\"true\">" + of.symbol +
               "</span><span class=\"visually-hidden\">" + nameOf(reason.trust) + ": </span>" +
               escapeHtml(reason.text) + "</li>\n";
  }
  return std::string("<section id=\"trust\" class=\"trust ") + sign.kind +
         "\" aria-labelledby=\"trust-heading\">\n<h2 id=\"trust-heading\"><span class=\"light\" aria-hidden=\"true\">" +
         sign.symbol + "</span>" + nameOf(assessment.trust) + "</h2>\n<p>" + sign.advice +
         "</p>\n<ul class=\"reasons\">\n" + reasons + "</ul>\n</section>\n";
}

std::string
keyFigures(const RunReport & report)
{
  if (report.failure)
  {
    return "";
  }
  std::string cards = card("Volume of the mesh",
                           fixedNumber(report.mesh.volume / 1000.0, 2) + " mL",
                           "label: " + fixedNumber(report.input.volume / 1000.0, 2) + " mL") +
                      card("Cells", std::to_string(report.mesh.cells), std::to_string(report.mesh.nodes) + " nodes");
  if (report.exact)
  {
    cards += card(std::string("Variance of the ") + equalMeasureOf(report).plural,
                  shortNumber(report.exact->variance, 2),
                  report.exact->certified ? "every cell certified" : "cells not certified");
  }
  for (auto stage = report.stages.rbegin(); stage != report.stages.rend(); ++stage)
  {
    if (stage->quality)
    {
      cards += card("Scaled Jacobian",
                    fixedNumber(stage->quality->scaledJacobianMedian, 3),
                    "median; smallest " + fixedNumber(stage->quality->scaledJacobianMinimum, 3));
      break;
    }
  }
  if (report.conditioning)
  {
    cards += card("Dice", fixedNumber(report.conditioning->dice, 4), "smoothed solid and label");
  }
  if (report.surface)
  {
    cards += card("Surface within",
                  fixedNumber(report.surface->maximum, 2) + " mm",
                  "root mean square " + fixedNumber(report.surface->rms, 2) + " mm");
  }
  return "<dl class=\"cards\">\n" + cards + "</dl>\n";
}

std::string
stageSection(const RunReport & report)
{
  if (report.stages.empty())
  {
    return "";
  }
  std::vector<std::string> columns{
    "Stage",      "Volume variance", "Concave cells (%)", "Scaled Jacobian, smallest", "Scaled Jacobian, median",
    "What it did"
  };
  if (!report.reproducible)
  {
    columns.insert(columns.begin() + 1, "Seconds");
  }
  std::vector<std::vector<std::string>> rows;
  for (const StageRecord & stage : report.stages)
  {
    std::vector<std::string> cells{ escapeHtml(stage.name) };
    if (!report.reproducible)
    {
      cells.push_back(fixedNumber(stage.seconds, 2));
    }
    if (stage.quality)
    {
      cells.insert(cells.end(),
                   { shortNumber(stage.quality->volumeVariance),
                     fixedNumber(stage.quality->concavePercent, 2),
                     fixedNumber(stage.quality->scaledJacobianMinimum, 3),
                     fixedNumber(stage.quality->scaledJacobianMedian, 3) });
    }
    else
    {
      cells.insert(cells.end(), 4, "&ndash;");
    }
    cells.push_back(escapeHtml(stage.note));
    rows.push_back(cells);
  }
  return section("stages", "Stage by stage", tableText("Stages of the run, in their order", columns, rows));
}

std::string
repairSection(const RunReport & report)
{
  if (!report.conditioning)
  {
    return "";
  }
  const RunReport::Conditioning & conditioning = *report.conditioning;
  std::string                     text = "<p>The label had " + std::to_string(conditioning.components) + " component" +
                     (conditioning.components == 1 ? "" : "s") + ", " + std::to_string(conditioning.cavities) +
                     " cavities and " + std::to_string(conditioning.handles) +
                     " handles; a mesh needs one component without any. ";
  if (conditioning.changes.empty())
  {
    return section("repair", "Repair of the label", text + "Nothing was changed.</p>\n");
  }
  text += std::to_string(conditioning.voxelsAdded) + " voxels were added and " +
          std::to_string(conditioning.voxelsRemoved) + " removed, " + shortNumber(conditioning.changedPercent, 2) +
          " % of the label. The places are in the image's own millimetres (LPS): look there in your viewer, and "
          "correct the segmentation where the repair guessed wrong.</p>\n";
  std::vector<std::vector<std::string>> rows;
  for (const TopologyChange & change : conditioning.changes)
  {
    rows.push_back({ std::to_string(rows.size() + 1),
                     escapeHtml(nameOf(change.kind)),
                     std::to_string(change.voxels),
                     shortNumber(static_cast<double>(change.voxels) * conditioning.voxelVolume),
                     vectorText(change.centre, 1) });
  }
  return section("repair",
                 "Repair of the label",
                 text + tableText("Changes to the label, in the order they were made",
                                  { "No.", "Kind", "Voxels", "Volume (mm&sup3;)", "Centre, LPS (mm)" },
                                  rows));
}

std::string
templateSection(const RunReport & report)
{
  if (!report.templateMesh || report.failure)
  {
    return "";
  }
  const RunReport::Template &           tied = *report.templateMesh;
  std::vector<std::vector<std::string>> rows;
  if (tied.placed)
  {
    rows.push_back({ "Surfaces, root mean square (mm)",
                     tied.aligned ? shortNumber(tied.aligned->rmsBefore) : "&ndash;",
                     shortNumber(tied.placed->rms) });
    rows.push_back({ "Surfaces, median (mm)", "&ndash;", shortNumber(tied.placed->median) });
  }
  if (tied.landmarks)
  {
    rows.push_back(
      { "Landmarks, root mean square (mm)", shortNumber(tied.landmarks->before), shortNumber(tied.landmarks->after) });
  }
  if (tied.imageDifference)
  {
    rows.push_back({ "Images, root mean square (standard deviations)",
                     shortNumber(tied.imageDifference->before),
                     shortNumber(tied.imageDifference->after) });
  }
  return section("template",
                 "Tied to a template",
                 "<p>Node (i,j,k) of this mesh is meant to be the same place as node (i,j,k) of <strong>" +
                   escapeHtml(shortFileName(tied.files.front().name)) + "</strong>. " + alignmentText(tied) +
                   startText(tied) + "</p>\n" +
                   (rows.empty() ? "" : tableText("How far the two are apart", { "Of", "Before", "After" }, rows)) +
                   "<p>" + templateAdvice(tied) + "</p>\n");
}

std::string
methodsSection(const RunReport & report)
{
  if (report.failure)
  {
    return "";
  }
  const MethodsText methods = methodsText(report);
  std::string       references;
  for (const std::string & reference : methods.references)
  {
    references += "<li>" + escapeHtml(reference) + "</li>\n";
  }
  return section("methods",
                 "For your methods section",
                 "<div id=\"methods-text\"><p>" + escapeHtml(methods.paragraph) + "</p>\n<ol class=\"references\">\n" +
                   references +
                   "</ol></div>\n<p class=\"actions\"><button type=\"button\" id=\"copy-methods\">Copy text and "
                   "references</button> <span id=\"copy-state\" role=\"status\"></span></p>\n");
}

std::string
provenanceSection(const RunReport & report)
{
  const RunReport::Parameters & parameters = report.parameters;
  const RunReport::Input &      input = report.input;
  std::string                   list = pair("Input", input.file) + pair("SHA-256 of the input", input.sha256) +
                     pair(input.labels.size() > 1 ? "Labels" : "Label", labelsText(input));
  if (!input.labels.empty())
  {
    list += pair("Voxels", std::to_string(input.voxels) + " of " + spacingText(input.spacing));
  }
  list += pair("Mesh", report.mesh.file) + pair("Shells", std::to_string(parameters.shells)) +
          pair("Layers of padding", std::to_string(parameters.padding)) + pair("Last stage", parameters.stage) +
          pair("Way", parameters.way) + pair("Method for the shells", parameters.shellMethod) +
          pair("Frame", parameters.frame) +
          pair("Topology", parameters.topology + ", at most " + shortNumber(parameters.maximumRepair) + " %");
  if (parameters.threshold)
  {
    list += pair("Threshold", shortNumber(*parameters.threshold, 6));
  }
  if (parameters.segment)
  {
    list += pair("Segment", *parameters.segment);
  }
  if (report.density)
  {
    list += pair("Density", report.density->file) + pair("SHA-256 of the density", report.density->sha256);
  }
  if (report.templateMesh)
  {
    for (const RunReport::File & file : report.templateMesh->files)
    {
      const std::string role = roleText(file.role);
      list += pair(role, file.name) + pair("SHA-256 of the " + withSmallBeginning(role), file.sha256);
    }
  }
  list += pair("MoserHex", report.versions.moserhex + " (" + report.versions.git + ")") +
          pair("Libraries",
               "ITK " + report.versions.itk + ", VTK " + report.versions.vtk + ", Eigen " + report.versions.eigen);
  if (!report.reproducible)
  {
    list += pair("Threads", std::to_string(report.threads)) + pair("Seconds", fixedNumber(report.seconds, 1)) +
            (report.peakMemory ? pair("Peak memory", fixedNumber(*report.peakMemory, 0) + " MiB") : "");
  }
  return section("provenance",
                 "Files, options and versions",
                 "<dl class=\"pairs\">\n" + list +
                   "</dl>\n<p class=\"actions\"><button type=\"button\" id=\"download-report\">Download the report as "
                   "JSON</button></p>\n");
}

} // namespace moserhex::app
