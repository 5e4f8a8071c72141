#pragma once

#include "AtlasOptions.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Brings the meshes of the inputs onto the mean of options.projectOnto, writes their scores (scores.csv in the output
 * folder, with what the model cannot express of each) and returns warnings.
 * \throws UsageError, BadInput  also for meshes of another lattice than the model's; IOError */
[[nodiscard]] std::vector<std::string>
projectMeshes(const AtlasOptions & options);

/** Makes a mesh, SUBJECT.vtu in the output folder, of every row of a table of scores: columns mode_1, mode_2, ... in
 * standard deviations, at least one of them; a missing column or cell is 0. `subject` gives the names, else, and where
 * it is missing, the row's number. Of the model's modes the first options.maximumModes are used or, where that is 0,
 * those that hold options.varianceFraction. \return warnings, of meshes with cells that are not certified
 * \throws UsageError, BadInput  also for a score that is no number, a mode that the model does not have, or two rows of
 * one name; IOError */
[[nodiscard]] std::vector<std::string>
reconstructMeshes(const AtlasOptions & options);

} // namespace moserhex::app
