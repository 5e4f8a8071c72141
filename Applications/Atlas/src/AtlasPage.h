#pragma once

#include "AtlasRun.h"

#include <string>

namespace moserhex::app
{

/** An analysis as a page to look at: the subjects with their numbers and outlines, the model and how far its meshes go,
 * the tests, the mean image in slices, and the mean mesh in 3-D with all that is known of its cells.
 * \throws InvalidInput (Usage)  a program without pages */
[[nodiscard]] std::string
atlasPage(const AtlasResult & result, const AtlasOptions & options);

/** Writes it, complete or not at all. \throws IOError; InvalidInput (Usage) */
void
writeAtlasPage(const std::string & fileName, const AtlasResult & result, const AtlasOptions & options);

} // namespace moserhex::app
