#pragma once

#include "CaseList.h"
#include "CaseRequest.h"

#include <set>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Whether the name is that of a list: .csv .tsv .txt (any case). */
[[nodiscard]] bool
isListName(const std::string & fileName);

/** Whether a column of this name means something to the batch: input, output or an option of `mesh`. */
[[nodiscard]] bool
isListOption(const std::string & column);

/** The rows of a list. An empty cell, or n/a as BIDS has it, leaves an option as it is in `options`; the label `all`
 * stands for allLabels. Inputs and densities are relative to the list's folder, which is the base.
 * \param found  gets the list's columns
 * \throws UsageError, BadInput, IOError  see listCases */
[[nodiscard]] std::vector<CaseRequest>
requestsOfList(const std::string & list, const CaseListOptions & options, std::set<std::string> & found);

} // namespace moserhex::app
