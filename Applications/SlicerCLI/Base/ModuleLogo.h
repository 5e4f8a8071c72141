#pragma once

#include <string>

namespace moserhex::slicer
{

/** What --logo prints: LOGO, width, height, bytes a pixel, length, and the pixels in base64 (red, green, blue, alpha;
 * row by row), each on a line. The picture is a square of four shells. */
[[nodiscard]] std::string
moduleLogo();

} // namespace moserhex::slicer
