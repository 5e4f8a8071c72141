#pragma once

#include "moserhex/HexMeshIO/RunReport.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Whether a mesh can be trusted. The worst reason decides. */
enum class Trust
{
  Trust,    ///< everything that the run promises was reached
  LookAtIt, ///< something was changed or is unusual: look before using it
  DoNotUse  ///< no mesh, or one with cells that are turned inside out
};

struct Assessment
{
  struct Reason
  {
    Trust       trust{ Trust::Trust };
    std::string text;
  };

  Trust               trust{ Trust::Trust };
  std::vector<Reason> reasons; ///< the worst first
};

/** More than this was changed by the repair of the label's topology: a reason to look [%]. */
inline constexpr double muchRepair = 1.0;

/** Less than this Dice coefficient of the smoothed solid and the label: a reason to look [1]. */
inline constexpr double littleDice = 0.98;

/** More than this difference of the mesh's volume and the label's as it was meshed: a reason to look [%]. */
inline constexpr double muchVolumeError = 1.0;

/** Judges a run by its report alone. */
[[nodiscard]] Assessment
assess(const RunReport & report);

/** "Trust", "Look at it", "Do not use" */
[[nodiscard]] const char *
nameOf(Trust trust);

} // namespace moserhex::app
