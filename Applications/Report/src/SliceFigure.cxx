#include "SliceFigure.h"

#include "ColourMap.h"
#include "HtmlText.h"

#include <cmath>

namespace moserhex::app
{
namespace
{

/** How a plane is drawn. Along the second coordinate of the axial plane (to the back) pictures go downwards as it does;
 * in the others it goes up, and pictures do not. */
struct View
{
  const char * name;
  const char * left;
  const char * right;
  const char * top;
  const char * bottom;
  bool         isTurned; ///< the second coordinate grows upwards
};

const View &
viewOf(int axis)
{
  static constexpr std::array<View, 3> views{ { { "Sagittal", "A", "P", "S", "I", true },
                                                { "Coronal", "R", "L", "S", "I", true },
                                                { "Axial", "R", "L", "A", "P", false } } };
  return views[static_cast<std::size_t>(axis)];
}

constexpr double linesPerSide = 4000.0; ///< lines are drawn on a grid of so many places along the longer side

/** Colours of labels that are meshed together. */
const char *
labelClass(std::size_t number)
{
  static constexpr std::array<const char *, 4> names{ "label-a", "label-b", "label-c", "label-d" };
  return names[number % names.size()];
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
    svg += pathElement("class=\"shell\" stroke=\"" + colourOf(0.9 * (shell - 1) / (most - 1)) + "\"",
                       linePath(lines, corner, unit));
  }
  const std::string boundary = linePath(cut.boundary, corner, unit);
  return svg + pathElement("class=\"boundary-ground\"", boundary) + pathElement("class=\"boundary\"", boundary);
}

std::string
letter(double x, double y, const char * text)
{
  return "<text x=\"" + shortNumber(x, 5) + "\" y=\"" + shortNumber(y, 5) + "\">" + text + "</text>";
}

/** A tenth to a half of the width, of a round length. */
std::string
scaleBar(double width, double height, double scale)
{
  const double third = width / 3.0;
  const double decade = std::pow(10.0, std::floor(std::log10(third)));
  const double length = decade * (third / decade >= 5.0 ? 5.0 : third / decade >= 2.0 ? 2.0 : 1.0);
  const double y = height * scale - 10.0;
  return "<path class=\"scale\" d=\"M10 " + shortNumber(y, 5) + "h" + shortNumber(length * scale, 5) +
         "\"/><text class=\"scale-text\" x=\"10\" y=\"" + shortNumber(y - 6.0, 5) + "\">" + shortNumber(length) +
         " mm</text>";
}

std::string
figure(const SliceContent & content, const Box & box, const CutPlane & plane, const std::string & id)
{
  const View &            view = viewOf(plane.axis);
  std::vector<LabelValue> values;
  for (const LabelEntry & entry : content.labels)
  {
    values.push_back(entry.value);
  }
  const LabelSlice slice = sliceLabels(*content.image, values, box, plane);
  const double     width = slice.size[0] * slice.step;
  const double     height = slice.size[1] * slice.step;
  const double     scale = 400.0 / std::max(width, height); // pixels a mm
  const auto       group = [&](double unit) {
    const std::string factor = shortNumber(unit * scale, 8);
    return view.isTurned ? "<g transform=\"translate(0 " + shortNumber(height * scale, 8) + ") scale(" + factor + " -" +
                             factor + ")\">"
                               : "<g transform=\"scale(" + factor + ")\">";
  };
  std::string labels;
  for (std::size_t number = 0; number < values.size(); ++number)
  {
    labels += pathElement(std::string("class=\"") + labelClass(number) + "\"", labelPath(slice, values[number]));
  }
  const double      unit = std::max(width, height) / linesPerSide;
  const std::string lines = content.mesh ? meshLines(*content.mesh, plane, slice.corner, unit) : "";
  const std::string size = shortNumber(width * scale, 6) + " " + shortNumber(height * scale, 6);
  const char *      axisName = plane.axis == 0 ? "x" : plane.axis == 1 ? "y" : "z";
  const double      w = width * scale;
  const double      h = height * scale;
  return "<figure><svg class=\"slice\" viewBox=\"0 0 " + size + "\" role=\"img\" aria-labelledby=\"" + id +
         "\"><title id=\"" + id + "\">" + view.name + " slice at " + axisName + " = " + fixedNumber(plane.place, 1) +
         " mm: the label and the lines of the mesh</title>" + group(slice.step) + labels + "</g>" + group(unit) +
         lines + "</g><g class=\"letters\">" + letter(12, h / 2, view.left) + letter(w - 12, h / 2, view.right) +
         letter(w / 2, 18, view.top) + letter(w / 2, h - 8, view.bottom) + "</g>" + scaleBar(width, height, scale) +
         "</svg><figcaption>" + view.name + ", " + axisName + " = " + fixedNumber(plane.place, 1) +
         " mm</figcaption></figure>";
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
    list += item("<path class=\"boundary\" d=\"M0 7h28\"/>", "surface of the mesh") +
            item("<path class=\"shell\" stroke=\"" + colourOf(0.0) + "\" d=\"M0 7h28\"/>", "innermost shell") +
            item("<path class=\"shell\" stroke=\"" + colourOf(0.9) + "\" d=\"M0 7h28\"/>", "outermost shell inside") +
            item("<path class=\"inner\" d=\"M0 7h28\"/>", "other faces of cells");
  }
  return list + "</ul>";
}

} // namespace moserhex::app
