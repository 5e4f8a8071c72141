#pragma once

#include "moserhex/HexMeshIO/HexCellReader.h"

#include <optional>
#include <string>

namespace moserhex::app
{

/** A mesh that is drawn. */
struct DrawnMesh
{
  UnstructuredHexMesh    cells;
  std::optional<HexMesh> lattice; ///< the same, where it is one
  std::string            fileName;
  HexCellArrays          arrays{}; ///< to colour by
};

} // namespace moserhex::app
