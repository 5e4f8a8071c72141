// Exact: numbers of nodes, faces and cells; volumes to round-off (1e-12).
#include "moserhex/Geometry/UnstructuredHexMesh.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/Common/Errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace moserhex;

namespace
{

std::string
refusalOf(const UnstructuredHexMesh & mesh)
{
  return analytic::messageOf([&] { requireValid(mesh); });
}

} // namespace

TEST(UnstructuredHexMesh, LatticeThereAndBackIsTheSame)
{
  const HexMesh lattice = analytic::cubeLattice(4);
  const auto    back = asLattice(unstructured(lattice));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->nodesPerSide, 4);
  EXPECT_EQ(back->nodes, lattice.nodes);
  EXPECT_EQ(cellVolumes(unstructured(lattice)), cellVolumes(lattice));
}

TEST(UnstructuredHexMesh, OtherOrderOfCellsOrCornersIsNoLattice)
{
  UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(4));
  std::swap(mesh.cells[3], mesh.cells[4]);
  EXPECT_FALSE(asLattice(mesh));
  mesh = unstructured(analytic::cubeLattice(4));
  std::rotate(mesh.cells[5].begin(), mesh.cells[5].begin() + 1, mesh.cells[5].begin() + 4);
  EXPECT_FALSE(asLattice(mesh));
  mesh = unstructured(analytic::cubeLattice(4));
  mesh.nodes.emplace_back(9, 9, 9);
  EXPECT_FALSE(asLattice(mesh));
  EXPECT_FALSE(asLattice({}));
}

TEST(UnstructuredHexMesh, BoundaryOfALatticeHasSixSidesThatFaceOutwards)
{
  const UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(5));
  const auto                faces = boundaryFaces(mesh);
  EXPECT_EQ(faces.size(), 6U * 16U);
  double sixfoldVolume = 0.0;
  for (const Quadrilateral & face : faces)
  {
    const Vector3 normal = (mesh.nodes[face[2]] - mesh.nodes[face[0]]).cross(mesh.nodes[face[3]] - mesh.nodes[face[1]]);
    sixfoldVolume += mesh.nodes[face[0]].dot(normal);
  }
  EXPECT_NEAR(sixfoldVolume / 6.0, 64.0, 1e-12);
}

TEST(UnstructuredHexMesh, FaceOfTwoCellsIsInsideWhateverTheOrderOfItsCorners)
{
  UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(3));
  mesh.cells.resize(2); // neighbours along i
  std::rotate(mesh.cells[1].begin(), mesh.cells[1].begin() + 1, mesh.cells[1].begin() + 4);
  std::rotate(mesh.cells[1].begin() + 4, mesh.cells[1].begin() + 5, mesh.cells[1].end());
  EXPECT_EQ(boundaryFaces(mesh).size(), 10U);
}

TEST(UnstructuredHexMesh, PartOfAMeshHasABoundaryOfItsOwn)
{
  const UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(4)); // 3 x 3 x 3 cells
  const auto                faces = boundaryFacesOf(mesh, { 14, 13 });     // the middle one and its neighbour along i
  ASSERT_EQ(faces.size(), 10U);
  for (std::size_t face = 0; face < 10; ++face)
  {
    EXPECT_EQ(faces[face].cell, face < 5 ? 14U : 13U) << face;
    for (const std::size_t node : faces[face].nodes)
    {
      const auto & nodes = mesh.cells[faces[face].cell];
      EXPECT_EQ(std::count(nodes.begin(), nodes.end(), node), 1) << face;
    }
  }
}

TEST(UnstructuredHexMesh, BrokenMeshesAreRefusedByName)
{
  EXPECT_NE(refusalOf({ { Vector3::Zero() }, {} }).find("without cells"), std::string::npos);
  UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(3));
  EXPECT_EQ(refusalOf(mesh), "accepted");
  mesh.cells[4][2] = 27;
  EXPECT_NE(refusalOf(mesh).find("cell 4 names node 27 of 27"), std::string::npos);
  mesh.cells[4][2] = mesh.cells[4][3];
  EXPECT_NE(refusalOf(mesh).find("twice"), std::string::npos);
  mesh = unstructured(analytic::cubeLattice(3));
  mesh.nodes[7].y() = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusalOf(mesh).find("node 7"), std::string::npos);
}
