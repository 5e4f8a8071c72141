#include "moserhex/LevelSet/SimpleVoxel.h"

#include <cstdlib>

namespace moserhex
{
namespace
{

constexpr std::uint32_t allNeighbours = (1U << voxelNeighbours) - 1U;

struct Tables
{
  std::array<std::array<int, 3>, voxelNeighbours> steps{};
  std::uint32_t                                   faces{ 0 };         ///< neighbours that share a face with the voxel
  std::uint32_t                                   facesAndEdges{ 0 }; ///< or an edge: the 18
  std::array<std::uint32_t, voxelNeighbours>      byFaces{};          ///< 6-neighbours of each, among the 18
  std::array<std::uint32_t, voxelNeighbours>      byAll{};            ///< 26-neighbours of each
  std::array<std::uint32_t, 12>                   squares{};          ///< the other three voxels of each 2 x 2 block
  std::array<std::uint32_t, 8>                    cubes{};            ///< the other seven of each 2 x 2 x 2 block
};

Tables
makeTables()
{
  Tables      tables;
  std::size_t count = 0;
  for (int number = 0; number < 27; ++number)
  {
    if (number != 13)
    {
      tables.steps[count++] = { { number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1 } };
    }
  }
  const auto lengthOf = [](const std::array<int, 3> & step) {
    return std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
  };
  for (std::size_t a = 0; a < voxelNeighbours; ++a)
  {
    tables.faces |= lengthOf(tables.steps[a]) == 1 ? 1U << a : 0U;
    tables.facesAndEdges |= lengthOf(tables.steps[a]) <= 2 ? 1U << a : 0U;
  }
  std::size_t square = 0;
  std::size_t cube = 0;
  for (std::size_t a = 0; a < voxelNeighbours; ++a)
  {
    std::uint32_t block = 0; // neighbours between the voxel and neighbour a, and a itself
    for (std::size_t b = 0; b < voxelNeighbours; ++b)
    {
      std::array<int, 3> between{};
      bool               near = true;
      bool               inBlock = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        between[axis] = tables.steps[a][axis] - tables.steps[b][axis];
        near = near && std::abs(between[axis]) <= 1;
        inBlock = inBlock && (tables.steps[b][axis] == 0 || tables.steps[b][axis] == tables.steps[a][axis]);
      }
      tables.byAll[a] |= near && a != b ? 1U << b : 0U;
      tables.byFaces[a] |= lengthOf(between) == 1 ? 1U << b : 0U;
      block |= inBlock ? 1U << b : 0U;
    }
    tables.byFaces[a] &= tables.facesAndEdges;
    if (lengthOf(tables.steps[a]) == 2)
    {
      tables.squares[square++] = block;
    }
    else if (lengthOf(tables.steps[a]) == 3)
    {
      tables.cubes[cube++] = block;
    }
  }
  return tables;
}

const Tables &
tables()
{
  static const Tables result = makeTables();
  return result;
}

std::size_t
lowestBit(std::uint32_t bits)
{
  return static_cast<std::size_t>(__builtin_ctz(bits));
}

/** The part of `set` that holds its neighbour `first`. */
std::uint32_t
partOf(std::uint32_t set, std::size_t first, const std::array<std::uint32_t, voxelNeighbours> & neighbours)
{
  std::uint32_t part = 1U << first;
  std::uint32_t front = part;
  while (front != 0)
  {
    const std::size_t next = lowestBit(front);
    front &= front - 1;
    const std::uint32_t reached = neighbours[next] & set & ~part;
    part |= reached;
    front |= reached;
  }
  return part;
}

} // namespace

const std::array<std::array<int, 3>, voxelNeighbours> &
neighbourSteps()
{
  return tables().steps;
}

std::uint32_t
faceNeighbours()
{
  return tables().faces;
}

bool
isSimpleVoxel(std::uint32_t insideNeighbours)
{
  const Tables &      table = tables();
  const std::uint32_t touching = insideNeighbours & table.faces;
  const std::uint32_t outside = ~insideNeighbours & allNeighbours;
  if (touching == 0 || outside == 0)
  {
    return false;
  }
  const std::uint32_t near = insideNeighbours & table.facesAndEdges;
  return (touching & ~partOf(near, lowestBit(touching), table.byFaces)) == 0 &&
         partOf(outside, lowestBit(outside), table.byAll) == outside;
}

int
eulerChangeOfAdding(std::uint32_t insideNeighbours)
{
  const Tables & table = tables();
  const auto     holds = [&](std::uint32_t others) { return (insideNeighbours & others) == others ? 1 : 0; };
  int            change = 1;
  for (std::uint32_t touching = insideNeighbours & table.faces; touching != 0; touching &= touching - 1)
  {
    --change;
  }
  for (const std::uint32_t square : table.squares)
  {
    change += holds(square);
  }
  for (const std::uint32_t cube : table.cubes)
  {
    change -= holds(cube);
  }
  return change;
}

VoxelNeighbourhood::VoxelNeighbourhood(const VoxelGrid & grid)
{
  const std::ptrdiff_t nx = grid.size[0];
  const std::ptrdiff_t ny = grid.size[1];
  for (std::size_t a = 0; a < voxelNeighbours; ++a)
  {
    const auto & step = neighbourSteps()[a];
    m_Strides[a] = step[0] + nx * (step[1] + ny * step[2]);
  }
}

} // namespace moserhex
