#pragma once

#include "moserhex/HexMeshIO/InputChecksum.h"

#include <string>

namespace moserhex::app
{

/** A file that is read, and what is in it. */
struct InputFile
{
  std::string name;   ///< as given; empty: none
  std::string sha256; ///< sha256OfInput
};

/** To be called where the file is read, so that the checksum is of what was compared. \throws as sha256OfInput */
[[nodiscard]] inline InputFile
inputFile(const std::string & name)
{
  return { name, sha256OfInput(name) };
}

} // namespace moserhex::app
