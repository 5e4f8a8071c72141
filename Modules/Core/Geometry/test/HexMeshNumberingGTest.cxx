// Exact: numbers, connectivity. Volumes: polynomials of small integers, exact.
#include "moserhex/Geometry/HexMeshNumbering.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

using namespace moserhex;

namespace
{

/** Layers of width 1 around a cube of unit cells; along its edges they widen outwards. */
HexMesh
paddedCube(int n, int layers)
{
  return analytic::paddedLattice(n, layers, [](const Vector3 & index) { return index; });
}

std::vector<std::size_t>
sorted(Quadrilateral quad)
{
  std::sort(quad.begin(), quad.end());
  return { quad.begin(), quad.end() };
}

} // namespace

TEST(PaddedLattice, HasTheCountsOfItsFormulas)
{
  for (const int n : { 2, 3, 6 })
  {
    for (const int layers : { 0, 1, 3 })
    {
      const HexMesh mesh = paddedCube(n, layers);
      const auto    m = static_cast<std::size_t>(n - 1);
      const auto    l = static_cast<std::size_t>(layers);
      EXPECT_EQ(mesh.cellCount(), m * m * m + 6 * m * m * l) << n << ' ' << layers;
      EXPECT_EQ(mesh.nodes.size(), nodeCount(n, layers)) << n << ' ' << layers;
      EXPECT_EQ(boundaryNodeCount(n), 6 * m * m + 2);
      EXPECT_NO_THROW(requireValid(mesh));
    }
  }
}

TEST(PaddedLattice, CellsArePositiveAndFillTheCube)
{
  for (const int n : { 2, 3, 5 })
  {
    for (const int layers : { 1, 2 })
    {
      const HexMesh             mesh = paddedCube(n, layers);
      const std::vector<double> volumes = cellVolumes(mesh);
      for (std::size_t cell = 0; cell < volumes.size(); ++cell)
      {
        for (const double jacobian : cornerJacobians(cellCorners(mesh, cell)))
        {
          EXPECT_GT(jacobian, 0.0) << n << ' ' << layers << ' ' << cell;
        }
      }
      const double side = n - 1 + 2 * layers;
      EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), side * side * side, 1e-12 * side * side * side);
    }
  }
}

TEST(PaddedLattice, CellsShareTheirFacesUpToTheBoundary)
{
  for (const int layers : { 0, 1, 2 })
  {
    const HexMesh                      mesh = paddedCube(4, layers);
    std::set<std::vector<std::size_t>> found;
    std::set<std::vector<std::size_t>> expected;
    for (const Quadrilateral & face : boundaryFaces(unstructured(mesh)))
    {
      EXPECT_TRUE(found.insert(sorted(face)).second);
    }
    for (const Quadrilateral & quad : boundaryQuads(mesh))
    {
      EXPECT_TRUE(expected.insert(sorted(quad)).second);
    }
    EXPECT_EQ(found, expected);
    std::set<std::size_t> nodes;
    for (const auto & quad : expected)
    {
      nodes.insert(quad.begin(), quad.end());
    }
    const std::vector<std::size_t> onBoundary = boundaryNodes(mesh);
    EXPECT_TRUE(std::equal(nodes.begin(), nodes.end(), onBoundary.begin(), onBoundary.end()));
    const Positions points = boundaryPoints(mesh);
    ASSERT_EQ(points.size(), onBoundary.size());
    for (std::size_t b = 0; b < points.size(); ++b)
    {
      EXPECT_EQ(points[b], mesh.nodes[onBoundary[b]]);
    }
  }
}

TEST(PaddedLattice, IndicesLeadBackToTheNumbers)
{
  for (const int n : { 2, 3, 5 })
  {
    const HexMesh                mesh = paddedCube(n, 2);
    const std::vector<NodeIndex> indices = nodeIndices(mesh);
    ASSERT_EQ(indices.size(), mesh.nodes.size());
    for (std::size_t node = 0; node < indices.size(); ++node)
    {
      const auto & [at, layer] = indices[node];
      EXPECT_EQ(mesh.paddingNodeNumber(layer, at[0], at[1], at[2]), node);
    }
  }
}

TEST(PaddedLattice, CubeCoordinatesAreThoseOfTheCubeItself)
{
  const HexMesh   mesh = paddedCube(5, 2);
  const Positions coordinates = cubeCoordinates(mesh);
  ASSERT_EQ(coordinates.size(), mesh.nodes.size());
  for (std::size_t node = 0; node < coordinates.size(); ++node)
  {
    EXPECT_EQ(coordinates[node], mesh.nodes[node] / 4.0);
  }
}

TEST(PaddedLattice, PillowCellsStandOnTheFacesInTheirOrder)
{
  const HexMesh mesh = paddedCube(4, 2);
  std::size_t   cell = mesh.latticeCellCount();
  for (int layer = 1; layer <= 2; ++layer)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const bool last : { false, true })
      {
        for (int quad = 0; quad < 9; ++quad, ++cell)
        {
          const PillowCell pillow = pillowCell(mesh, cell);
          EXPECT_EQ(pillow.layer, layer);
          EXPECT_EQ(pillow.axis, axis);
          EXPECT_EQ(pillow.last, last);
          // The cell's own axis points along the lattice's: from the middle of its first four corners to the others.
          Vector3 middle = Vector3::Zero();
          for (const Vector3 & corner : cellCorners(mesh, cell))
          {
            middle += corner / 8.0;
          }
          EXPECT_DOUBLE_EQ(middle[axis], last ? 3.0 + layer - 0.5 : 0.5 - layer);
        }
      }
    }
  }
  EXPECT_EQ(cell, mesh.cellCount());
}

TEST(PaddedLattice, IsRecognisedByItsConnectivity)
{
  for (const int n : { 2, 3, 4 })
  {
    for (const int layers : { 0, 1, 3 })
    {
      const HexMesh mesh = paddedCube(n, layers);
      const auto    back = asLattice(unstructured(mesh));
      ASSERT_TRUE(back) << n << ' ' << layers;
      EXPECT_EQ(back->nodesPerSide, n);
      EXPECT_EQ(back->paddingLayers, layers);
      EXPECT_EQ(back->nodes, mesh.nodes);
    }
  }
  UnstructuredHexMesh other = unstructured(paddedCube(3, 1));
  std::swap(other.cells.front(), other.cells.back());
  EXPECT_FALSE(asLattice(other));
}

TEST(PaddedLattice, LatticeAloneIsCutOutAndAskedFor)
{
  const HexMesh mesh = paddedCube(3, 2);
  EXPECT_THROW(requireLattice(mesh), InvalidInput);
  const HexMesh lattice = latticePart(mesh);
  EXPECT_NO_THROW(requireLattice(lattice));
  EXPECT_EQ(lattice.nodes, analytic::cubeLattice(3).nodes);
}

TEST(PaddedLattice, WrongNumbersOfNodesAreRefused)
{
  HexMesh mesh = paddedCube(3, 1);
  mesh.nodes.pop_back();
  EXPECT_THROW(requireValid(mesh), InvalidInput);
  mesh = paddedCube(3, 1);
  mesh.paddingLayers = 0;
  EXPECT_THROW(requireValid(mesh), InvalidInput);
  mesh.paddingLayers = -1;
  EXPECT_THROW(requireValid(mesh), InvalidInput);
}

TEST(ShellOfCells, CountsFromTheMiddleCellOutwardsAndOnThroughThePadding)
{
  const std::vector<int> shells = shellOfCells(paddedCube(4, 1));
  ASSERT_EQ(shells.size(), 27u + 54u);
  EXPECT_EQ(shells[13], 1);
  EXPECT_EQ(std::count(shells.begin(), shells.begin() + 27, 2), 26);
  EXPECT_EQ(std::count(shells.begin() + 27, shells.end(), 3), 54);
}
