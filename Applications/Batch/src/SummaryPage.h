#pragma once

#include "Summary.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Of the page of a folder: "Meshes in NAME". */
[[nodiscard]] std::string
summaryHeading(const std::string & folder);

/** Writes the summary as a page to look at; see writeGroupPage. Links to the pages of cases are relative to it.
 * \param heading  of the page \throws IOError; InvalidInput (Usage)  a program without pages */
void
writeSummaryPage(const std::string & fileName, const std::string & heading, const std::vector<SummaryRow> & rows);

} // namespace moserhex::app
