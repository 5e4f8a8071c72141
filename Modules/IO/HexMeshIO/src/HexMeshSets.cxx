#include "HexMeshSets.h"

#include "moserhex/Geometry/HexMeshNumbering.h"

#include <algorithm>

namespace moserhex
{
namespace
{

struct FaceDescription
{
  const char *               name;
  int                        axis;    ///< 0 i, 1 j, 2 k
  bool                       last;    ///< at n-1, not at 0
  std::array<std::size_t, 4> corners; ///< of a cell in VTK_HEXAHEDRON order, counter-clockwise seen from outside
};

constexpr std::array<FaceDescription, 6> faceDescriptions{ {
  { "FACE_I0", 0, false, { 0, 4, 7, 3 } },
  { "FACE_I1", 0, true, { 1, 2, 6, 5 } },
  { "FACE_J0", 1, false, { 0, 1, 5, 4 } },
  { "FACE_J1", 1, true, { 3, 7, 6, 2 } },
  { "FACE_K0", 2, false, { 0, 3, 2, 1 } },
  { "FACE_K1", 2, true, { 4, 5, 6, 7 } },
} };

/** The cells that have a side on a face of the cube, ascending. */
std::vector<std::size_t>
cellsOnFace(const HexMesh & mesh, const FaceDescription & face, std::size_t number)
{
  const auto               m = static_cast<std::size_t>(mesh.nodesPerSide - 1);
  std::vector<std::size_t> cells;
  cells.reserve(m * m);
  const std::size_t wanted = face.last ? m - 1 : 0;
  const std::size_t ofPadding = mesh.cellCount() - (6 - number) * m * m;
  for (std::size_t second = 0; second < m; ++second)
  {
    for (std::size_t first = 0; first < m; ++first)
    {
      const std::array<std::size_t, 3> steps[] = { { wanted, first, second },
                                                   { first, wanted, second },
                                                   { first, second, wanted } };
      const std::array<std::size_t, 3> at = steps[face.axis];
      cells.push_back(mesh.paddingLayers > 0 ? ofPadding + first + m * second : at[0] + m * (at[1] + m * at[2]));
    }
  }
  return cells;
}

std::vector<std::size_t>
nodesOnFace(const std::vector<CubeFaceSide> & sides)
{
  std::vector<std::size_t> nodes;
  for (const CubeFaceSide & side : sides)
  {
    nodes.insert(nodes.end(), side.nodes.begin(), side.nodes.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

} // namespace

std::array<CubeFace, 6>
cubeFaces(const HexMesh & mesh)
{
  std::array<CubeFace, 6> faces;
  for (std::size_t number = 0; number < faces.size(); ++number)
  {
    const FaceDescription & description = faceDescriptions[number];
    CubeFace &              face = faces[number];
    face.name = description.name;
    for (const std::size_t cell : cellsOnFace(mesh, description, number))
    {
      const auto    nodes = mesh.cellNodes(cell);
      Quadrilateral side{};
      std::transform(description.corners.begin(), description.corners.end(), side.begin(), [&nodes](std::size_t c) {
        return nodes[c];
      });
      face.sides.push_back({ cell, side });
    }
    face.nodes = nodesOnFace(face.sides);
  }
  return faces;
}

std::vector<int>
paddingLayerOfNodes(const HexMesh & mesh)
{
  std::vector<int> layers;
  for (const NodeIndex & index : nodeIndices(mesh))
  {
    layers.push_back(index.layer);
  }
  return layers;
}

std::vector<std::vector<std::size_t>>
cellsOfShells(const std::vector<int> & shellOfCell)
{
  const int                             count = *std::max_element(shellOfCell.begin(), shellOfCell.end());
  std::vector<std::vector<std::size_t>> shells(static_cast<std::size_t>(count));
  for (std::size_t cell = 0; cell < shellOfCell.size(); ++cell)
  {
    shells[static_cast<std::size_t>(shellOfCell[cell] - 1)].push_back(cell);
  }
  return shells;
}

std::string
shellName(const HexMesh & mesh, std::size_t shell)
{
  const auto shells = static_cast<std::size_t>(mesh.nodesPerSide / 2);
  return shell <= shells ? "SHELL_" + std::to_string(shell) : "PADDING_" + std::to_string(shell - shells);
}

} // namespace moserhex
