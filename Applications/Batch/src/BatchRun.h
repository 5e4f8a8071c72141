#pragma once

#include "BatchPlan.h"
#include "CaseProcess.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace moserhex::app
{

struct BatchRunOptions
{
  std::vector<std::string> program;      ///< runs `mesh` with the arguments that are put behind it
  std::string              outputFolder; ///< exists
  std::string              journal;      ///< file
  unsigned int             jobs{ 1 };    ///< processes at once
  unsigned int             threadsOfCase{ 1 };
  CaseLimits               limits;
  bool                     reproducible{ false };
  bool                     quiet{ false };
};

/** Why a run ended before all its cases had. */
enum class BatchStop
{
  None,
  NoRoom, ///< the disk is full, or a quota or a limit of file sizes is reached
  Signal
};

struct BatchRunResult
{
  std::size_t done{ 0 };   ///< in this run
  std::size_t failed{ 0 }; ///< in this run
  std::size_t notRun{ 0 }; ///< left for the next one
  BatchStop   stop{ BatchStop::None };
  std::string stopReason;        ///< in words
  int         signalNumber{ 0 }; ///< that stopped it
};

/** Runs the cases that the plan wants run, each in a process of its own.
 *
 * A case is done when its process says so, its inputs are still those of the plan, and a journal line with the
 * checksums of mesh and report is on the disk. Whatever ends a process - a signal, its time, its memory - becomes the
 * failure of that case alone, with a report that says so and a line in the journal. A mesh that an earlier run made
 * with other inputs or options is removed when the case fails.
 *
 * Nothing more is started when there is no room for another case's files, or when a signal asks for an end; with a
 * signal, running cases are ended, too.
 *
 * \param plan  one for each case
 * \throws IOError  the journal cannot be created; a process cannot be started */
[[nodiscard]] BatchRunResult
runCases(const std::vector<BatchCase> & cases, const std::vector<PlannedCase> & plan, const BatchRunOptions & options);

} // namespace moserhex::app
