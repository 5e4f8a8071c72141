#pragma once

#include "ChosenSolid.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** One of the labels of a file. */
struct LabelChoice
{
  std::string                text; ///< in file names: its name's ASCII letters and digits, or its number
  std::string                name; ///< in the file; may be empty
  std::optional<LabelValue>  label;
  std::optional<std::string> segment; ///< where segments overlap, in place of the label
};

/** The labels of a labelmap that have voxels, ascending; of a .seg.nrrd in layers its segments, in their order. Texts
 * are unique, upper and lower case alike: to those that would be the same the label's number is added, or the
 * segment's, counted from 1. Empty for surfaces and for files whose labels cannot be read.
 * \note Reads the whole file; see readLabelImage about threads. */
[[nodiscard]] std::vector<LabelChoice>
labelChoicesOf(const InputOptions & input);

} // namespace moserhex::app
