#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace moserhex
{
namespace
{

/** The six faces of a VTK_HEXAHEDRON, counter-clockwise seen from outside. */
constexpr std::size_t faceCorners[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
                                            { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

Quadrilateral
faceOf(const std::array<std::size_t, 8> & nodes, std::size_t face)
{
  Quadrilateral result{};
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    result[corner] = nodes[faceCorners[face][corner]];
  }
  return result;
}

/** The lattice with so many nodes and cells, padding included, without places for its nodes. No two have the same. */
std::optional<HexMesh>
latticeOfSize(std::size_t nodes, std::size_t cells)
{
  for (int n = 2; nodeCount(n, 0) <= nodes; ++n)
  {
    const std::size_t layers = (nodes - nodeCount(n, 0)) / boundaryNodeCount(n);
    const HexMesh     lattice{ n, {}, static_cast<int>(layers) };
    if (nodeCount(n, lattice.paddingLayers) == nodes && lattice.cellCount() == cells)
    {
      return lattice;
    }
  }
  return {};
}

} // namespace

void
requireValid(const UnstructuredHexMesh & mesh)
{
  if (mesh.cells.empty())
  {
    throw InvalidInput("hexahedral mesh without cells");
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    if (!mesh.nodes[node].allFinite())
    {
      throw InvalidInput("node " + std::to_string(node) + " has a coordinate that is not finite");
    }
  }
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
  {
    auto sorted = mesh.cells[cell];
    std::sort(sorted.begin(), sorted.end());
    if (sorted.back() >= mesh.nodes.size())
    {
      throw InvalidInput("cell " + std::to_string(cell) + " names node " + std::to_string(sorted.back()) + " of " +
                         std::to_string(mesh.nodes.size()));
    }
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
    {
      throw InvalidInput("cell " + std::to_string(cell) + " names node " + std::to_string(*twice) + " twice");
    }
  }
}

UnstructuredHexMesh
unstructured(const HexMesh & mesh)
{
  UnstructuredHexMesh result{ mesh.nodes, {} };
  result.cells.reserve(mesh.cellCount());
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    result.cells.push_back(mesh.cellNodes(cell));
  }
  return result;
}

std::optional<HexMesh>
asLattice(const UnstructuredHexMesh & mesh)
{
  std::optional<HexMesh> lattice = latticeOfSize(mesh.nodes.size(), mesh.cells.size());
  for (std::size_t cell = 0; lattice && cell < mesh.cells.size(); ++cell)
  {
    if (mesh.cells[cell] != lattice->cellNodes(cell))
    {
      return {};
    }
  }
  if (lattice)
  {
    lattice->nodes = mesh.nodes;
  }
  return lattice;
}

HexCorners
cellCorners(const UnstructuredHexMesh & mesh, std::size_t cell)
{
  HexCorners corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    corners[corner] = mesh.nodes[mesh.cells[cell][corner]];
  }
  return corners;
}

std::vector<double>
cellVolumes(const UnstructuredHexMesh & mesh)
{
  std::vector<double> volumes(mesh.cellCount());
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    volumes[cell] = hexVolume(cellCorners(mesh, cell));
  }
  return volumes;
}

std::vector<Quadrilateral>
boundaryFaces(const UnstructuredHexMesh & mesh)
{
  std::vector<std::size_t> cells(mesh.cells.size());
  std::iota(cells.begin(), cells.end(), std::size_t{ 0 });
  std::vector<Quadrilateral> faces;
  for (const BoundaryFace & face : boundaryFacesOf(mesh, cells))
  {
    faces.push_back(face.nodes);
  }
  return faces;
}

std::vector<BoundaryFace>
boundaryFacesOf(const UnstructuredHexMesh & mesh, const std::vector<std::size_t> & cells)
{
  const auto                 faceAt = [&](std::size_t face) { return faceOf(mesh.cells[cells[face / 6]], face % 6); };
  std::vector<Quadrilateral> keys(6 * cells.size());
  for (std::size_t face = 0; face < keys.size(); ++face)
  {
    keys[face] = faceAt(face);
    std::sort(keys[face].begin(), keys[face].end());
  }
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(), [&keys](std::size_t a, std::size_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
  });
  std::vector<std::size_t> single;
  for (std::size_t begin = 0; begin < order.size();)
  {
    std::size_t end = begin + 1;
    while (end < order.size() && keys[order[end]] == keys[order[begin]])
    {
      ++end;
    }
    if (end == begin + 1)
    {
      single.push_back(order[begin]);
    }
    begin = end;
  }
  std::sort(single.begin(), single.end());
  std::vector<BoundaryFace> faces;
  faces.reserve(single.size());
  for (const std::size_t face : single)
  {
    faces.push_back({ cells[face / 6], faceAt(face) });
  }
  return faces;
}

} // namespace moserhex
