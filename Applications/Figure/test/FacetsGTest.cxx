// Exact: numbers of facets and cells. Closed form: areas of sections to round-off (1e-12).
#include "Facets.h"

#include "SlicePlane.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

double
areaOf(const std::vector<SeenFacet> & facets)
{
  double area = 0.0;
  for (const SeenFacet & facet : facets)
  {
    for (std::size_t corner = 0; corner < facet.outline.size(); ++corner)
    {
      const Point2 & a = facet.outline[corner];
      const Point2 & b = facet.outline[(corner + 1) % facet.outline.size()];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  return area;
}

/** A lattice of cubes of side 1, turned so that a plane across an axis meets three to six edges of a cell. */
HexMesh
turnedCube(int n)
{
  const Matrix3 turn =
    Eigen::AngleAxisd(std::acos(std::sqrt(1.0 / 3.0)), Vector3(1.0, -1.0, 0.0).normalized()).matrix();
  return analytic::lattice(
    n, [n, turn](const Vector3 & index) { return Vector3(turn * (index - Vector3::Constant(0.5 * (n - 1)))); });
}

std::vector<std::size_t>
allCells(const UnstructuredHexMesh & mesh)
{
  std::vector<std::size_t> cells(mesh.cellCount());
  std::iota(cells.begin(), cells.end(), std::size_t{ 0 });
  return cells;
}

} // namespace

TEST(FacesSeen, HalfOfAWarpedFaceThatLooksAtTheViewerIsThere)
{
  HexMesh mesh = analytic::cubeLattice(2);
  mesh.nodes[3][0] = 1.3; // (1,1,0) comes out beside the front, (1,1,1) goes behind it: the face's mean looks away
  mesh.nodes[7][0] = 0.5;
  const UnstructuredHexMesh    cells = unstructured(mesh);
  const std::vector<SeenFacet> facets = facesSeen(cells, { 0 }, cameraFrom(0.0, 0.0));
  ASSERT_EQ(facets.size(), 2U);
  EXPECT_EQ(facets[0].outline.size() + facets[1].outline.size(), 7U);
  EXPECT_NEAR(areaOf(facets), 1.0 + 0.15, 1e-12);
}

TEST(Camera, StandsWhereTheAnglesSay)
{
  EXPECT_LE((cameraFrom(0.0, 0.0).towards - Vector3(0, -1, 0)).norm(), 1e-15) << "anterior";
  EXPECT_LE((cameraFrom(90.0, 0.0).towards - Vector3(1, 0, 0)).norm(), 1e-15) << "left";
  EXPECT_LE((cameraFrom(0.0, 90.0).towards - Vector3(0, 0, 1)).norm(), 1e-15) << "superior";
  EXPECT_LE((cameraFrom(0.0, 0.0).right - Vector3(1, 0, 0)).norm(), 1e-15) << "the patient's left is right";
  for (const Camera & camera : { cameraFrom(37.0, 21.0), cameraOfSlice(0), cameraOfSlice(1), cameraOfSlice(2) })
  {
    EXPECT_LE((camera.right.cross(camera.up) - camera.towards).norm(), 1e-15);
    EXPECT_NEAR(camera.right.norm(), 1.0, 1e-15);
  }
  EXPECT_EQ(cameraOfSlice(2).up, Vector3(0, -1, 0)) << "axial slices have anterior above";
}

TEST(Facets, OfACubeThreeSidesAreSeen)
{
  const UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(5));
  EXPECT_EQ(facesSeen(mesh, allCells(mesh), cameraFrom(30.0, 25.0)).size(), 3U * 16U);
  const auto oneSide = facesSeen(mesh, allCells(mesh), cameraOfSlice(1));
  EXPECT_NEAR(areaOf(oneSide), 16.0, 1e-12);
  EXPECT_EQ(facesSeen(mesh, { 0 }, cameraFrom(30.0, 25.0)).size(), 3U);
}

TEST(Facets, FacesAreLighterTowardsTheLamp)
{
  const UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(2));
  for (const SeenFacet & facet : facesSeen(mesh, { 0 }, cameraFrom(30.0, 25.0)))
  {
    EXPECT_GE(facet.light, 0.7);
    EXPECT_LE(facet.light, 1.0);
  }
}

TEST(Facets, SectionsOfAllCellsFillTheSectionOfTheMesh)
{
  // Across its diagonal, through its middle, the section of a cube of side a is a regular hexagon: 3 sqrt(3)/4 a^2.
  const HexMesh mesh = turnedCube(6);
  const auto    facets = sectionsSeen(unstructured(mesh), 2, 0.0, cameraOfSlice(2));
  EXPECT_NEAR(areaOf(facets), 0.75 * std::sqrt(3.0) * 25.0, 1e-12);
  bool hasHexagon = false;
  for (const SeenFacet & facet : facets)
  {
    hasHexagon = hasHexagon || facet.outline.size() == 6;
    EXPECT_GE(areaOf({ facet }), 0.0) << "counter-clockwise";
  }
  EXPECT_TRUE(hasHexagon);
}

TEST(Facets, SectionAlongTheFacesOfCellsBelongsToThoseOnOneSide)
{
  const UnstructuredHexMesh mesh = unstructured(analytic::cubeLattice(4));
  EXPECT_NEAR(areaOf(sectionsSeen(mesh, 0, 1.0, cameraOfSlice(0))), 9.0, 1e-12);
  EXPECT_NEAR(areaOf(sectionsSeen(mesh, 1, 1.5, cameraOfSlice(1))), 9.0, 1e-12);
  EXPECT_TRUE(sectionsSeen(mesh, 2, 3.5, cameraOfSlice(2)).empty());
}

TEST(Facets, LayerIsInTheMiddleOfItsCells)
{
  const HexMesh mesh = analytic::cubeLattice(4);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Camera camera = cameraOfSlice(axis);
    const auto   facets = layerSeen(mesh, axis, 2, camera);
    ASSERT_EQ(facets.size(), 9U);
    EXPECT_NEAR(std::abs(areaOf(facets)), 9.0, 1e-12);
    for (const SeenFacet & facet : facets)
    {
      EXPECT_NEAR(std::abs(facet.nearness.front()), 2.5, 1e-12);
      const std::array<std::size_t, 3> steps{ 1, 3, 9 };
      EXPECT_EQ(facet.cell / steps[static_cast<std::size_t>(axis)] % 3, 2U);
    }
  }
  EXPECT_NE(
    analytic::messageOf<InvalidInput>([&] { (void)layerSeen(mesh, 0, 3, cameraOfSlice(0)); }).find("from 0 to 2"),
    std::string::npos);
}

TEST(Facets, PaddingStandsOnTheFacesOfTheCube)
{
  const HexMesh   mesh = analytic::paddedLattice(4, 2, [](const Vector3 & index) { return index; });
  const Positions places = cellPlaces(mesh);
  ASSERT_EQ(places.size(), mesh.cellCount());
  EXPECT_LE((places[0] - Vector3::Constant(1.0 / 6.0)).norm(), 1e-15);
  for (std::size_t cell = mesh.latticeCellCount(); cell < mesh.cellCount(); ++cell)
  {
    EXPECT_EQ((places[cell] - Vector3::Constant(0.5)).cwiseAbs().maxCoeff(), 0.5) << cell;
  }
  const Camera             camera = cameraFrom(30.0, 25.0); // from Left, Anterior, Superior
  std::vector<std::size_t> all(mesh.cellCount());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  const auto left = withoutNearestOctant(all, places, camera);
  EXPECT_EQ(all.size() - left.size(), 1U + 3U * 2U); // a corner cell, and two layers on its three outer sides
}

TEST(SlicePlane, IsReadFromWords)
{
  EXPECT_EQ(parsePlane("axial").axis, 2);
  EXPECT_FALSE(parsePlane("axial").position);
  EXPECT_EQ(parsePlane("coronal:-12.5").axis, 1);
  EXPECT_EQ(*parsePlane("coronal:-12.5").position, -12.5);
  EXPECT_EQ(parsePlane("sagittal:3").axis, 0);
  EXPECT_EQ(*parsePlane("k:9").layer, 9);
  EXPECT_EQ(parsePlane("j:0").axis, 1);
  for (const char * wrong : { "", "axial:", "axial:x", "axial:1mm", "k", "k:", "k:1.5", "oblique", "i:2:3" })
  {
    EXPECT_NE(analytic::messageOf<Error>([&] { (void)parsePlane(wrong); }).find("--plane"), std::string::npos) << wrong;
  }
}
