#pragma once

#include "CellField.h"

#include <string>

namespace moserhex::app
{

/** The 3-D view of a mesh with its controls, and the mesh for it. Of a mesh that is too large for a page, a sentence
 * that says so. */
[[nodiscard]] std::string
viewerSection(const HexMesh & mesh, const std::vector<CellField> & fields);

} // namespace moserhex::app
