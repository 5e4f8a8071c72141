#pragma once

#include "CellField.h"

#include <string>

namespace moserhex::app
{

/** Meshes of more nodes a side are not put into pages: 32 shells. */
inline constexpr int mostNodesPerSide = 64;

/** A mesh and the numbers of its cells as JSON for the 3-D view.
 *
 *   nodesPerSide, paddingLayers, cells
 *   positions   { low: [x,y,z], step: [x,y,z], data: base64 of uint16, little endian }: low + step * data [mm, LPS]
 *   padding     { nodes: base64 of uint32, 8 a cell in VTK's order; index: base64 of uint16, i j k of the lattice cell
 *               below }; left out where there is none
 *   fields      [{ id, name, low, high, acceptable: [low, high] or null, values: { low, step, data } }], low and high
 *               the ends of the colours
 *
 * Positions and values are rounded to 1/65535 of their range: for looking at, not for computing.
 * \throws InvalidInput  more than mostNodesPerSide nodes a side */
[[nodiscard]] std::string
meshDataJson(const HexMesh & mesh, const std::vector<CellField> & fields);

} // namespace moserhex::app
