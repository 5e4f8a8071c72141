#pragma once

#include "CaseList.h"

#include <string>

namespace moserhex::app
{

/** The reports of `mesh` in a folder and below it as cases, sorted by their paths. Other files, hidden ones and what is
 * behind links to folders are left out. The mesh of PATH/NAME.json is PATH/NAME.vtu, with the ending of the mesh that
 * the report names; where that is not there, the mesh of the report's name beside the report, or that very file.
 * \param threads  to read with; 0: all of the machine's
 * \throws BadInput  the folder is missing, may not be read or holds no report; IOError */
[[nodiscard]] CaseList
casesOfReports(const std::string & folder, unsigned int threads);

} // namespace moserhex::app
