#include "ColourScale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace moserhex::app
{

Colour
fromHexadecimal(unsigned int rgb)
{
  return { (rgb >> 16U & 255U) / 255.0, (rgb >> 8U & 255U) / 255.0, (rgb & 255U) / 255.0, 1.0 };
}

std::vector<Colour>
fromHexadecimal(const std::vector<unsigned int> & colours)
{
  std::vector<Colour> result;
  for (const unsigned int rgb : colours)
  {
    result.push_back(fromHexadecimal(rgb));
  }
  return result;
}

std::string
cssColour(const Colour & colour)
{
  const auto level = [](double part) {
    return static_cast<unsigned int>(std::lround(255.0 * std::clamp(part, 0.0, 1.0)));
  };
  std::array<char, 8> text{};
  std::snprintf(text.data(),
                text.size(),
                "#%02x%02x%02x",
                level(colour.red) & 255U,
                level(colour.green) & 255U,
                level(colour.blue) & 255U);
  return text.data();
}

Colour
ColourScale::at(double position) const
{
  const double place = std::clamp(position, 0.0, 1.0) * static_cast<double>(m_Stops.size() - 1);
  const auto   before = std::min(static_cast<std::size_t>(place), m_Stops.size() - 2);
  const double part = place - static_cast<double>(before);
  const auto   mixed = [part](double a, double b) { return a + part * (b - a); };
  const auto & a = m_Stops[before];
  const auto & b = m_Stops[before + 1];
  return { mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue), 1.0 };
}

const ColourScale &
sequentialScale()
{
  static const ColourScale scale(fromHexadecimal(
    { 0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725 }));
  return scale;
}

} // namespace moserhex::app
