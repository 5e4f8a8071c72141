#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/NamedArray.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** What is written beside the mesh. LatticeIndex (node), Shell and VolumeRatio (cell) are always there. */
struct HexMeshFields
{
  std::vector<double> scaledJacobian; ///< per cell, written as ScaledJacobian; empty: left out

  std::vector<std::int32_t> label; ///< per cell, written as Label; empty: left out

  std::vector<NamedArray> pointArrays; ///< per node; .vtu and .vtk only
  std::vector<NamedArray> cellArrays;  ///< per cell; .vtu and .vtk only
  std::vector<NamedArray> meshArrays;  ///< once for the mesh, VTK's field data; .vtu and .vtk only
};

/** Versions of the format MSH. */
enum class GmshVersion
{
  Msh41, ///< 4.1
  Msh22  ///< 2.2
};

/** Options of writeHexMesh. */
struct HexMeshWriterOptions
{
  bool        spaceTag{ true }; ///< .vtu only: field array SPACE = "LPS", which Slicer wants and meshio does not read
  GmshVersion gmshVersion{ GmshVersion::Msh41 }; ///< .msh only
};

/** The endings that writeHexMesh takes, for messages and help texts. */
inline constexpr const char * hexMeshEndings = ".vtu .vtk .msh .inp .mesh .feb or .exo";

/** Whether the name ends with one of hexMeshEndings (any case). */
[[nodiscard]] bool
isHexMeshName(const std::string & fileName);

/** Whether a file of that name holds named arrays: .vtu and .vtk (any case). */
[[nodiscard]] bool
holdsNamedArrays(const std::string & fileName);

/** Writes a mesh in the format of the name's ending, complete or not at all.
 *
 *   .vtu    VTK, appended, zlib
 *   .vtk    VTK legacy 4.2, binary, SPACE=LPS in its second line, neither METADATA nor string arrays
 *   .msh    Gmsh 4.1, or 2.2 by the options, ASCII; physical groups: faces and shells
 *   .inp    Abaqus and CalculiX: C3D8, element sets ALL SHELL_1 ... SHELL_N, node sets ALL and the faces
 *   .mesh   MEDIT, ASCII; references: 1 to 6 of the faces' quadrilaterals, shell of the hexahedra
 *   .feb    FEBio 4.0: one part a shell, node sets and surfaces of the faces, a placeholder for the material
 *   .exo    Exodus II: one block a shell, node sets and side sets of the faces, one time step
 *
 * Faces: FACE_I0 FACE_I1 FACE_J0 FACE_J1 FACE_K0 FACE_K1, nodes with i = 0, i = n-1, j = 0, ...; shells: 1 in the
 * middle to N = n/2 outermost. Numbers of nodes and cells are those of the lattice plus 1 (Exodus II: in its maps of
 * numbers).
 *
 * In .vtu, .vtk, .msh and .exo, point data: LatticeIndex (i,j,k), cell data: Shell, VolumeRatio (volume over the mean),
 * and what `fields` adds; in .msh a face's quadrilateral has the data of its cell. Coordinates are in LPS millimetres
 * and come back to the last bit; those of .inp have 20 characters at most, the formats' limit, and come back to 1e-15
 * mm. The file is read back and compared (nodes, connectivity, coordinates; .feb and .exo byte by byte) before it gets
 * its name. The same mesh gives the same bytes. All but VTK's formats take memory for the whole file.
 *
 * \throws InvalidInput  sizes do not fit, a coordinate is not finite, or the mean cell volume is not positive; a named
 *                       array has another number of components, no name or one that is taken, or another format
 * \throws BadInput      the name has none of the endings
 * \throws IOError       the file cannot be written (disk full, no permission) or reads back differently */
void
writeHexMesh(const std::string &          fileName,
             const HexMesh &              mesh,
             const HexMeshFields &        fields = {},
             const HexMeshWriterOptions & options = {});

} // namespace moserhex
