#pragma once

#include "moserhex/LevelSet/TopologyRepair.h"

#include <nlohmann/json.hpp>

namespace moserhex
{

/** A list of changes: kind, voxels, volume and place. \param voxelVolume  [mm^3] */
[[nodiscard]] inline nlohmann::ordered_json
changesJson(const std::vector<TopologyChange> & changes, double voxelVolume)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const TopologyChange & change : changes)
  {
    json.push_back({ { "kind", nameOf(change.kind) },
                     { "voxels", change.voxels },
                     { "volume_mm3", static_cast<double>(change.voxels) * voxelVolume },
                     { "centre_lps", { change.centre.x(), change.centre.y(), change.centre.z() } } });
  }
  return json;
}

[[nodiscard]] inline nlohmann::ordered_json
topologyJson(const VoxelTopology & topology)
{
  return { { "components", topology.components },
           { "cavities", topology.cavities },
           { "handles", topology.handles() },
           { "surface_euler_characteristic", topology.surfaceEulerCharacteristic() } };
}

} // namespace moserhex
