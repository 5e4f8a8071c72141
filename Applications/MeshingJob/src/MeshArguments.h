#pragma once

#include "MeshOptions.h"

#include <string>
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

} // namespace moserhex::app
