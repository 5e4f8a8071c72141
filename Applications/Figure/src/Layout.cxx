#include "Layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex::app
{
namespace
{

struct Box
{
  Point2 lower{ Point2::Constant(std::numeric_limits<double>::max()) };
  Point2 upper{ Point2::Constant(std::numeric_limits<double>::lowest()) };

  [[nodiscard]] Point2
  size() const
  {
    return upper - lower;
  }
};

Box
boxOf(const Panel & panel)
{
  Box box;
  for (const SeenFacet & facet : panel.facets)
  {
    for (const Point2 & corner : facet.outline)
    {
      box.lower = box.lower.cwiseMin(corner);
      box.upper = box.upper.cwiseMax(corner);
    }
  }
  return box;
}

/** Panels first to end - 1, side by side. */
struct Row
{
  std::size_t first;
  std::size_t end;
  double      width{ 0.0 };  ///< of all panels [mm]
  double      height{ 0.0 }; ///< of the highest one [mm]
};

std::vector<Row>
rowsOf(const std::vector<Box> & boxes, std::size_t perRow)
{
  std::vector<Row> rows;
  for (std::size_t first = 0; first < boxes.size(); first += perRow)
  {
    Row row{ first, std::min(first + perRow, boxes.size()) };
    for (std::size_t panel = row.first; panel < row.end; ++panel)
    {
      row.width += boxes[panel].size()[0];
      row.height = std::max(row.height, boxes[panel].size()[1]);
    }
    rows.push_back(row);
  }
  return rows;
}

double
scaleOf(const std::vector<Row> & rows, const Rectangle & area, double captionHeight, double gap)
{
  double height = 0.0;
  double scale = std::numeric_limits<double>::max();
  for (const Row & row : rows)
  {
    const double gaps = gap * static_cast<double>(row.end - row.first - 1);
    scale = std::min(scale, (area.width - gaps) / row.width);
    height += row.height;
  }
  const auto   count = static_cast<double>(rows.size());
  const double room = area.height - count * captionHeight - (count - 1.0) * gap;
  return std::max(std::min(scale, room / height), 0.0);
}

} // namespace

Arrangement
arrange(const std::vector<Panel> & panels, const Rectangle & area, double captionHeight, double gap)
{
  std::vector<Box> boxes;
  std::transform(panels.begin(), panels.end(), std::back_inserter(boxes), boxOf);
  std::vector<Row> rows;
  Arrangement      arrangement;
  arrangement.scale = -1.0;
  for (std::size_t perRow = boxes.size(); perRow > 0; --perRow)
  {
    const std::vector<Row> tried = rowsOf(boxes, perRow);
    const double           scale = scaleOf(tried, area, captionHeight, gap);
    if (scale > arrangement.scale)
    {
      arrangement.scale = scale;
      rows = tried;
    }
  }
  const double scale = arrangement.scale;
  double       used = -gap;
  for (const Row & row : rows)
  {
    used += scale * row.height + captionHeight + gap;
  }
  double top = area.top + 0.5 * (area.height - used);
  for (const Row & row : rows)
  {
    const double gaps = gap * static_cast<double>(row.end - row.first - 1);
    double       left = area.left + 0.5 * (area.width - scale * row.width - gaps);
    for (std::size_t panel = row.first; panel < row.end; ++panel)
    {
      const Point2 size = scale * boxes[panel].size();
      const Point2 corner(left, top + 0.5 * (scale * row.height - size[1]));
      arrangement.origins.emplace_back(corner - scale * Point2(boxes[panel].lower[0], -boxes[panel].upper[1]));
      arrangement.captions.emplace_back(left + 0.5 * size[0], top + scale * row.height + 0.75 * captionHeight);
      left += size[0] + gap;
    }
    top += scale * row.height + captionHeight + gap;
  }
  return arrangement;
}

double
roundNumberBelow(double number)
{
  const double power = std::pow(10.0, std::floor(std::log10(number)));
  const double rounding = 1.0 + 1e-12;
  const double digits = number / power * rounding;
  return power * (digits >= 10.0 ? 10.0 : digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

std::vector<double>
ticksBetween(double low, double high)
{
  const double        step = roundNumberBelow((high - low) / 3.5);
  const double        rounding = 1e-9 * (high - low);
  std::vector<double> ticks;
  for (double number = std::ceil((low - rounding) / step); number * step <= high + rounding; ++number)
  {
    ticks.push_back(number * step);
  }
  return ticks;
}

} // namespace moserhex::app
