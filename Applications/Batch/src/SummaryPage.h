#pragma once

#include "Summary.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Writes the summary as a page to look at; see writeGroupPage. Links to the pages of cases are relative to it.
 * \throws IOError; InvalidInput (Usage)  a program without pages */
void
writeSummaryPage(const std::string & fileName, const std::vector<SummaryRow> & rows);

} // namespace moserhex::app
