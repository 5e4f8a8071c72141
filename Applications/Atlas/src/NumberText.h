#pragma once

#include <array>
#include <charconv>
#include <string>

namespace moserhex::app
{

/** The shortest text that is read back as the same number. */
[[nodiscard]] inline std::string
numberText(double value)
{
  std::array<char, 32> text{};
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr };
}

} // namespace moserhex::app
