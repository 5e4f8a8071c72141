#pragma once

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

/** 0xRRGGBB, which covers all */
[[nodiscard]] Colour
fromHexadecimal(unsigned int rgb);

[[nodiscard]] std::vector<Colour>
fromHexadecimal(const std::vector<unsigned int> & colours);

/** "#rrggbb", for CSS and SVG */
[[nodiscard]] std::string
cssColour(const Colour & colour);

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
 * der Walt and Smith, 2015; CC0). web/src/colours.js has the same stops. */
[[nodiscard]] const ColourScale &
sequentialScale();

} // namespace moserhex::app
