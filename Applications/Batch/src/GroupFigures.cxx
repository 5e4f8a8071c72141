#include "Summary.h"

#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/Quality/HexQuality.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::ordered_json;

GroupFigures::Distribution
describeValues(const std::vector<double> & values)
{
  const Distribution all = distributionOf(values);
  return { values.size(), all.minimum, all.p05, all.median, all.p95, all.maximum, all.mean };
}

/** Finite numbers of the cases that are done, by column. */
std::map<std::string, std::vector<double>>
valuesOf(const std::vector<SummaryRow> & rows)
{
  std::map<std::string, std::vector<double>> values;
  for (const SummaryRow & row : rows)
  {
    for (const auto & [name, value] : row.figures)
    {
      if (row.status == CaseStatus::Done && std::isfinite(value))
      {
        values[name].push_back(value);
      }
    }
  }
  return values;
}

Json
distributionJson(const GroupFigures::Distribution & distribution)
{
  return { { "count", distribution.count },   { "min", distribution.minimum }, { "p05", distribution.p05 },
           { "median", distribution.median }, { "p95", distribution.p95 },     { "max", distribution.maximum },
           { "mean", distribution.mean } };
}

} // namespace

GroupFigures
groupFigures(const std::vector<SummaryRow> & rows)
{
  GroupFigures group;
  for (const SummaryRow & row : rows)
  {
    group.done += row.status == CaseStatus::Done ? 1 : 0;
    group.missing += row.status == CaseStatus::Missing ? 1 : 0;
    if (row.status == CaseStatus::Failed)
    {
      ++group.failed;
      ++group.failures[row.code];
    }
    const auto seconds = row.figures.find("seconds");
    if (seconds != row.figures.end() && std::isfinite(seconds->second))
    {
      group.totalSeconds += seconds->second;
    }
  }
  for (const auto & [name, values] : valuesOf(rows))
  {
    group.figures[name] = describeValues(values);
  }
  return group;
}

void
writeGroupFigures(const std::string & fileName, const GroupFigures & figures)
{
  Json json;
  json["cases"] = figures.done + figures.failed + figures.missing;
  json["done"] = figures.done;
  json["failed"] = figures.failed;
  json["missing"] = figures.missing;
  json["failures"] = figures.failures.empty() ? Json::object() : Json(figures.failures);
  json["figures"] = Json::object();
  for (const std::string & name : summaryFigures())
  {
    const auto figure = figures.figures.find(name);
    if (figure != figures.figures.end())
    {
      json["figures"][name] = distributionJson(figure->second);
    }
  }
  if (figures.totalSeconds > 0.0)
  {
    json["total_seconds"] = figures.totalSeconds;
  }
  writeTextFile(fileName, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace moserhex::app
