#include "SliceFigure.h"

#include "ColourScale.h"
#include "HtmlText.h"
#include "SliceFrame.h"

#include <array>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr double linesPerSide = 4000.0; ///< lines are drawn on a grid of so many places along the longer side

/** Colours of labels that are meshed together. */
const char *
labelClass(std::size_t number)
{
  static constexpr std::array<const char *, 4> names{ "label-a", "label-b", "label-c", "label-d" };
  return names[number % names.size()];
}

/** \param part  from the innermost shell to the outermost; its yellow end is too light for lines on white */
std::string
shellColour(double part)
{
  return cssColour(sequentialScale().at(0.9 * part));
}

/** Squares of a label, row by row, as a path in squares. */
std::string
labelPath(const LabelSlice & slice, LabelValue value)
{
  std::string path;
  for (int b = 0; b < slice.size[1]; ++b)
  {
    for (int a = 0; a < slice.size[0];)
    {
      int end = a;
      while (end < slice.size[0] && slice.at(end, b) == value)
      {
        ++end;
      }
      if (end > a)
      {
        const std::string length = std::to_string(end - a);
        path += "M" + std::to_string(a) + " " + std::to_string(b) + "h" + length + "v1h-" + length + "z";
      }
      a = std::max(end, a + 1);
    }
  }
  return path;
}

/** Lines as a path in whole units. */
std::string
linePath(const std::vector<PlaneLine> & lines, const PlanePoint & corner, double unit)
{
  std::string path;
  for (const PlaneLine & line : lines)
  {
    long x = 0;
    long y = 0;
    char command = 'M';
    for (const PlanePoint & point : line)
    {
      const long nextX = std::lround((point[0] - corner[0]) / unit);
      const long nextY = std::lround((point[1] - corner[1]) / unit);
      if (command == 'l' && nextX == x && nextY == y)
      {
        continue;
      }
      const std::string dy = std::to_string(nextY - y);
      path += command + std::to_string(nextX - x) + (dy.front() == '-' ? "" : " ") + dy;
      x = nextX;
      y = nextY;
      command = 'l';
    }
  }
  return path;
}

std::string
pathElement(const std::string & attributes, const std::string & data)
{
  return data.empty() ? "" : "<path " + attributes + " d=\"" + data + "\"/>";
}

std::string
meshLines(const HexMesh & mesh, const CutPlane & plane, const PlanePoint & corner, double unit)
{
  const MeshCut cut = cutMesh(mesh, plane);
  std::string   svg = pathElement("class=\"inner\"", linePath(cut.inner, corner, unit));
  const double  most = cut.shells.empty() ? 1.0 : std::max(cut.shells.rbegin()->first, 2);
  for (const auto & [shell, lines] : cut.shells)
  {
    svg += pathElement("class=\"shell\" stroke=\"" + shellColour((shell - 1) / (most - 1)) + "\"",
                       linePath(lines, corner, unit));
  }
  const std::string boundary = linePath(cut.boundary, corner, unit);
  return svg + pathElement("class=\"boundary-ground\"", boundary) + pathElement("class=\"boundary\"", boundary);
}

std::string
figure(const SliceContent & content, const Box & box, const CutPlane & plane, const std::string & id)
{
  std::vector<LabelValue> values;
  for (const LabelEntry & entry : content.labels)
  {
    values.push_back(entry.value);
  }
  const LabelSlice slice = sliceLabels(*content.image, values, box, plane);
  const SliceFrame frame{ plane.axis, plane.place, slice.size[0] * slice.step, slice.size[1] * slice.step };
  const auto       group = [&frame](double unit) {
    const std::string factor = shortNumber(unit * frame.scale(), 8);
    return frame.isTurned() ? "<g transform=\"translate(0 " + shortNumber(frame.height * frame.scale(), 8) +
                                ") scale(" + factor + " -" + factor + ")\">"
                                  : "<g transform=\"scale(" + factor + ")\">";
  };
  std::string labels;
  for (std::size_t number = 0; number < values.size(); ++number)
  {
    labels += pathElement(std::string("class=\"") + labelClass(number) + "\"", labelPath(slice, values[number]));
  }
  const double      unit = std::max(frame.width, frame.height) / linesPerSide;
  const std::string lines = content.mesh ? meshLines(*content.mesh, plane, slice.corner, unit) : "";
  return framedSlice(frame,
                     group(slice.step) + labels + "</g>" + group(unit) + lines + "</g>",
                     "the label and the lines of the mesh",
                     id);
}

} // namespace

std::string
sliceFigures(const SliceContent & content)
{
  std::vector<LabelValue> values;
  for (const LabelEntry & entry : content.labels)
  {
    values.push_back(entry.value);
  }
  const std::optional<Box> label = boxOfLabels(*content.image, values);
  if (!label)
  {
    return "";
  }
  Box shown = *label;
  if (content.mesh)
  {
    for (const Vector3 & node : content.mesh->nodes)
    {
      shown.low = shown.low.cwiseMin(node);
      shown.high = shown.high.cwiseMax(node);
    }
  }
  const Vector3 margin = Vector3::Constant(0.07 * (shown.high - shown.low).maxCoeff());
  shown.low -= margin;
  shown.high += margin;
  std::string html;
  for (const int axis : { 2, 1, 0 })
  {
    for (const double part : { 0.25, 0.5, 0.75 })
    {
      const double place = (1.0 - part) * label->low[axis] + part * label->high[axis];
      html += figure(content,
                     shown,
                     { axis, place },
                     "slice-" + std::to_string(axis) + "-" + std::to_string(static_cast<int>(100.0 * part)));
    }
  }
  return html;
}

std::string
sliceLegend(const SliceContent & content)
{
  const auto item = [](const std::string & swatch, const std::string & text) {
    return "<li><svg class=\"swatch\" viewBox=\"0 0 28 14\" aria-hidden=\"true\">" + swatch + "</svg>" + text + "</li>";
  };
  std::string list = "<ul class=\"legend\">";
  for (std::size_t number = 0; number < content.labels.size(); ++number)
  {
    const LabelEntry & entry = content.labels[number];
    list += item(std::string("<rect class=\"") + labelClass(number) + "\" width=\"28\" height=\"14\"/>",
                 "label " + std::to_string(entry.value) + (entry.name.empty() ? "" : " " + escapeHtml(entry.name)) +
                   ", as in the file");
  }
  if (content.mesh)
  {
    list +=
      item("<path class=\"boundary\" d=\"M0 7h28\"/>", "surface of the mesh") +
      item("<path class=\"shell\" stroke=\"" + shellColour(0.0) + "\" d=\"M0 7h28\"/>", "innermost shell") +
      item("<path class=\"shell\" stroke=\"" + shellColour(1.0) + "\" d=\"M0 7h28\"/>", "outermost shell inside") +
      item("<path class=\"inner\" d=\"M0 7h28\"/>", "other faces of cells");
  }
  return list + "</ul>";
}

} // namespace moserhex::app
