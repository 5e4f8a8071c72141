#pragma once

#include "ChosenSolid.h"

#include <optional>
#include <string>

namespace moserhex::app
{

struct MeshCommandOptions
{
  InputOptions               input;
  std::string                output;
  std::string                reportFile; ///< empty: no report
  int                        shells{ 10 };
  std::string                stage{ "exact" };            ///< initial | smoothed | moser | exact
  std::optional<std::string> way;                         ///< fast (also when not given) | faithful
  int                        padding{ 0 };                ///< layers of pillow cells around the lattice
  std::string                frame{ "anatomical" };       ///< anatomical | ridge
  std::string                density;                     ///< image of a positive density; empty: volumes
  bool                       allowPartial{ false };       ///< write a mesh that is not exact, with a warning
  std::string                shellMethod{ "auto" };       ///< auto | chan-vese | snapshots | eikonal
  std::string                topology{ "repair" };        ///< repair | reject
  double                     maximumRepairPercent{ 5.0 }; ///< of the label's voxels
  unsigned int               threads{ 0 };                ///< 0: all of the machine's
  bool                       quiet{ false };
};

/** fast | faithful */
[[nodiscard]] std::string
wayOf(const MeshCommandOptions & options);

} // namespace moserhex::app
