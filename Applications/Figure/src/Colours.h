#pragma once

#include "ColourScale.h"

#include <cstddef>
#include <string>

namespace moserhex::app
{

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

/** Blue over nearly white in the middle to red-brown, for departures from a value. */
[[nodiscard]] const ColourScale &
divergingScale();

/** Eight colours that are told apart without red and green, too (Okabe and Ito, 2008), from 0; further ones repeat
 * them.
 */
[[nodiscard]] Colour
categoryColour(std::size_t category);

} // namespace moserhex::app
