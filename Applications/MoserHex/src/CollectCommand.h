#pragma once

#include "CaseList.h"

#include <string>

namespace moserhex::app
{

struct CollectCommandOptions
{
  CaseListOptions cases;    ///< in whose outputFolder the reports are; no inputs: the reports there are the cases
  std::string     csvFile;  ///< empty: summary.csv in that folder
  std::string     jsonFile; ///< empty: summary.json in that folder
  std::string     pageFile; ///< HTML; empty: summary.html in that folder, where this program can write pages
  bool            quiet{ false };
};

/** Reads the reports of many runs of `mesh`, writes the table of the cases, the group's figures and a page
 * with both, prints the figures.
 * \return the exit code: 0 all cases are done, 1 some are not
 * \throws UsageError, BadInput, IOError */
[[nodiscard]] int
runCollectCommand(const CollectCommandOptions & options);

} // namespace moserhex::app
