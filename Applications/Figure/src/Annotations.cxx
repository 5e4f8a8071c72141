#include "Annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace moserhex::app
{
namespace
{

std::string
numberText(double number)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", std::abs(number) < 1e-12 ? 0.0 : number);
  return text.data();
}

std::vector<Point2>
rectangle(double left, double top, double width, double height)
{
  return { { left, top }, { left + width, top }, { left + width, top + height }, { left, top + height } };
}

/** A bar of stripes of one colour, and a number at each tick. Pointed ends say that there are values beyond. */
void
drawScale(Canvas & canvas, const Rectangle & area, const CellColours & colours, const Style & style)
{
  constexpr int stripes = 100;
  const double  width = 26.0 * style.unit;
  const double  height = area.height;
  for (int stripe = stripes - 1; stripe >= 0; --stripe) // each down to the bottom: no gap between it and the next
  {
    const double part = (stripe + 1.0) / stripes;
    canvas.polygon(rectangle(area.left, area.top + height * (1.0 - part), width, height * part),
                   colours.scale.at((stripe + 0.5) / stripes));
  }
  const auto   ends = std::minmax_element(colours.values.begin(), colours.values.end());
  const double rounding = 1e-9 * (colours.high - colours.low);
  const double bottom = area.top + height;
  const double middle = area.left + 0.5 * width;
  const double right = area.left + width;
  if (*ends.second > colours.high + rounding)
  {
    canvas.polygon({ { area.left, area.top }, { middle, area.top - 0.7 * width }, { right, area.top } },
                   colours.scale.at(1.0));
  }
  if (*ends.first < colours.low - rounding)
  {
    canvas.polygon({ { area.left, bottom }, { middle, bottom + 0.7 * width }, { right, bottom } },
                   colours.scale.at(0.0));
  }
  for (const double tick : ticksBetween(colours.low, colours.high))
  {
    const double y = bottom - height * (tick - colours.low) / (colours.high - colours.low);
    canvas.line({ { right, y }, { right + 7.0 * style.unit, y } }, { style.ink, 1.5 * style.unit });
    canvas.text({ right + 12.0 * style.unit, y + 0.36 * style.letters() },
                numberText(tick),
                style.letters(),
                style.ink,
                TextAlign::Left);
  }
}

void
drawClasses(Canvas &                   canvas,
            const Rectangle &          area,
            const CellColours &        colours,
            const std::vector<Panel> & panels,
            const Style &              style)
{
  std::set<int> shown;
  for (const Panel & panel : panels)
  {
    for (const SeenFacet & facet : panel.facets)
    {
      shown.insert(static_cast<int>(colours.values[facet.cell]));
    }
  }
  const double step = std::min(area.height / static_cast<double>(shown.size()), 32.0 * style.unit);
  const double letters = std::min(style.letters(), 0.9 * step);
  double       top = area.top;
  for (auto one = colours.classes.rbegin(); one != colours.classes.rend(); ++one)
  {
    if (shown.count(one->value) == 1)
    {
      canvas.polygon(rectangle(area.left, top, 26.0 * style.unit, 0.8 * step), one->colour);
      canvas.text({ area.left + 36.0 * style.unit, top + 0.4 * step + 0.36 * letters },
                  one->name,
                  letters,
                  style.ink,
                  TextAlign::Left);
      top += step;
    }
  }
}

} // namespace

void
drawLegend(Canvas &                   canvas,
           const Rectangle &          area,
           const CellColours &        colours,
           const std::vector<Panel> & panels,
           const Style &              style)
{
  canvas.text({ area.left, area.top + style.letters() }, colours.title, style.letters(), style.ink, TextAlign::Left);
  const double    above = 2.6 * style.letters();
  const Rectangle rest{ area.left, area.top + above, area.width, area.height - above };
  if (colours.classes.empty())
  {
    drawScale(canvas, rest, colours, style);
  }
  else
  {
    drawClasses(canvas, rest, colours, panels, style);
  }
}

void
drawScaleBar(Canvas & canvas, const Rectangle & area, double pixelsPerMillimetre, const Style & style)
{
  const double length = roundNumberBelow(0.25 * area.width / pixelsPerMillimetre);
  const double y = area.top + area.height - 6.0 * style.unit;
  const double right = area.left + length * pixelsPerMillimetre;
  const double tick = 6.0 * style.unit;
  const Pen    pen{ style.ink, 2.5 * style.unit };
  canvas.line({ { area.left, y - tick }, { area.left, y }, { right, y }, { right, y - tick } }, pen);
  canvas.text({ 0.5 * (area.left + right), y - 12.0 * style.unit },
              numberText(length) + " mm",
              style.letters(),
              style.ink,
              TextAlign::Middle);
}

void
drawAxes(Canvas & canvas, const Point2 & middle, const Camera & camera, const Style & style)
{
  const std::array<std::string, 3> names{ "L", "P", "S" };
  std::array<int, 3>               order{ 0, 1, 2 };
  std::stable_sort(
    order.begin(), order.end(), [&camera](int a, int b) { return camera.towards[a] < camera.towards[b]; });
  for (const int axis : order)
  {
    const Vector3 direction = Vector3::Unit(axis);
    const Point2  step(camera.place(direction)[0], -camera.place(direction)[1]);
    const Point2  tip = middle + 46.0 * style.unit * step;
    const Point2  side = 5.0 * style.unit * Point2(-step[1], step[0]);
    const Point2  neck = tip - 12.0 * style.unit * step;
    canvas.line({ middle, neck }, { style.ink, 2.5 * style.unit });
    canvas.polygon({ tip, neck + side, neck - side }, style.ink, Pen{ style.ink, 0.5 * style.unit });
    const Point2 beyond =
      tip + 14.0 * style.unit * (step.norm() > 1e-6 ? Point2(step.normalized()) : Point2(1.0, -1.0));
    canvas.text(beyond + Point2(0.0, 0.36 * style.letters()),
                names[static_cast<std::size_t>(axis)],
                style.letters(),
                style.ink,
                TextAlign::Middle);
  }
}

void
drawSideLetters(Canvas & canvas, const Rectangle & area, const Camera & camera, const Style & style)
{
  const auto letter = [](const Vector3 & direction) {
    int          axis = 0;
    const double size = direction.cwiseAbs().maxCoeff(&axis);
    return std::string(1, direction[axis] * size > 0.0 ? "LPS"[axis] : "RAI"[axis]);
  };
  const double size = 1.2 * style.letters();
  const double down = 0.36 * size;
  const double middle = area.left + 0.5 * area.width;
  const double halfway = area.top + 0.5 * area.height + down;
  const double right = area.left + area.width;
  const double bottom = area.top + area.height;
  canvas.text({ area.left + 0.5 * size, halfway }, letter(-camera.right), size, style.ink, TextAlign::Middle);
  canvas.text({ right - 0.5 * size, halfway }, letter(camera.right), size, style.ink, TextAlign::Middle);
  canvas.text({ middle, area.top + 2.0 * down }, letter(camera.up), size, style.ink, TextAlign::Middle);
  canvas.text({ middle, bottom }, letter(-camera.up), size, style.ink, TextAlign::Middle);
}

} // namespace moserhex::app
