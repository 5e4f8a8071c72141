#pragma once

#include "moserhex/HexMeshIO/HexCellReader.h"

#include <string>

namespace moserhex
{

// One reader per format, each in a file of its own. All throw as readHexCells, which has checked that the file is
// there.

[[nodiscard]] HexCellFile
readVtkCells(const std::string & fileName);

[[nodiscard]] HexCellFile
readVtkCellsWithArrays(const std::string & fileName);

[[nodiscard]] HexCellFile
readGmshCells(const std::string & fileName);

[[nodiscard]] HexCellFile
readMeditCells(const std::string & fileName);

[[nodiscard]] HexCellFile
readAbaqusCells(const std::string & fileName);

} // namespace moserhex
