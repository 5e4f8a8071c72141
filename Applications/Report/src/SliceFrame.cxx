#include "SliceFrame.h"

#include "HtmlText.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moserhex::app
{
namespace
{

constexpr double longestSide = 400.0; ///< of a figure [pixels]

struct View
{
  const char * name;
  const char * axis;
  const char * left;
  const char * right;
  const char * top;
  const char * bottom;
};

const View &
viewOf(int axis)
{
  static constexpr std::array<View, 3> views{ { { "Sagittal", "x", "A", "P", "S", "I" },
                                                { "Coronal", "y", "R", "L", "S", "I" },
                                                { "Axial", "z", "R", "L", "A", "P" } } };
  return views[static_cast<std::size_t>(axis)];
}

std::string
letter(double x, double y, const char * text)
{
  return "<text x=\"" + shortNumber(x, 5) + "\" y=\"" + shortNumber(y, 5) + "\">" + text + "</text>";
}

/** A tenth to a third of the width, of a round length. */
std::string
scaleBar(const SliceFrame & frame)
{
  const double third = frame.width / 3.0;
  const double decade = std::pow(10.0, std::floor(std::log10(third)));
  const double length = decade * (third / decade >= 5.0 ? 5.0 : third / decade >= 2.0 ? 2.0 : 1.0);
  const double y = frame.height * frame.scale() - 10.0;
  return "<path class=\"scale\" d=\"M10 " + shortNumber(y, 5) + "h" + shortNumber(length * frame.scale(), 5) +
         "\"/><text class=\"scale-text\" x=\"10\" y=\"" + shortNumber(y - 6.0, 5) + "\">" + shortNumber(length) +
         " mm</text>";
}

} // namespace

double
SliceFrame::scale() const
{
  return longestSide / std::max(width, height);
}

bool
SliceFrame::isTurned() const
{
  return axis != 2;
}

std::string
framedSlice(const SliceFrame & frame, const std::string & drawing, const std::string & what, const std::string & id)
{
  const View &      view = viewOf(frame.axis);
  const double      w = frame.width * frame.scale();
  const double      h = frame.height * frame.scale();
  const std::string place = std::string(view.axis) + " = " + fixedNumber(frame.place, 1) + " mm";
  return "<figure><svg class=\"slice\" viewBox=\"0 0 " + shortNumber(w, 6) + " " + shortNumber(h, 6) +
         "\" role=\"img\" aria-labelledby=\"" + id + "\"><title id=\"" + id + "\">" + view.name + " slice at " + place +
         ": " + what + "</title>" + drawing + "<g class=\"letters\">" + letter(12, h / 2, view.left) +
         letter(w - 12, h / 2, view.right) + letter(w / 2, 18, view.top) + letter(w / 2, h - 8, view.bottom) + "</g>" +
         scaleBar(frame) + "</svg><figcaption>" + view.name + ", " + place + "</figcaption></figure>";
}

} // namespace moserhex::app
