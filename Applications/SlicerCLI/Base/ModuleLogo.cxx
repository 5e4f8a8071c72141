#include "ModuleLogo.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <vector>

namespace moserhex::slicer
{
namespace
{

constexpr int width = 32;
constexpr int bytesPerPixel = 4;
constexpr int shells = 4;

std::string
base64(const std::vector<std::uint8_t> & bytes)
{
  static const char * const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string               text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t     word = 0;
    for (std::size_t b = 0; b < 3; ++b)
    {
      word = word << 8U | (b < count ? bytes[i + b] : 0U);
    }
    for (std::size_t d = 0; d < 4; ++d)
    {
      text += d <= count ? digits[word >> (18U - 6U * d) & 63U] : '=';
    }
  }
  return text;
}

std::vector<std::uint8_t>
pixels()
{
  static const std::array<std::array<std::uint8_t, 3>, shells> colours{
    { { 68, 1, 84 }, { 49, 104, 142 }, { 53, 183, 121 }, { 253, 231, 37 } }
  };
  std::vector<std::uint8_t> image;
  for (int y = 0; y < width; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int fromEdge = std::min({ x, y, width - 1 - x, width - 1 - y });
      for (const std::uint8_t value : colours[static_cast<std::size_t>(fromEdge / (width / 2 / shells))])
      {
        image.push_back(value);
      }
      image.push_back(255);
    }
  }
  return image;
}

} // namespace

std::string
moduleLogo()
{
  const std::string  text = base64(pixels());
  std::ostringstream logo;
  logo << "LOGO\n" << width << "\n" << width << "\n" << bytesPerPixel << "\n" << text.size() << "\n" << text << "\n";
  return logo.str();
}

} // namespace moserhex::slicer
