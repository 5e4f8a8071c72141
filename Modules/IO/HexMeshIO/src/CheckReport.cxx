#include "moserhex/HexMeshIO/CheckReport.h"

#include "TopologyJson.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

namespace moserhex
{
namespace
{

using Json = nlohmann::ordered_json;

Json
repairJson(const LabelCheck::Repair & repair)
{
  Json json{ { "possible", repair.refusal.empty() } };
  if (!repair.refusal.empty())
  {
    json["refusal"] = repair.refusal;
    return json;
  }
  json["changed_percent"] = 100.0 * repair.report.changedFraction();
  json["voxels_added"] = repair.report.voxelsAdded;
  json["voxels_removed"] = repair.report.voxelsRemoved;
  json["changes"] = changesJson(repair.report.changes, repair.report.voxelVolume);
  return json;
}

Json
checkJson(const LabelCheck & check)
{
  const LabelDiagnosis & found = check.diagnosis;
  Json                   json;
  json["name"] = check.name;
  json["labels"] = check.labels;
  json["voxels"] = found.voxels;
  json["volume_mm3"] = found.volume;
  json["first_index"] = found.firstIndex;
  json["last_index"] = found.lastIndex;
  json["ball"] = found.isBall();
  json["topology"] = topologyJson(found.topology);
  json["component_voxels"] = found.componentVoxels;
  json["cavity_voxels"] = found.cavityVoxels;
  json["largest_component"] = topologyJson(found.largestComponent);
  json["non_manifold_edges"] = found.nonManifoldEdges;
  json["non_manifold_vertices"] = found.nonManifoldVertices;
  json["borders"] = found.borders.names();
  json["depth_mm"] = found.depth;
  json["repair"] = repairJson(check.repair);
  return json;
}

} // namespace

std::string
toJson(const CheckReport & report)
{
  Json json{ { "file", report.file }, { "max_repair_percent", report.maximumRepairPercent } };
  json["labels"] = Json::array();
  for (const LabelCheck & check : report.checks)
  {
    json["labels"].push_back(checkJson(check));
  }
  json["warning_count"] = report.warnings.size();
  json["warnings"] = report.warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void
writeCheckReport(const std::string & fileName, const CheckReport & report)
{
  writeTextFile(fileName, toJson(report));
}

} // namespace moserhex
