#include "LatticeTurn.h"

#include "CaseReport.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;

/** The report; discarded when there is none. */
Json
reportBeside(const std::string & meshFile)
{
  const fs::path  report = fs::path(meshFile).replace_extension(".json");
  std::error_code missing;
  if (!fs::is_regular_file(report, missing) || fs::file_size(report, missing) > largestReport)
  {
    return Json(Json::value_t::discarded);
  }
  std::ifstream file(report, std::ios::binary);
  return Json::parse(file, nullptr, false);
}

} // namespace

std::optional<std::string>
turnOfLattice(const std::string & meshFile)
{
  const Json report = reportBeside(meshFile);
  if (!report.is_object())
  {
    return std::nullopt;
  }
  for (const Json & warning : report.value("warnings", Json::array()))
  {
    const std::string text = warning.is_string() ? warning.get<std::string>() : "";
    const std::size_t begin = text.find("the lattice is turned by ");
    if (begin != std::string::npos)
    {
      return text.substr(begin, text.find(':', begin) - begin);
    }
  }
  const Json::json_pointer ridge("/frame/turned_degrees");
  if (report.contains(ridge) && report.at(ridge).is_number() && report.at(ridge).get<double>() > 0.0)
  {
    const long degrees = std::lround(report.at(ridge).get<double>());
    return "the lattice is turned by " + std::to_string(degrees) + " degrees (--frame ridge)";
  }
  return std::nullopt;
}

} // namespace moserhex::app
