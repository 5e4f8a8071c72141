#pragma once

#include "CommandErrors.h"

#include <cstdint>
#include <optional>
#include <string>

namespace moserhex::app
{

struct MeshCommandOptions
{
  std::string                 input;
  std::string                 output;
  std::string                 reportFile; ///< empty: no report
  int                         shells{ 10 };
  std::optional<std::int32_t> label;
  std::string                 stage{ "exact" };      ///< initial | smoothed | moser | exact
  std::optional<std::string>  way;                   ///< fast (also when not given) | faithful
  std::string                 frame{ "anatomical" }; ///< anatomical | ridge
  std::string                 density;               ///< image of a positive density; empty: volumes
  bool                        allowPartial{ false }; ///< write a mesh that is not exact, with a warning
  std::string                 shellMethod{ "auto" }; ///< auto | chan-vese | snapshots | eikonal
  unsigned int                threads{ 0 };          ///< 0: all of the machine's
  bool                        quiet{ false };
};

/** Meshes one label, writes the mesh and the report, prints the quality table.
 * \throws UsageError, BadInput, NoMeshError, IOError */
void
runMeshCommand(const MeshCommandOptions & options);

} // namespace moserhex::app
