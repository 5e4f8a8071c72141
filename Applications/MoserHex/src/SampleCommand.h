#pragma once

#include <string>

namespace moserhex::app
{

/** Writes prostate.nrrd, prostate_zones.nrrd and prostate_followup.nrrd to a folder, which is made when missing, and
 * says so on the standard output. \throws IOError */
void
runSampleCommand(const std::string & folder, bool quiet);

} // namespace moserhex::app
