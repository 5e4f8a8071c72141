#pragma once

#include "TimeSeries.h"

namespace CLI
{
class App;
}

namespace moserhex::app
{

/** Adds `compare` and its options. */
CLI::App *
addCompareCommand(CLI::App & program, CompareCommandOptions & options);

/** Measures what has changed between a baseline and its follow-ups, writes series.pvd and its meshes, regions.csv and
 * summary.json into the output folder, and prints a table.
 * \throws UsageError, BadInput, InvalidInput, IOError */
void
runCompareCommand(const CompareCommandOptions & options);

} // namespace moserhex::app
