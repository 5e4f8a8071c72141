#include "CaseReport.h"

#include "Summary.h"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;

/** Where a column's number stands; "/last" is the last stage that left a mesh. */
constexpr std::array<std::pair<const char *, const char *>, 18> figurePlaces{ {
  { "nodes", "/mesh/nodes" },
  { "cells", "/mesh/cells" },
  { "label_volume_mm3", "/input/volume_mm3" },
  { "mesh_volume_mm3", "/mesh/volume_mm3" },
  { "volume_variance", "/last/volume_variance" },
  { "concave_percent", "/last/concave_percent" },
  { "sj_min", "/last/sj_min" },
  { "sj_median", "/last/sj_median" },
  { "sj_mean", "/last/sj_mean" },
  { "exact", "/exact/reached" },
  { "certified", "/exact/certified" },
  { "surface_rms_mm", "/surface/rms_mm" },
  { "surface_max_mm", "/surface/max_mm" },
  { "repair_percent", "/conditioning/changed_percent" },
  { "dice", "/conditioning/dice" },
  { "warnings", "/warning_count" },
  { "seconds", "/seconds" },
  { "peak_memory_mib", "/peak_memory_mib" },
} };

/** Null where there is nothing. */
const Json &
valueAt(const Json & json, const char * place)
{
  static const Json        nothing;
  const Json::json_pointer pointer(place);
  return json.contains(pointer) ? json.at(pointer) : nothing;
}

std::string
textAt(const Json & json, const char * place)
{
  const Json & value = valueAt(json, place);
  return value.is_string() ? value.get<std::string>() : "";
}

double
numberAt(const Json & json, const char * place)
{
  const Json & value = valueAt(json, place);
  if (value.is_boolean())
  {
    return value.get<bool>() ? 1.0 : 0.0;
  }
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string
labelsOf(const Json & json)
{
  std::string text;
  for (const Json & label : valueAt(json, "/input/labels"))
  {
    if (label.is_number_integer())
    {
      text += (text.empty() ? "" : " ") + label.dump();
    }
  }
  return text;
}

Json
lastMeasuredStage(const Json & json)
{
  Json last;
  for (const Json & stage : valueAt(json, "/stages"))
  {
    if (stage.contains("sj_min"))
    {
      last = stage;
    }
  }
  return last;
}

bool
isName(const std::string & text)
{
  constexpr std::size_t longestPath = 4096; // of Linux; other systems have less
  return !text.empty() && text.size() <= longestPath;
}

bool
isReport(const Json & json)
{
  const std::string status = textAt(json, "/status");
  return (status == "meshed" || (status == "failed" && !textAt(json, "/error/code").empty())) &&
         isName(textAt(json, "/input/file")) && isName(textAt(json, "/mesh/file")) &&
         !textAt(json, "/versions/moserhex").empty();
}

/** Discarded when it is not JSON. What is nested more deeply than in a report is left out: recursion is bounded. */
Json
readJson(const std::string & fileName)
{
  constexpr int   deepest = 16;
  std::error_code ignored;
  if (!fs::is_regular_file(fileName, ignored) || fs::file_size(fileName, ignored) > largestReport)
  {
    return Json::value_t::discarded;
  }
  std::ifstream file(fileName, std::ios::binary);
  return Json::parse(
    file, [](int depth, Json::parse_event_t, Json &) { return depth <= deepest; }, false);
}

} // namespace

const std::vector<std::string> &
summaryFigures()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto & figure : figurePlaces)
    {
      all.emplace_back(figure.first);
    }
    return all;
  }();
  return names;
}

std::optional<CaseReport>
readCaseReport(const std::string & fileName)
{
  Json json = readJson(fileName);
  if (!isReport(json))
  {
    return std::nullopt;
  }
  CaseReport report;
  report.meshed = textAt(json, "/status") == "meshed";
  report.code = textAt(json, "/error/code");
  report.message = textAt(json, "/error/message");
  report.inputFile = textAt(json, "/input/file");
  report.meshFile = textAt(json, "/mesh/file");
  report.labels = labelsOf(json);
  report.labelName = textAt(json, "/input/label_name");
  report.outline = textAt(json, "/mesh/outline");
  json["last"] = lastMeasuredStage(json);
  for (const auto & [name, place] : figurePlaces)
  {
    report.figures[name] = numberAt(json, place);
  }
  return report;
}

std::string
asInReport(const std::string & text)
{
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

} // namespace moserhex::app
