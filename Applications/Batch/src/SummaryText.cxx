#include "SummaryText.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <array>
#include <cstdio>

namespace moserhex::app
{
namespace
{

template <typename... TValues>
std::string
line(const char * format, const TValues &... values)
{
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string
countLine(const std::string & name, std::size_t count)
{
  return line("%-18s %8zu\n", oneLine(name, 18).c_str(), count);
}

std::string
figureLine(const std::string & name, const GroupFigures::Distribution & figure)
{
  return line("%-18s %8zu %11.5g %11.5g %11.5g %11.5g %11.5g\n",
              name.c_str(),
              figure.count,
              figure.minimum,
              figure.p05,
              figure.median,
              figure.p95,
              figure.maximum);
}

} // namespace

std::string
describe(const GroupFigures & group)
{
  std::string text = countLine("done", group.done) + countLine("failed", group.failed);
  for (const auto & [code, count] : group.failures)
  {
    text += countLine("  " + code, count);
  }
  text += countLine("missing", group.missing);
  if (!group.figures.empty())
  {
    text += line("\n%-18s %8s %11s %11s %11s %11s %11s\n", "", "cases", "min", "5 %", "median", "95 %", "max");
  }
  for (const std::string & name : summaryFigures())
  {
    const auto figure = group.figures.find(name);
    text += figure == group.figures.end() ? "" : figureLine(name, figure->second);
  }
  if (group.totalSeconds > 0.0)
  {
    text += line("\n%.3g hours in all\n", group.totalSeconds / 3600.0);
  }
  return text;
}

} // namespace moserhex::app
