#pragma once

#include "MeshRun.h"
#include "moserhex/HexMeshIO/RunReport.h"

#include <functional>
#include <string>

namespace moserhex::app
{

/** A file that has been meshed. */
struct MeshedFile
{
  ChosenSolid           solid;
  PipelineType::Pointer pipeline; ///< with the mesh
  RunReport             report;   ///< complete, with all warnings
};

/** Meshes one label, or all together, and writes the mesh and the report; prints nothing.
 * \param progress  may be empty
 * \param comment   is told what is being done; may be empty
 * \throws UsageError, BadInput, NoMeshError, IOError */
[[nodiscard]] MeshedFile
meshFile(const MeshCommandOptions &                       options,
         const ProgressFunction &                         progress,
         const std::function<void(const std::string &)> & comment = {});

} // namespace moserhex::app
