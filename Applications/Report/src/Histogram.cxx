#include "Histogram.h"

#include "HtmlText.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr int    classes = 40;
constexpr double width = 360.0;
constexpr double height = 150.0; ///< of the bars
constexpr double top = 22.0;     ///< room for the name of the acceptable range
constexpr double bottom = 26.0;  ///< room for the numbers
constexpr double side = 14.0;

/** A mean that is less than this part of the largest number is 0 but for rounding. */
constexpr double roundOff = 1e-12;

std::string
attribute(const std::string & name, double value)
{
  return " " + name + "=\"" + shortNumber(value, 5) + "\"";
}

std::string
rectangle(const std::string & kind, double x, double y, double w, double h)
{
  return "<rect class=\"" + kind + "\"" + attribute("x", x) + attribute("y", y) + attribute("width", w) +
         attribute("height", h) + "/>";
}

std::string
textAt(double x, double y, const std::string & anchor, const std::string & text)
{
  return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"" + anchor + "\">" + escapeHtml(text) +
         "</text>";
}

std::vector<std::size_t>
countsOf(const CellField & field, const CellField::Range & range)
{
  std::vector<std::size_t> counts(classes, 0);
  for (const double value : field.values)
  {
    const double part = (value - range.low) / (range.high - range.low);
    ++counts[static_cast<std::size_t>(std::clamp(std::floor(part * classes), 0.0, classes - 1.0))];
  }
  return counts;
}

/** A mark with its number about every fifth of the axis, at round numbers. */
std::string
axisSvg(const CellField::Range & range)
{
  const double span = range.high - range.low;
  const double decade = std::pow(10.0, std::floor(std::log10(span / 5.0)));
  const double parts = span / 5.0 / decade;
  const double step = decade * (parts < 1.5 ? 1.0 : parts < 3.5 ? 2.0 : parts < 7.5 ? 5.0 : 10.0);
  const double floorY = top + height;
  std::string  svg = "<line class=\"axis\"" + attribute("x1", side) + attribute("x2", width - side) +
                    attribute("y1", floorY) + attribute("y2", floorY) + "/>";
  const double first = std::ceil(range.low / step);
  const int    marks = static_cast<int>(std::floor((range.high + 1e-9 * span) / step - first)) + 1;
  for (int mark = 0; mark < marks; ++mark)
  {
    const double value = (first + mark) * step;
    const double x = side + (value - range.low) / span * (width - 2.0 * side);
    svg += "<line class=\"axis\"" + attribute("x1", x) + attribute("x2", x) + attribute("y1", floorY) +
           attribute("y2", floorY + 4.0) + "/>" + textAt(x, floorY + 17.0, "middle", shortNumber(value + 0.0, 4));
  }
  return svg;
}

std::string
percentText(double part)
{
  const bool nearlyAll = part < 1.0 && part > 0.9999;
  return nearlyAll ? "more than 99.99 %" : shortNumber(100.0 * part, part < 0.1 ? 3 : 4) + " %";
}

} // namespace

std::string
histogramSvg(const CellField & field)
{
  const CellField::Range         range = rangeOf(field);
  const std::vector<std::size_t> counts = countsOf(field, range);
  const double                   most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  const auto                     placeOf = [&range](double value) {
    return side +
           (std::clamp(value, range.low, range.high) - range.low) / (range.high - range.low) * (width - 2 * side);
  };
  const std::string titleId = "histogram-" + field.id;
  const std::string hatchId = "hatch-" + field.id;
  std::string       svg = "<svg class=\"histogram\" viewBox=\"0 0 " + shortNumber(width, 5) + " " +
                    shortNumber(top + height + bottom, 5) + "\" role=\"img\" aria-labelledby=\"" + titleId +
                    "\"><title id=\"" + titleId + "\">Histogram of the " + escapeHtml(field.name) +
                    "; the numbers are beside it</title><defs><pattern id=\"" + hatchId +
                    "\" width=\"4\" height=\"4\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect "
                    "class=\"hatch-ground\" width=\"4\" height=\"4\"/><rect class=\"hatch-line\" width=\"1.6\" "
                    "height=\"4\"/></pattern></defs>";
  if (field.acceptable)
  {
    const double low = placeOf(field.acceptable->low);
    const double high = placeOf(field.acceptable->high);
    svg += rectangle("acceptable", low, top - 18.0, high - low, height + 18.0) +
           textAt((low + high) / 2.0,
                  top - 5.0,
                  "middle",
                  "acceptable " + shortNumber(field.acceptable->low) + " to " + shortNumber(field.acceptable->high));
  }
  const double step = (range.high - range.low) / classes;
  for (int c = 0; c < classes; ++c)
  {
    const std::size_t count = counts[static_cast<std::size_t>(c)];
    if (count == 0)
    {
      continue;
    }
    const double middle = range.low + (c + 0.5) * step;
    const double barHeight = std::max(height * static_cast<double>(count) / most, 1.0);
    const bool   isOutside = field.acceptable && (middle < field.acceptable->low || middle > field.acceptable->high);
    const std::string bar = rectangle(isOutside ? "bar outside" : "bar",
                                      placeOf(middle - step / 2) + 0.5,
                                      top + height - barHeight,
                                      (width - 2 * side) / classes - 1.0,
                                      barHeight);
    svg += isOutside ? bar.substr(0, bar.size() - 2) + " fill=\"url(#" + hatchId + ")\"/>" : bar;
  }
  return svg + axisSvg(range) + "</svg>";
}

std::string
distributionList(const CellField & field)
{
  const Distribution all = distributionOf(field.values);
  const double       rounding = roundOff * std::max(std::abs(all.minimum), std::abs(all.maximum));
  const auto         row = [](const std::string & name, const std::string & value) {
    return "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>";
  };
  std::string list = "<dl class=\"figures\">" + row("smallest", shortNumber(all.minimum)) +
                     row("5 %", shortNumber(all.p05)) + row("median", shortNumber(all.median)) +
                     row("mean", shortNumber(std::abs(all.mean) < rounding ? 0.0 : all.mean)) +
                     row("95 %", shortNumber(all.p95)) + row("largest", shortNumber(all.maximum));
  if (field.acceptable)
  {
    list += row("acceptable", percentText(acceptablePart(field)) + " of the cells");
  }
  return list + "</dl>";
}

} // namespace moserhex::app
