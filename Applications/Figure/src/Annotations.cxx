#include "Annotations.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace moserhex::app
{
namespace
{

constexpr double swatchWidth = 26.0;    ///< of colours in the legend [Style::unit]
constexpr double rowHeight = 32.0;      ///< of words in the legend [Style::unit]
constexpr double smallestLetters = 0.6; ///< of a title, to the other letters [1]

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

template <typename TTest>
bool
isAny(const std::vector<double> & values, const TTest & test)
{
  return std::any_of(
    values.begin(), values.end(), [&test](double value) { return std::isfinite(value) && test(value); });
}

/** A patch of a colour and its meaning, in a row of the height. */
void
drawSwatch(Canvas &            canvas,
           const Point2 &      corner,
           double              height,
           const Colour &      colour,
           const std::string & name,
           const Style &       style)
{
  const double letters = std::min(style.letters(), 0.9 * height);
  canvas.polygon(rectangle(corner[0], corner[1], swatchWidth * style.unit, 0.8 * height), colour);
  canvas.text({ corner[0] + (swatchWidth + 10.0) * style.unit, corner[1] + 0.4 * height + 0.36 * letters },
              name,
              letters,
              style.ink,
              TextAlign::Left);
}

/** In smaller letters, and if these are too small cut, so that it is no wider than the area. */
void
drawTitle(Canvas & canvas, const Rectangle & area, const std::string & title, const Style & style)
{
  const double full = canvas.textWidth(title, style.letters());
  const double letters = style.letters() * std::clamp(area.width / full, smallestLetters, 1.0);
  std::string  shown = title;
  for (std::size_t length = title.size(); length > 3 && canvas.textWidth(shown, letters) > area.width; --length)
  {
    shown = oneLine(title, length - 1);
  }
  canvas.text({ area.left, area.top + style.letters() }, shown, letters, style.ink, TextAlign::Left);
}

bool
showsCellWithoutNumber(const CellColours & colours, const std::vector<Panel> & panels)
{
  return std::any_of(panels.begin(), panels.end(), [&colours](const Panel & panel) {
    return std::any_of(panel.facets.begin(), panel.facets.end(), [&colours](const SeenFacet & facet) {
      return !colours.hasNumber(facet.cell);
    });
  });
}

/** A bar of stripes of one colour, and a number at each tick. Pointed ends say that there are values beyond, a patch
 * below that the panels show cells without number. */
void
drawScale(Canvas &                   canvas,
          const Rectangle &          area,
          const CellColours &        colours,
          const std::vector<Panel> & panels,
          const Style &              style)
{
  constexpr int stripes = 100;
  const double  width = swatchWidth * style.unit;
  const double  row = rowHeight * style.unit;
  double        height = area.height;
  if (showsCellWithoutNumber(colours, panels))
  {
    height -= 2.0 * row;
    drawSwatch(canvas, { area.left, area.top + area.height - row }, row, noNumberColour, "no number", style);
  }
  for (int stripe = stripes - 1; stripe >= 0; --stripe) // each down to the bottom: no gap between it and the next
  {
    const double part = (stripe + 1.0) / stripes;
    canvas.polygon(rectangle(area.left, area.top + height * (1.0 - part), width, height * part),
                   colours.scale.at((stripe + 0.5) / stripes));
  }
  const double rounding = 1e-9 * (colours.high - colours.low);
  const double bottom = area.top + height;
  const double middle = area.left + 0.5 * width;
  const double right = area.left + width;
  if (isAny(colours.values, [&](double value) { return value > colours.high + rounding; }))
  {
    canvas.polygon({ { area.left, area.top }, { middle, area.top - 0.7 * width }, { right, area.top } },
                   colours.scale.at(1.0));
  }
  if (isAny(colours.values, [&](double value) { return value < colours.low - rounding; }))
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
  const double step = std::min(area.height / static_cast<double>(shown.size()), rowHeight * style.unit);
  double       top = area.top;
  for (auto one = colours.classes.rbegin(); one != colours.classes.rend(); ++one)
  {
    if (shown.count(one->value) == 1)
    {
      drawSwatch(canvas, { area.left, top }, step, one->colour, one->name, style);
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
  drawTitle(canvas, area, colours.title, style);
  const double    above = 2.6 * style.letters();
  const Rectangle rest{ area.left, area.top + above, area.width, area.height - above };
  if (colours.classes.empty())
  {
    drawScale(canvas, rest, colours, panels, style);
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
