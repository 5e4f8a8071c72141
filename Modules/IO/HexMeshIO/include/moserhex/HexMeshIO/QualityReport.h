#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/Quality/LabelAgreement.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** Quality of one mesh file, and how it fills a label: what the command `quality` finds. */
struct QualityReport
{
  /** The label that the mesh is compared with. */
  struct Label
  {
    std::string               file;      ///< that it was read from
    std::vector<std::int64_t> labels;    ///< one, or those that were taken together
    std::string               name;      ///< for people
    LabelAgreement            agreement; ///< of the mesh with it
  };

  std::string              file;       ///< of the mesh
  std::size_t              nodes{ 0 }; ///< of the mesh
  HexQualitySummary        quality;    ///< of the cells
  std::optional<Label>     label;      ///< empty: the mesh was compared with none
  std::vector<std::string> warnings;   ///< one line each
};

/** The report as JSON: keys in a fixed order, numbers with round-trip precision in the C locale, non-finite numbers as
 * null, text that is not UTF-8 with replacement characters. */
[[nodiscard]] std::string
toJson(const QualityReport & report);

/** Writes toJson(report), complete or not at all. \throws IOError */
void
writeQualityReport(const std::string & fileName, const QualityReport & report);

} // namespace moserhex
