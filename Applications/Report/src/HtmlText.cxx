#include "HtmlText.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace moserhex::app
{
namespace
{

const char * const replacement = "\xEF\xBF\xBD"; ///< U+FFFD in UTF-8

/** The text with replacement characters for what is not UTF-8. */
std::string
validUtf8(const std::string & text)
{
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

std::string
textOf(double value, std::chars_format format, int precision)
{
  if (!std::isfinite(value))
  {
    return "n/a";
  }
  std::array<char, 400> text{}; // the largest double has 309 digits before the point
  const auto            end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
  return { text.data(), end };
}

} // namespace

std::string
escapeHtml(const std::string & text)
{
  std::string escaped;
  for (const char letter : validUtf8(text))
  {
    switch (letter)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
      {
        const auto code = static_cast<unsigned char>(letter);
        const bool isControl = (code < 0x20 && letter != '\t' && letter != '\n') || code == 0x7f;
        isControl ? escaped += replacement : escaped += letter;
      }
    }
  }
  return escaped;
}

std::string
escapeScriptJson(const std::string & json)
{
  std::string escaped;
  escaped.reserve(json.size());
  for (const char letter : json)
  {
    switch (letter)
    {
      case '<':
        escaped += "\\u003c";
        break;
      case '>':
        escaped += "\\u003e";
        break;
      case '&':
        escaped += "\\u0026";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string
urlOfPath(const std::string & path)
{
  constexpr const char * digits = "0123456789ABCDEF";
  constexpr const char * harmless = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string            url;
  for (const char letter : path)
  {
    if (std::strchr(harmless, letter) && letter != '\0')
    {
      url += letter;
      continue;
    }
    const auto code = static_cast<unsigned char>(letter);
    url += '%';
    url += digits[code >> 4];
    url += digits[code & 15];
  }
  return url;
}

std::string
base64(const void * data, std::size_t size)
{
  constexpr const char * letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto *           bytes = static_cast<const std::uint8_t *>(data);
  std::string            text;
  text.reserve((size + 2) / 3 * 4);
  for (std::size_t at = 0; at < size; at += 3)
  {
    const std::size_t left = std::min<std::size_t>(size - at, 3);
    std::uint32_t     group = std::uint32_t{ bytes[at] } << 16;
    group |= left > 1 ? std::uint32_t{ bytes[at + 1] } << 8 : 0;
    group |= left > 2 ? std::uint32_t{ bytes[at + 2] } : 0;
    text += letters[group >> 18];
    text += letters[group >> 12 & 63];
    text += left > 1 ? letters[group >> 6 & 63] : '=';
    text += left > 2 ? letters[group & 63] : '=';
  }
  return text;
}

std::string
shortNumber(double value, int digits)
{
  return textOf(value, std::chars_format::general, digits);
}

std::string
fixedNumber(double value, int decimals)
{
  return textOf(value, std::chars_format::fixed, decimals);
}

std::string
shortFileName(const std::string & fileName, std::size_t longest)
{
  const std::string name = std::filesystem::path(fileName).filename().string();
  return name.size() <= longest ? name : "..." + name.substr(name.size() - longest + 3);
}

} // namespace moserhex::app
