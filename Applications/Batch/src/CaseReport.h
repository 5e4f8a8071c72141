#pragma once

#include "MeshRecord.h"

#include <map>
#include <optional>
#include <string>

namespace moserhex::app
{

/** What a summary takes from the report of a run. */
struct CaseReport
{
  bool                          meshed{ false };
  std::string                   code;    ///< of a failure
  std::string                   message; ///< of a failure
  std::string                   inputFile;
  std::string                   meshFile;
  std::string                   labels; ///< "3", "1 2"; empty: not read
  std::string                   labelName;
  std::string                   outline; ///< of the mesh, see RunReport
  std::map<std::string, double> figures; ///< all of summaryFigures(); NaN where the report has no number
};

/** Reads a report that `mesh` wrote. Empty when there is no such file, when it is damaged or too large, or when another
 * program wrote it. */
[[nodiscard]] std::optional<CaseReport>
readCaseReport(const std::string & fileName);

/** A text as a report holds it: what is not UTF-8 becomes replacement characters. */
[[nodiscard]] std::string
asInReport(const std::string & text);

} // namespace moserhex::app
