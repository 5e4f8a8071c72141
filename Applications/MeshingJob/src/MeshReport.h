#pragma once

#include "MeshRun.h"
#include "moserhex/HexMeshIO/RunReport.h"

namespace moserhex::app
{

/** What is known before anything is read: names of files, options and versions. */
[[nodiscard]] RunReport
startReport(const MeshCommandOptions & options);

/** What was read, with its warnings. */
void
addSolid(const ChosenSolid & solid, RunReport & report);

/** What the run did and made; of a density, what it is on the label. */
void
addResults(const PipelineType & pipeline, const PipelineInputs & inputs, RunReport & report);

/** The quality table, then what was meshed and how well, then where the files are. */
void
printSummary(const RunReport & report, const ChosenSolid & solid, const MeshCommandOptions & options);

} // namespace moserhex::app
