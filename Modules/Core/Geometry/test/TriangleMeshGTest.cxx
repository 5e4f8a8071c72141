// Round-off class (1e-12 relative): closed forms of a box and invariances. Nothing here is discretised.
#include "moserhex/Geometry/TriangleMesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace moserhex;

namespace
{

/** Box [0,a]x[0,b]x[0,c], 12 triangles, outwards. */
TriangleMesh
box(double a, double b, double c)
{
  TriangleMesh mesh;
  for (int v = 0; v < 8; ++v)
  {
    mesh.vertices.push_back({ v & 1 ? a : 0.0, v & 2 ? b : 0.0, v & 4 ? c : 0.0 });
  }
  const int quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                            { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto & q : quads)
  {
    mesh.triangles.push_back({ q[0], q[1], q[2] });
    mesh.triangles.push_back({ q[0], q[2], q[3] });
  }
  return mesh;
}

} // namespace

TEST(TriangleMesh, BoxHasTheVolumeAndAreaOfTheFormula)
{
  const TriangleMesh mesh = box(2, 3, 5);
  EXPECT_NEAR(enclosedVolume(mesh), 30.0, 1e-12);
  EXPECT_NEAR(surfaceArea(mesh), 2 * (6 + 10 + 15), 1e-12);
  EXPECT_TRUE(surfaceCentroid(mesh).isApprox(Vector3(1, 1.5, 2.5), 1e-12));
}

TEST(TriangleMesh, VolumeChangesSignWithTheOrientation)
{
  TriangleMesh mesh = box(1, 1, 1);
  for (Triangle & t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  EXPECT_NEAR(enclosedVolume(mesh), -1.0, 1e-12);
}

TEST(TriangleMesh, VolumeAndAreaDoNotChangeUnderRigidMotionFarFromTheOrigin)
{
  TriangleMesh  mesh = box(2, 3, 5);
  const Matrix3 rotation = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vector3 & p : mesh.vertices)
  {
    p = rotation * p + Vector3(1e5, -2e5, 3e5);
  }
  // The coordinates themselves carry 1e-11 of round-off at 3e5.
  EXPECT_NEAR(enclosedVolume(mesh), 30.0, 1e-8);
  EXPECT_NEAR(surfaceArea(mesh), 62.0, 1e-8);
}

TEST(TriangleMesh, MeasuresScaleWithTheirPowerOfLength)
{
  for (const double scale : { 1e-8, 1e8 })
  {
    TriangleMesh mesh = box(2, 3, 5);
    for (Vector3 & p : mesh.vertices)
    {
      p *= scale;
    }
    EXPECT_NEAR(enclosedVolume(mesh) / (scale * scale * scale), 30.0, 1e-11);
    EXPECT_NEAR(surfaceArea(mesh) / (scale * scale), 62.0, 1e-11);
  }
}

TEST(TriangleMesh, NormalsOfABoxPointOutwards)
{
  const TriangleMesh mesh = box(1, 1, 1);
  const Positions    normals = vertexNormals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    EXPECT_NEAR(normals[v].norm(), 1.0, 1e-12);
    EXPECT_GT(normals[v].dot(mesh.vertices[v] - Vector3(0.5, 0.5, 0.5)), 0.0);
  }
}

TEST(TriangleMesh, EmptySetsHaveNoMeasure)
{
  EXPECT_EQ(enclosedVolume({}), 0.0);
  EXPECT_EQ(surfaceArea({}), 0.0);
  EXPECT_EQ(boundingBox({}).upper, Vector3::Zero());
}
