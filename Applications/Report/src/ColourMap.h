#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace moserhex::app
{

/** From dark violet to yellow, lightness rising evenly: told apart in grey and by colour-blind readers. The same stops
 * are in web/src/colours.js.
 * \param part  in [0,1] \return "#rrggbb" */
[[nodiscard]] inline std::string
colourOf(double part)
{
  constexpr std::array<std::array<double, 3>, 6> stops{
    { { 68, 1, 84 }, { 65, 68, 135 }, { 42, 120, 142 }, { 34, 168, 132 }, { 122, 209, 81 }, { 253, 231, 37 } }
  };
  const double        place = std::clamp(part, 0.0, 1.0) * (stops.size() - 1);
  const auto          stop = std::min<std::size_t>(static_cast<std::size_t>(place), stops.size() - 2);
  const double        t = place - static_cast<double>(stop);
  std::array<char, 8> text{};
  const auto          channel = [&](std::size_t c) {
    return static_cast<int>(std::lround((1.0 - t) * stops[stop][c] + t * stops[stop + 1][c]));
  };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", channel(0) & 255, channel(1) & 255, channel(2) & 255);
  return text.data();
}

} // namespace moserhex::app
