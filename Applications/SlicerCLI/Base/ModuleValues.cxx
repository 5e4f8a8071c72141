#include "ModuleValues.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace moserhex::slicer
{
namespace
{

template <typename TNumber>
std::optional<TNumber>
numberOf(const std::string & text)
{
  // A plus sign is usual, but from_chars takes none.
  const char * begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char * end = text.data() + text.size();
  TNumber      number{};
  const auto   result = std::from_chars(begin, end, number);
  return begin != end && result.ec == std::errc() && result.ptr == end ? std::optional<TNumber>(number) : std::nullopt;
}

bool
endsWith(const std::string & text, const std::string & end)
{
  return text.size() > end.size() &&
         std::equal(end.rbegin(), end.rend(), text.rbegin(), [](unsigned char a, unsigned char b) {
           return std::tolower(a) == std::tolower(b);
         });
}

} // namespace

std::optional<long long>
integerOf(const std::string & text)
{
  return numberOf<long long>(text);
}

std::optional<double>
realOf(const std::string & text)
{
  const std::optional<double> number = numberOf<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string
rangeOf(const ModuleParameter & parameter)
{
  std::ostringstream text;
  text.precision(10); // labels of 32 bits
  if (!parameter.choices.empty())
  {
    for (const std::string & choice : parameter.choices)
    {
      text << (text.str().empty() ? "" : ", ") << choice;
    }
  }
  else if (parameter.minimum || parameter.maximum)
  {
    text << (parameter.minimum ? "" : "at most ");
    if (parameter.minimum)
    {
      text << *parameter.minimum << (parameter.maximum ? " to " : " or more");
    }
    if (parameter.maximum)
    {
      text << *parameter.maximum;
    }
  }
  else
  {
    for (const std::string & extension : parameter.fileExtensions)
    {
      text << (text.str().empty() ? "" : " ") << extension;
    }
  }
  return text.str();
}

namespace
{

std::string
faultOfNumber(const ModuleParameter & parameter, const std::string & value)
{
  const bool                  isInteger = parameter.kind == ValueKind::Integer;
  const std::optional<double> number =
    isInteger ? (integerOf(value) ? std::optional<double>(static_cast<double>(*integerOf(value))) : std::nullopt)
              : realOf(value);
  if (!number)
  {
    return "\"" + value + "\" is not " + (isInteger ? "a whole number" : "a number");
  }
  if (*number < parameter.minimum.value_or(-std::numeric_limits<double>::infinity()) ||
      *number > parameter.maximum.value_or(std::numeric_limits<double>::infinity()))
  {
    return value + " is not " + rangeOf(parameter);
  }
  return "";
}

std::string
faultOfElement(const ModuleParameter & parameter, const std::string & value)
{
  if (!parameter.choices.empty())
  {
    const bool isChoice =
      std::find(parameter.choices.begin(), parameter.choices.end(), value) != parameter.choices.end();
    return isChoice ? "" : value + " is not one of " + rangeOf(parameter);
  }
  if (parameter.kind == ValueKind::Integer || parameter.kind == ValueKind::Real)
  {
    return faultOfNumber(parameter, value);
  }
  if (parameter.kind == ValueKind::File && parameter.isOutput && !parameter.fileExtensions.empty() &&
      std::none_of(parameter.fileExtensions.begin(), parameter.fileExtensions.end(), [&](const std::string & end) {
        return endsWith(value, end);
      }))
  {
    return value + " does not end with " + rangeOf(parameter);
  }
  return "";
}

} // namespace

std::vector<std::string>
elementsOf(const ModuleParameter & parameter, const std::string & value)
{
  if (!parameter.isList && !parameter.isMultiple)
  {
    return { value };
  }
  if (value.empty())
  {
    return {};
  }
  const bool               hasQuotes = parameter.kind == ValueKind::Text || parameter.kind == ValueKind::File;
  std::vector<std::string> elements(1);
  bool                     isQuoted = false;
  for (const char c : value)
  {
    if (c == '"' && hasQuotes)
    {
      isQuoted = !isQuoted;
    }
    else if (c == ',' && !isQuoted)
    {
      elements.emplace_back();
    }
    else
    {
      elements.back() += c;
    }
  }
  return elements;
}

std::string
faultOfValue(const ModuleParameter & parameter, const std::string & value)
{
  const std::vector<std::string> elements = elementsOf(parameter, value);
  if (parameter.listSize != 0 && elements.size() != parameter.listSize)
  {
    return "\"" + value + "\" is not " + std::to_string(parameter.listSize) + " numbers with commas between them";
  }
  for (const std::string & element : elements)
  {
    const std::string fault =
      parameter.isMultiple && element.empty() ? "an empty value" : faultOfElement(parameter, element);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return elements.empty() && parameter.isMultiple ? "an empty value" : "";
}

} // namespace moserhex::slicer
