#pragma once

#include "AtlasRun.h"

#include <string>

namespace moserhex::app
{

/** Writes what came out of an analysis as a page to look at: the subjects with their numbers and outlines, the model,
 * the tests, and the mean mesh in 3-D with the subjects' standard deviation. \throws IOError; InvalidInput (Usage)  a
 * program without pages */
void
writeAtlasPage(const std::string & fileName, const AtlasResult & result);

} // namespace moserhex::app
