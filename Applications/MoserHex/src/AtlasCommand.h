#pragma once

#include "AtlasOptions.h"

namespace CLI
{
class App;
}

namespace moserhex::app
{

struct AtlasCommandOptions : AtlasOptions
{
  std::string alignmentName{ "rigid" };
  std::string modes{ "95%" };         ///< a number of modes, or a part of the variance with %
  bool        areModesGiven{ false }; ///< on the command line
};

/** Adds `atlas` to the program. */
[[nodiscard]] const CLI::App *
addAtlasCommand(CLI::App & program, AtlasCommandOptions & options);

/** Analyses, projects or reconstructs, writes the files and prints what came out.
 * \throws UsageError, BadInput, IOError; NoMeshError  the mean mesh is not exact (all is written) */
void
runAtlasCommand(AtlasCommandOptions options);

} // namespace moserhex::app
