#pragma once

#include "Canvas.h"
#include "CellColours.h"
#include "Layout.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What all parts of a figure are drawn with. */
struct Style
{
  Colour ink;
  double unit; ///< one in a picture of 1200 x 900 pixels [pixels]

  [[nodiscard]] double
  letters() const
  {
    return 20.0 * unit;
  }
};

/** The colours and their numbers, from the top of the area down. Only classes that the panels show are named. */
void
drawLegend(Canvas &                   canvas,
           const Rectangle &          area,
           const CellColours &        colours,
           const std::vector<Panel> & panels,
           const Style &              style);

/** A bar of a round number of millimetres about a fifth of the area's width long, in the area's lower left corner. */
void
drawScaleBar(Canvas & canvas, const Rectangle & area, double pixelsPerMillimetre, const Style & style);

/** Arrows that point to the patient's Left, Posterior and Superior. */
void
drawAxes(Canvas & canvas, const Point2 & middle, const Camera & camera, const Style & style);

/** Letters at the sides of a slice: R L, A P, I S. */
void
drawSideLetters(Canvas & canvas, const Rectangle & area, const Camera & camera, const Style & style);

} // namespace moserhex::app
