#pragma once

#include "CaseList.h"
#include "CaseProcess.h"

#include <string>
#include <vector>

namespace moserhex::app
{

struct BatchCommandOptions
{
  CaseListOptions          list;
  unsigned int             jobs{ 0 };    ///< cases at once; 0: one for each of the machine's threads
  unsigned int             threads{ 0 }; ///< of each case; 0: the machine's, shared by the jobs
  CaseLimits               limits;
  std::string              shard; ///< "K/M": every M-th case from the K-th; empty: all
  bool                     retryFailed{ false };
  bool                     dryRun{ false };
  bool                     verify{ false };
  bool                     casePages{ false }; ///< a page (HTML) for each case beside its report
  bool                     reproducible{ false };
  bool                     quiet{ false };
  std::string              listCasesFile; ///< only write the list of cases there; empty: no
  std::vector<std::string> program;       ///< is run with the arguments of `mesh`; empty: this program
};

/** Makes the meshes of many files, each in a process of its own, resumes what an earlier run began, and writes a
 * summary; or only says what it would do, checks finished meshes, or lists the cases.
 * \return exit status: 0 all cases are done, 1 some failed or are damaged, 74 no room, 128 + the signal that stopped it
 * \throws UsageError, BadInput, IOError  before any work */
[[nodiscard]] int
runBatchCommand(const BatchCommandOptions & options);

} // namespace moserhex::app
