#pragma once

#include "MeshOptions.h"

namespace moserhex::app
{

/** Meshes one label, or all together, writes the mesh and the report, prints the quality table.
 * \throws UsageError, BadInput, NoMeshError, IOError */
void
runMeshCommand(const MeshCommandOptions & options);

} // namespace moserhex::app
