#include "moserhex/HexMeshIO/HexSurfaceWriter.h"

#include "FileNames.h"
#include "HexMeshSets.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <limits>
#include <sstream>
#include <vector>

namespace moserhex
{
namespace
{

/** Numbers of the boundary's nodes among themselves, by node of the mesh; -1: inside. */
std::vector<int>
numbersOnBoundary(const HexMesh & mesh)
{
  std::vector<int> numbers(mesh.nodes.size(), -1);
  int              count = 0;
  for (const std::size_t node : boundaryNodes(mesh))
  {
    numbers[node] = count++;
  }
  return numbers;
}

} // namespace

void
writeHexSurface(const std::string & fileName, const HexMesh & mesh)
{
  if (!endsWith(fileName, ".vtk"))
  {
    throw BadInput(
      ErrorCode::Usage, fileName, "surfaces are written as legacy VTK files", "give a name that ends with .vtk");
  }
  requireValid(mesh);
  const auto             n = static_cast<std::size_t>(mesh.nodesPerSide);
  const std::size_t      count = boundaryNodeCount(mesh.nodesPerSide);
  const std::vector<int> numbers = numbersOnBoundary(mesh);
  const auto             nodes = nodeIndices(mesh);
  const auto             faces = cubeFaces(mesh);
  std::ostringstream     points;
  std::ostringstream     indices;
  std::ostringstream     polygons;
  std::ostringstream     cubeFace;
  points.precision(std::numeric_limits<double>::max_digits10);
  for (std::size_t node = 0; node < numbers.size(); ++node)
  {
    if (numbers[node] >= 0)
    {
      const Vector3 & p = mesh.nodes[node];
      points << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
      const auto & at = nodes[node].lattice;
      indices << at[0] << ' ' << at[1] << ' ' << at[2] << '\n';
    }
  }
  for (std::size_t face = 0; face < faces.size(); ++face)
  {
    for (const CubeFaceSide & side : faces[face].sides)
    {
      polygons << 4;
      for (const std::size_t node : side.nodes)
      {
        polygons << ' ' << numbers[node];
      }
      polygons << '\n';
      cubeFace << face << '\n';
    }
  }
  const std::size_t  quads = 6 * (n - 1) * (n - 1);
  std::ostringstream text;
  text << "# vtk DataFile Version 4.2\nMoserHex surface of a hexahedral mesh; SPACE=LPS\nASCII\nDATASET POLYDATA\n"
       << "POINTS " << count << " double\n"
       << points.str() << "POLYGONS " << quads << ' ' << 5 * quads << '\n'
       << polygons.str() << "CELL_DATA " << quads << "\nSCALARS CubeFace int 1\nLOOKUP_TABLE default\n"
       << cubeFace.str() << "POINT_DATA " << count << "\nFIELD FieldData 1\nLatticeIndex 3 " << count << " int\n"
       << indices.str();
  writeTextFile(fileName, text.str());
}

} // namespace moserhex
