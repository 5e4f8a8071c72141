#pragma once

#include "MeshRun.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"
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

/** Scaled Jacobians, and the label that each cell mostly lies in where several are meshed together. */
[[nodiscard]] HexMeshFields
fieldsOf(const HexMesh & mesh, const ChosenSolid & solid, unsigned int threads);

/** Meshes one label, or all together, and writes the mesh, the report and the transform; prints nothing.
 * The report is written of failures, too, but for wrong usage and cancelled runs; the mesh's old file then stays.
 * \param progress  may be empty
 * \param comment   is told what is being done; may be empty
 * \throws UsageError, BadInput, NoMeshError, IOError, Cancelled */
[[nodiscard]] MeshedFile
meshFile(const MeshCommandOptions &                       options,
         const ProgressCallback &                         progress,
         const std::function<void(const std::string &)> & comment = {});

} // namespace moserhex::app
