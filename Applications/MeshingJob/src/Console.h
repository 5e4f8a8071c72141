#pragma once

#include "moserhex/Common/ErrorCode.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <string>

namespace moserhex::app
{

/** Progress on the standard output: a bar on a terminal, a line for every tenth otherwise, nothing when quiet. */
class ProgressPrinter
{
public:
  explicit ProgressPrinter(bool quiet);
  ~ProgressPrinter();
  ProgressPrinter(const ProgressPrinter &) = delete;
  ProgressPrinter &
  operator=(const ProgressPrinter &) = delete;

  /** \param fraction  done, in [0,1]; going back is ignored */
  void
  show(double fraction);

private:
  void
  clearBar();

  bool m_Quiet;
  bool m_Terminal;
  int  m_LastStep{ -1 };
};

/** One line "warning: ..." of at most 200 characters on the standard error output. */
void
printWarning(const std::string & text);

/** The same with " [E_...]" at its end, of a failure that does not end the program. */
void
printWarning(ErrorCode code, const std::string & text);

/** One line "error: ... [E_...]" of at most 200 characters on the standard error output. */
void
printError(ErrorCode code, const std::string & text);

/** The quality table, one row per stage, and the total time. */
void
printQualityTable(const RunReport & report);

} // namespace moserhex::app
