#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Red, green and blue in [0,1], and how much of it covers what is below. */
struct Colour
{
  double red{ 0.0 };
  double green{ 0.0 };
  double blue{ 0.0 };
  double alpha{ 1.0 };
};

/** "white", "black", "none" (nothing at all), or six hexadecimal digits RRGGBB.
 * \throws UsageError  anything else */
[[nodiscard]] Colour
parseColour(const std::string & text);

/** The same colour under less light, in [0,1]. */
[[nodiscard]] Colour
shaded(const Colour & colour, double light);

/** Black or nearly white, whichever is read better on the background. */
[[nodiscard]] Colour
inkOn(const Colour & background);

/** Colours along [0,1], straight lines between stops at equal distances. */
class ColourScale
{
public:
  explicit ColourScale(std::vector<Colour> stops) : m_Stops(std::move(stops))
  {}

  /** \param position  the ends' colours beyond [0,1] */
  [[nodiscard]] Colour
  at(double position) const;

private:
  std::vector<Colour> m_Stops;
};

/** Dark blue over green to yellow, even steps to the eye and to those who do not see red and green apart: viridis (van
 * der Walt and Smith, 2015; CC0). */
[[nodiscard]] const ColourScale &
sequentialScale();

/** Blue over nearly white in the middle to red-brown, for departures from a value. */
[[nodiscard]] const ColourScale &
divergingScale();

/** Eight colours that are told apart without red and green, too (Okabe and Ito, 2008), from 0; further ones repeat
 * them.
 */
[[nodiscard]] Colour
categoryColour(std::size_t category);

} // namespace moserhex::app
