#pragma once

#include "Seeds.h"

#include <string>

namespace moserhex::fuzz
{

enum class Answer
{
  Refused, ///< by moserhex::Error, or ITK's form of it, with one short line
  Taken,   ///< read, measured and, where asked for, meshed
  Finding  ///< anything else: another exception, a message that is no short line
};

struct EndToEndResult
{
  Answer      answer{ Answer::Finding };
  std::string text; ///< the message, what was found, or a fingerprint of all that was read
};

/** What the commands do with an input file: read it, take a label's voxels and their topology, voxelise, measure the
 * quality of hexahedra, take a field's value, or list points; then, of labels and surfaces and when asked for, the
 * whole pipeline with three shells. Throws nothing. */
[[nodiscard]] EndToEndResult
readEndToEnd(const std::string & fileName, SeedUse use, bool withPipeline);

} // namespace moserhex::fuzz
