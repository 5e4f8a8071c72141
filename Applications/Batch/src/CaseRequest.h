#pragma once

#include "MeshOptions.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex::app
{

/** An input as the command line or a list gives it: a case, or one for each label. */
struct CaseRequest
{
  MeshCommandOptions       options;            ///< of which output and reportFile are not set
  bool                     allLabels{ false }; ///< a mesh of each label
  std::string              base;               ///< the output mirrors the input's path below it
  std::string              output;             ///< relative to the output folder; empty: mirrored
  std::vector<std::string> kept;

  std::string list;      ///< that it stands in; empty: on the command line or in a folder
  std::size_t line{ 0 }; ///< of the list
};

/** \throws UsageError  names the list and the line, or the input when there is no list */
[[noreturn]] void
refuse(const CaseRequest & request, const std::string & cause, const std::string & remedy);

/** The whole message of a usage error: short enough for the line that is printed. */
[[nodiscard]] std::string
usageMessage(const std::string & file, const std::string & cause, const std::string & remedy);

/** A name for the middle of a message: its end, where it is longer. */
[[nodiscard]] std::string
shortName(const std::string & name, std::size_t longest = 40);

} // namespace moserhex::app
