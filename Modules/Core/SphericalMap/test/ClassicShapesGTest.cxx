// The guarantee of areaPreservingSphereMap on classic shapes from files (development data; skipped where it is empty):
// 0 flips, solid angles sum to 4 pi within 1e-9, area ratio rms at most 0.01.
#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

using namespace moserhex;

namespace
{

/** Triangles of an OFF file; empty when it cannot be read. */
TriangleMesh
readOff(const std::string & path)
{
  TriangleMesh  mesh;
  std::ifstream file(path);
  std::string   magic;
  std::size_t   vertexCount = 0;
  std::size_t   triangleCount = 0;
  std::size_t   edgeCount = 0;
  if (!(file >> magic >> vertexCount >> triangleCount >> edgeCount) || magic != "OFF")
  {
    return mesh;
  }
  mesh.vertices.resize(vertexCount);
  for (Vector3 & p : mesh.vertices)
  {
    file >> p[0] >> p[1] >> p[2];
  }
  mesh.triangles.resize(triangleCount);
  for (Triangle & t : mesh.triangles)
  {
    int corners = 0;
    file >> corners >> t[0] >> t[1] >> t[2];
  }
  return file ? mesh : TriangleMesh{};
}

class ClassicShapes : public testing::TestWithParam<const char *>
{};

} // namespace

TEST_P(ClassicShapes, GuaranteeHolds)
{
  const std::string  folder = MOSERHEX_DEVELOPMENT_DATA;
  const std::string  path = folder + "/classic/" + GetParam() + ".off";
  const TriangleMesh surface = readOff(path);
  if (surface.triangles.empty())
  {
    GTEST_SKIP() << "no development data at " << path;
  }
  const auto             result = areaPreservingSphereMap(surface);
  const SphereMapQuality quality = sphereMapQuality(surface, result.positions);
  EXPECT_TRUE(isBijective(quality)) << quality.flippedTriangles << " flipped, sum " << quality.solidAngleSum;
  EXPECT_LE(quality.areaRatioRms, 0.01) << result.path;
  EXPECT_EQ(result.shapeWeight, AreaPreservingMapOptions{}.shapeWeight) << "reached at the fixed eps";
}

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         ClassicShapes,
                         testing::Values("tooth_tora", "hippocampus_choi", "maxplanck_choi"),
                         [](const auto & shape) { return std::string(shape.param); });
