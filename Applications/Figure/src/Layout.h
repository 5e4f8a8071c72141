#pragma once

#include "Camera.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** One thing in the picture: facets in the order to draw, and what stands below it. */
struct Panel
{
  std::vector<SeenFacet> facets;
  std::string            caption;
};

/** A part of the picture [pixels]. */
struct Rectangle
{
  double left;
  double top;
  double width;
  double height;
};

/** Where panels are drawn: a point seen at p [mm] is drawn at origins[panel] + scale * (p.x, -p.y). */
struct Arrangement
{
  double              scale{ 1.0 }; ///< the same for all [pixels/mm]
  std::vector<Point2> origins;      ///< [pixels]
  std::vector<Point2> captions;     ///< the middle of each caption's base line [pixels]

  [[nodiscard]] Point2
  place(std::size_t panel, const Point2 & seen) const
  {
    return origins[panel] + scale * Point2(seen[0], -seen[1]);
  }
};

/** Panels in rows from the upper left, in as many rows as let them be largest. Captions get `captionHeight` below their
 * row and panels keep `gap` apart [pixels]. */
[[nodiscard]] Arrangement
arrange(const std::vector<Panel> & panels, const Rectangle & area, double captionHeight, double gap);

/** 1, 2 or 5 times a power of ten: the largest that is not above the number. \param number  > 0 */
[[nodiscard]] double
roundNumberBelow(double number);

/** Round numbers from low to high, about five of them, ascending. */
[[nodiscard]] std::vector<double>
ticksBetween(double low, double high);

} // namespace moserhex::app
