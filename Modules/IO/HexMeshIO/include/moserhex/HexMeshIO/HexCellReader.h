#pragma once

#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/NamedArray.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <string>
#include <vector>

namespace moserhex
{

/** Numbers that a mesh file holds, in the file's order and units, of any number of components. */
struct HexCellArrays
{
  std::vector<NamedArray> ofCells; ///< of the mesh's cells
  std::vector<NamedArray> ofNodes; ///< of the mesh's nodes
};

/** Hexahedra of a file, of any connectivity. */
struct HexCellFile
{
  UnstructuredHexMesh      mesh;     ///< nodes in the file's order, those of no hexahedron left out [mm]
  std::vector<std::string> warnings; ///< what was ignored, one line each
  HexCellArrays            arrays{}; ///< of readHexCellsWithArrays only
  /** What stands in the file once for the mesh: numbers of VTK's field data, of .vtu and .vtk only. */
  std::vector<NamedArray> meshArrays{};
};

/** Whether the name ends like a mesh this reader takes: .vtu .vtk .msh .mesh .inp (any case). */
[[nodiscard]] bool
isHexCellName(const std::string & fileName);

/** Reads the 8-node hexahedra of a mesh that any tool has written.
 *
 *   .vtu .vtk   VTK unstructured grid; SPACE=RAS is turned into LPS
 *   .msh        Gmsh 2.x and 4.1, ASCII and little-endian binary; cells in the order of their numbers
 *   .mesh       MEDIT, ASCII
 *   .inp        Abaqus and CalculiX: *NODE, *ELEMENT of a type C3D8..., without *INCLUDE, generated nodes or elements,
 *               coordinate systems and moved instances
 *
 * Coordinates are taken as LPS millimetres. Node numbers may have gaps. Points, edges and faces are ignored, and so are
 * nodes without a hexahedron; the warnings count them. Node order of a cell as in VTK_HEXAHEDRON, which is that of all
 * five formats. VTK's formats are read by VTK, in a child process unless options say otherwise. A cut file is refused
 * wherever the format has counts; .inp has none, and one that is cut between two lines looks whole.
 *
 * \throws BadInput  missing or damaged file; a count beyond what the file can hold; volume cells other than 8-node
 *                   hexahedra (names and counts); no hexahedron; a node missing, given twice or twice in one cell; a
 *                   coordinate that is not finite or beyond 1e9 mm; more than 2^31 - 1 nodes; the child died
 * (ReaderFailed) \throws IOError   the file cannot be opened or read */
[[nodiscard]] HexCellFile
readHexCells(const std::string & fileName, const ReadOptions & options = {});

/** The same, with the numbers at cells and points of .vtu and .vtk files; of other formats there are none. Arrays
 * without name and of words are left out. Vectors of a file with SPACE=RAS are not turned: which of them are places or
 * directions it does not say.
 * \throws as readHexCells; BadInput (NotHexahedra)  an array is not as long as the cells or points are many */
[[nodiscard]] HexCellFile
readHexCellsWithArrays(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
