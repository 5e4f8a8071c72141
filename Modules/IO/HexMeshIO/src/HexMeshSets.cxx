#include "HexMeshSets.h"

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

/** Numbers of the entries of an m^3 lattice on one of its sides, ascending. */
std::vector<std::size_t>
numbersOnSide(std::size_t m, const FaceDescription & face)
{
  std::vector<std::size_t> numbers;
  numbers.reserve(m * m);
  const std::size_t wanted = face.last ? m - 1 : 0;
  for (std::size_t second = 0; second < m; ++second)
  {
    for (std::size_t first = 0; first < m; ++first)
    {
      switch (face.axis)
      {
        case 0:
          numbers.push_back(wanted + m * (first + m * second));
          break;
        case 1:
          numbers.push_back(first + m * (wanted + m * second));
          break;
        default:
          numbers.push_back(first + m * (second + m * wanted));
      }
    }
  }
  return numbers;
}

} // namespace

std::array<CubeFace, 6>
cubeFaces(const HexMesh & mesh)
{
  const auto              n = static_cast<std::size_t>(mesh.nodesPerSide);
  std::array<CubeFace, 6> faces;
  for (std::size_t number = 0; number < faces.size(); ++number)
  {
    const FaceDescription & description = faceDescriptions[number];
    CubeFace &              face = faces[number];
    face.name = description.name;
    face.nodes = numbersOnSide(n, description);
    for (const std::size_t cell : numbersOnSide(n - 1, description))
    {
      const auto    nodes = mesh.cellNodes(cell);
      Quadrilateral side{};
      std::transform(description.corners.begin(), description.corners.end(), side.begin(), [&nodes](std::size_t c) {
        return nodes[c];
      });
      face.sides.push_back({ cell, side });
    }
  }
  return faces;
}

int
shellCount(int nodesPerSide)
{
  return nodesPerSide / 2;
}

std::vector<int>
shellOfCells(int nodesPerSide)
{
  const int        m = nodesPerSide - 1;
  const int        shells = shellCount(nodesPerSide);
  const auto       layers = [m](int index) { return std::min(index, m - 1 - index); };
  std::vector<int> shellOfCell;
  for (int k = 0; k < m; ++k)
  {
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < m; ++i)
      {
        shellOfCell.push_back(shells - std::min({ layers(i), layers(j), layers(k) }));
      }
    }
  }
  return shellOfCell;
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
shellName(std::size_t shell)
{
  return "SHELL_" + std::to_string(shell);
}

} // namespace moserhex
