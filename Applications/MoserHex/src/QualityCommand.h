#pragma once

#include "ChosenSolid.h"

#include <string>

namespace moserhex::app
{

struct QualityCommandOptions
{
  std::string  mesh;
  InputOptions labelImage; ///< no file: the mesh is not compared with a label
  std::string  jsonFile;   ///< empty: none
  unsigned int threads{ 0 };
  bool         quiet{ false };
};

/** Prints the quality of a hexahedral mesh of any tool, and how it fills a label; writes both as JSON.
 * \throws UsageError, BadInput, IOError */
void
runQualityCommand(const QualityCommandOptions & options);

} // namespace moserhex::app
