#include "ComparisonSummary.h"

#include "Version.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr double uniform = 1e-4; ///< larger differences are no rounding of coordinates in a file, of 32 bits even [1]

Json
vectorJson(const Vector3 & v)
{
  return { v[0], v[1], v[2] };
}

Json
fileJson(const InputFile & file)
{
  return { { "file", file.name }, { "sha256", file.sha256 } };
}

/** \param transform  that the alignment was read from; it leads the other way */
Json
alignmentJson(const SimilarityTransform & alignment, const InputFile & transform)
{
  const Matrix3 & R = alignment.rotation;
  Json            json{ { "direction", "this time to baseline" },
             { "scale", alignment.scale },
             { "rotation", { vectorJson(R.row(0)), vectorJson(R.row(1)), vectorJson(R.row(2)) } },
             { "translation_mm", vectorJson(alignment.translation) },
             { "rotation_degrees", alignment.angle() } };
  if (!transform.name.empty())
  {
    json["transform"] = fileJson(transform);
    json["transform"]["direction"] = "baseline to this time";
  }
  return json;
}

/** With the table that they are from, if they are. */
Json
regionSetJson(const RegionSet & set)
{
  Json json{ { "set", set.name } };
  if (!set.table.name.empty())
  {
    json.update(fileJson(set.table));
  }
  return json;
}

Json
distributionJson(const WeightedDistribution & values)
{
  return { { "mean", values.mean },     { "min", values.minimum }, { "p05", values.p05 },
           { "median", values.median }, { "p95", values.p95 },     { "max", values.maximum } };
}

Json
measuresJson(const std::vector<RegionRow> & rows)
{
  Json json;
  for (const RegionRow & row : rows)
  {
    if (row.set == "organ")
    {
      json[row.measure + (row.unit == "mm" ? "_mm" : "")] = distributionJson(row.values);
    }
  }
  return json;
}

Json
stretchJson(const LargestStretch & largest)
{
  return { { "stretch", largest.stretch },
           { "cell", largest.cell },
           { "place_mm", vectorJson(largest.place) },
           { "direction", vectorJson(largest.direction) } };
}

Json
timeJson(const Comparison & comparison, std::size_t time)
{
  const TimePoint &      point = comparison.series.points[time];
  const TimeComparison & found = comparison.times[time];
  return { { "name", point.name },
           { "months", point.months ? Json(*point.months) : Json() },
           { "file", point.file.name },
           { "sha256", point.file.sha256 },
           { "mesh", meshFileOfTime(time) },
           { "volume_mm3", point.volume },
           { "volume_change_percent", volumeChange(comparison.series, time) },
           { "lattice_volume_mm3", found.latticeVolume },
           { "lattice_volume_change_percent", found.latticeVolumeChange },
           { "cell_volume_variance", point.quality.volumeVariance },
           { "concave_cells", point.quality.concaveCells },
           { "alignment", alignmentJson(found.alignment, point.transform) },
           { "uniform_growth", isUniformGrowth(found.cells) },
           { "local_growth", point.cells.hasLocalGrowth },
           { "largest_stretch",
             time == 0 ? Json()
                       : stretchJson(largestStretchOf(comparison.series.points.front().lattice, found.cells)) },
           { "organ", measuresJson(comparison.rows[time]) } };
}

template <typename... TValues>
std::string
formatted(const char * format, TValues... values)
{
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

std::string
timeLine(const Comparison & comparison, std::size_t time)
{
  const TimePoint &              point = comparison.series.points[time];
  const std::vector<RegionRow> & rows = comparison.rows[time];
  const WeightedDistribution &   motion = ofOrgan(rows, "signed_distance");
  const WeightedDistribution &   loss = ofOrgan(rows, "baseline_signed_distance"); // sees what has gone
  const WeightedDistribution &   stretch = ofOrgan(rows, "largest_stretch");
  const std::string              months = point.months ? formatted("%.4g", *point.months) : "-";
  const std::string name = point.name.size() > 20 ? "..." + point.name.substr(point.name.size() - 17) : point.name;
  return formatted("%-20s %7s %10.2f %9.2f %12.2f %7.2f %7.2f %9.3f %8.3f %8.3f\n",
                   name.c_str(),
                   months.c_str(),
                   point.volume / 1000.0,
                   volumeChange(comparison.series, time),
                   std::min(motion.p05, loss.p05),
                   motion.median,
                   motion.p95,
                   ofOrgan(rows, "strain_1").p95,
                   stretch.p95,
                   stretch.maximum);
}

/** How an alignment moved the follow-up: its nodes' turn, and how far their mean came. */
std::string
alignmentLine(const Comparison & comparison, std::size_t time)
{
  const TimePoint &           point = comparison.series.points[time];
  const SimilarityTransform & alignment = comparison.times[time].alignment;
  if (!point.alignment && comparison.align == "none")
  {
    return "";
  }
  Vector3 mean = Vector3::Zero();
  for (const Vector3 & node : point.lattice.nodes)
  {
    mean += node;
  }
  mean /= static_cast<double>(point.lattice.nodes.size());
  return formatted(
    "%s: turned by %.1f degrees and moved by %.1f mm onto the baseline%s\n",
    oneLine(point.name, 40).c_str(),
    alignment.angle(),
    (alignment(mean) - mean).norm(),
    std::abs(alignment.scale - 1.0) < 1e-4 ? "" : formatted(", made %.4f times as large", alignment.scale).c_str());
}

/** What Volumetric means. */
const char *
growthLine(const Comparison & comparison)
{
  bool areUniform = true;
  bool areFree = true;
  for (std::size_t time = 1; time < comparison.times.size(); ++time)
  {
    const bool isUniform = isUniformGrowth(comparison.times[time].cells);
    areUniform = areUniform && isUniform;
    areFree = areFree && (isUniform || comparison.series.points[time].cells.hasLocalGrowth);
  }
  if (areUniform)
  {
    return "cells grow alike by construction: local growth shows in stretch, surface and thickness only\n";
  }
  return areFree
           ? "cells grow differently: see Volumetric, where the lattice follows material\n"
           : "volumes of cells differ, but not by --local-growth: Volumetric is no local growth, see the warnings\n";
}

} // namespace

LargestStretch
largestStretchOf(const HexMesh & baseline, const CellDeformation & cells)
{
  const auto largest =
    std::max_element(cells.strain.begin(), cells.strain.end(), [](const CellStrain & a, const CellStrain & b) {
      return a.largestStretch < b.largestStretch;
    });
  const auto cell = static_cast<std::size_t>(largest - cells.strain.begin());
  const auto m = static_cast<std::size_t>(baseline.nodesPerSide - 1);
  Vector3    sum = Vector3::Zero();
  for (const Vector3 & corner : cellCorners(baseline, cell))
  {
    sum += corner;
  }
  return { largest->largestStretch,
           { static_cast<int>(cell % m), static_cast<int>(cell / m % m), static_cast<int>(cell / (m * m)) },
           sum / 8.0,
           largest->directions.col(0) };
}

bool
isUniformGrowth(const CellDeformation & cells)
{
  return std::all_of(
    cells.volumetric.begin(), cells.volumetric.end(), [](double value) { return std::abs(value) <= uniform; });
}

const WeightedDistribution &
ofOrgan(const std::vector<RegionRow> & rows, const std::string & measure)
{
  const auto found = std::find_if(
    rows.begin(), rows.end(), [&](const RegionRow & row) { return row.set == "organ" && row.measure == measure; });
  if (found == rows.end())
  {
    throw InvalidInput("no measure " + measure + " of the organ");
  }
  return found->values;
}

void
writeComparisonSummary(const std::string & folder, const Comparison & comparison)
{
  Json json{ { "program", "moserhex compare" },
             { "version", version },
             { "units", "mm" },
             { "align", comparison.align },
             { "nodes_per_side", comparison.series.points.front().lattice.nodesPerSide },
             { "padding_left_out", comparison.series.paddingLayers },
             { "regions", Json::array() },
             { "times", Json::array() } };
  for (const RegionSet & set : comparison.sets)
  {
    json["regions"].push_back(regionSetJson(set));
  }
  for (std::size_t time = 0; time < comparison.times.size(); ++time)
  {
    json["times"].push_back(timeJson(comparison, time));
  }
  json["warnings"] = Json(comparison.series.warnings);
  writeTextFile((std::filesystem::path(folder) / "summary.json").string(),
                json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string
describe(const Comparison & comparison)
{
  std::string text = formatted("%-28s %10s %9s %28s %9s %17s\n",
                               "",
                               "volume",
                               "change",
                               "surface out (+), in (-) [mm]",
                               "strain 1",
                               "largest stretch") +
                     formatted("%-20s %7s %10s %9s %12s %7s %7s %9s %8s %8s\n",
                               "time",
                               "months",
                               "[mL]",
                               "[%]",
                               "p05",
                               "median",
                               "p95",
                               "p95",
                               "p95",
                               "max");
  for (std::size_t time = 0; time < comparison.times.size(); ++time)
  {
    text += timeLine(comparison, time);
  }
  for (std::size_t time = 1; time < comparison.times.size(); ++time)
  {
    text += alignmentLine(comparison, time);
  }
  return text + growthLine(comparison);
}

} // namespace moserhex::app
