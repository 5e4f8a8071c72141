#include "Colours.h"

#include "CommandErrors.h"

namespace moserhex::app
{
Colour
parseColour(const std::string & text)
{
  if (text == "white")
  {
    return { 1.0, 1.0, 1.0, 1.0 };
  }
  if (text == "black")
  {
    return { 0.0, 0.0, 0.0, 1.0 };
  }
  if (text == "none")
  {
    return { 1.0, 1.0, 1.0, 0.0 };
  }
  if (text.size() != 6 || text.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
  {
    throw UsageError("background " + oneLine(text, 40) + " is no colour; give white, black, none or RRGGBB");
  }
  return fromHexadecimal(static_cast<unsigned int>(std::stoul(text, nullptr, 16)));
}

Colour
shaded(const Colour & colour, double light)
{
  return { colour.red * light, colour.green * light, colour.blue * light, colour.alpha };
}

Colour
inkOn(const Colour & background)
{
  const double luminance = 0.2126 * background.red + 0.7152 * background.green + 0.0722 * background.blue;
  return fromHexadecimal(luminance > 0.4 ? 0x1a1a1a : 0xf2f2f2);
}

const ColourScale &
divergingScale()
{
  static const ColourScale scale(fromHexadecimal({ 0x1f4e9c, 0x7fa5d8, 0xf2f2f0, 0xdd9a72, 0xa03a12 }));
  return scale;
}

Colour
categoryColour(std::size_t category)
{
  static const std::vector<Colour> colours =
    fromHexadecimal({ 0x56b4e9, 0xe69f00, 0x009e73, 0xcc79a7, 0xf0e442, 0x0072b2, 0xd55e00, 0x999999 });
  return colours[category % colours.size()];
}

} // namespace moserhex::app
