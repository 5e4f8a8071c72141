#pragma once

#include "MeshRun.h"
#include "moserhex/HexMeshIO/RunReport.h"

namespace moserhex::app
{

/** What is known before the run: the input, whose checksum is given, the options and the versions. */
[[nodiscard]] RunReport
startReport(const ChosenSolid & solid, const std::string & sha256, const MeshCommandOptions & options);

/** What the run did and made; of a density, what it is on the label. */
void
addResults(const PipelineType & pipeline, RunReport & report);

/** The quality table, then what was meshed and how well, then where the files are. */
void
printSummary(const RunReport & report, const ChosenSolid & solid, const MeshCommandOptions & options);

} // namespace moserhex::app
