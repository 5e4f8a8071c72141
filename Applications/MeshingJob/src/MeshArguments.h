#pragma once

#include "MeshOptions.h"

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace moserhex::app
{

/** Which solid of a file: the same options for all commands. */
void
addSolidOptions(CLI::App & command, InputOptions & options);

void
addMaximumRepair(CLI::App & command, double & percent);

/** What `moserhex mesh` can be told about the solid and the mesh: all its options but files, threads and quiet. */
void
addMeshingOptions(CLI::App & command, MeshCommandOptions & options);

/** The long names of those options, without dashes. */
[[nodiscard]] const std::vector<std::string> &
meshingOptionNames();

/** Sets options as the command line would, by their long names without dashes; flags take true and false.
 * \throws UsageError  no such option, no such value; names the option */
void
setMeshingOptions(const std::vector<std::pair<std::string, std::string>> & values, MeshCommandOptions & options);

/** Whether the value of one of those options is the name of a file. */
[[nodiscard]] bool
isFileOption(const std::string & name, const std::string & value);

/** A command line that gives these options, each as --name=value, those that have no value left out: the same for the
 * same options, whatever the defaults are. */
[[nodiscard]] std::vector<std::string>
meshingArguments(const MeshCommandOptions & options);

} // namespace moserhex::app
