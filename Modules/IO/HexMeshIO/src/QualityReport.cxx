#include "moserhex/HexMeshIO/QualityReport.h"

#include "moserhex/HexMeshIO/AtomicFile.h"

#include <nlohmann/json.hpp>

namespace moserhex
{
namespace
{

using Json = nlohmann::ordered_json;

Json
distributionJson(const Distribution & distribution)
{
  return { { "min", distribution.minimum },   { "p01", distribution.p01 },    { "p05", distribution.p05 },
           { "median", distribution.median }, { "mean", distribution.mean },  { "p95", distribution.p95 },
           { "p99", distribution.p99 },       { "max", distribution.maximum } };
}

Json
classJson(const HexClassQuality & quality)
{
  Json json{ { "cells", quality.cells }, { "concave", quality.concaveCells } };
  if (quality.cells > 0)
  {
    json["volume_variance"] = quality.volumeVariance;
    json["sj_min"] = quality.scaledJacobianMin;
    json["sj_median"] = quality.scaledJacobianMedian;
  }
  return json;
}

Json
qualityJson(const HexQualitySummary & quality)
{
  Json json;
  json["volume_mm3"] = quality.volume;
  json["volume_variance"] = quality.volumeVariance;
  json["ratio_min"] = quality.ratioMin;
  json["ratio_max"] = quality.ratioMax;
  json["concave"] = quality.concaveCells;
  json["concave_percent"] = quality.concavePercent;
  json["certified"] = { { "positive", quality.certified.positive },
                        { "not_positive", quality.certified.notPositive },
                        { "undecided", quality.certified.undecided } };
  json["scaled_jacobian"] = distributionJson(quality.scaledJacobian);
  json["minimum_jacobian"] = distributionJson(quality.minimumJacobian);
  json["aspect_ratio"] = distributionJson(quality.aspectRatio);
  json["taper"] = distributionJson(quality.taper);
  json["skew"] = distributionJson(quality.skew);
  if (quality.isLattice)
  {
    json["classes"] = { { "corner", classJson(quality.corners) },
                        { "edge", classJson(quality.edges) },
                        { "rest", classJson(quality.rest) } };
  }
  return json;
}

Json
labelJson(const QualityReport::Label & label)
{
  Json json{ { "file", label.file } };
  json["label"] = label.labels.size() == 1 ? Json(label.labels.front()) : Json();
  json["labels"] = label.labels;
  json["volume_mm3"] = label.agreement.labelVolume;
  json["volume_error"] = label.agreement.volumeError;
  json["dice"] = label.agreement.dice;
  json["boundary_nodes_mm"] = distributionJson(label.agreement.boundaryNodes);
  json["face_centres_mm"] = distributionJson(label.agreement.faceCentres);
  return json;
}

} // namespace

std::string
toJson(const QualityReport & report)
{
  Json json;
  json["mesh"] = { { "file", report.file },
                   { "nodes", report.nodes },
                   { "cells", report.quality.cells },
                   { "lattice", report.quality.isLattice },
                   { "padding", report.quality.paddingLayers } };
  json["quality"] = qualityJson(report.quality);
  if (report.label)
  {
    json["label"] = labelJson(*report.label);
  }
  json["warnings"] = Json(report.warnings);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeQualityReport(const std::string & fileName, const QualityReport & report)
{
  writeTextFile(fileName, toJson(report));
}

} // namespace moserhex
