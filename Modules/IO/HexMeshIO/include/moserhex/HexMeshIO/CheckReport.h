#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/LabelDiagnosis.h"
#include "moserhex/LevelSet/TopologyRepair.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** One label's diagnosis, and the repair of its topology as it would be. */
struct LabelCheck
{
  /** What repairTopology would do. */
  struct Repair
  {
    TopologyRepairReport report;  ///< without changes for a label that is a ball
    std::string          refusal; ///< why it would be refused; empty: it would not
  };

  std::string               name;      ///< for people
  std::vector<std::int64_t> labels;    ///< one, or those that were taken together
  LabelDiagnosis            diagnosis; ///< of the voxels as they are
  Repair                    repair;    ///< of their topology; not made
};

/** What the command check found, as JSON. Lengths in mm, LPS. */
struct CheckReport
{
  std::string              file;                        ///< that was checked
  double                   maximumRepairPercent{ 0.0 }; ///< of the voxels of a label that a repair may change [%]
  std::vector<LabelCheck>  checks;                      ///< one a label, or one of all taken together
  std::vector<std::string> warnings;                    ///< of the reader, one line each
};

/** The report as JSON: keys in a fixed order, numbers with round-trip precision in the C locale. */
[[nodiscard]] std::string
toJson(const CheckReport & report);

/** Writes toJson(report), complete or not at all. \throws IOError */
void
writeCheckReport(const std::string & fileName, const CheckReport & report);

} // namespace moserhex
