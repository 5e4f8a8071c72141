#pragma once

#include "CommandErrors.h"
#include "SameFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <string>

namespace moserhex::app
{

/** \throws UsageError  no ending of a mesh that can be written */
inline void
requireHexMeshName(const std::string & output)
{
  if (!isHexMeshName(output))
  {
    throw UsageError(
      fileMessage(output, "not a mesh file's name", std::string("give an OUTPUT that ends with ") + hexMeshEndings));
  }
}

/** \throws UsageError  the output is the input; either may be empty */
inline void
requireKept(const std::string & input, const std::string & output)
{
  if (sameFile(input, output))
  {
    throw UsageError(fileMessage(input, "would be overwritten", "give another name for the output"));
  }
}

} // namespace moserhex::app
