// The customer's bounds: of 10^6 random points each in the organ is found in exactly one cell, positions come back to
// 1e-9 mm. On the sample, and on three real prostates, skipped where the data are not at hand.
#include "PipelineRun.h"

#include "SampleProstate.h"
#include "TrilinearCell.h"
#include "moserhex/Common/Random.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numeric>

using namespace moserhex;
using namespace moserhex::integration;

namespace
{

constexpr std::size_t points = 1000000;

Positions
randomPoints(const Vector3 & lower, const Vector3 & upper, std::size_t count)
{
  Random    random(5);
  Positions made;
  for (std::size_t n = 0; n < count; ++n)
  {
    const double x = random.uniform(lower[0], upper[0]);
    const double y = random.uniform(lower[1], upper[1]);
    made.emplace_back(x, y, random.uniform(lower[2], upper[2]));
  }
  return made;
}

void
expectPositionsBack(const HexMesh & mesh, const CubeMap & map)
{
  const Positions cube = randomPoints(Vector3::Zero(), Vector3::Ones(), points);
  Positions       positions;
  for (const Vector3 & c : cube)
  {
    positions.push_back(map.position(map.place(c)));
  }
  const auto  places = map.find(positions, 2);
  double      worst = 0.0;
  std::size_t found = 0;
  for (std::size_t n = 0; n < points; ++n)
  {
    found += places[n] ? 1 : 0;
    worst = places[n] ? std::max(worst, (map.position(*places[n]) - positions[n]).norm()) : worst;
  }
  EXPECT_EQ(found, points);
  EXPECT_LE(worst, 1e-9);
  std::cout << found << " of " << points << " points found, largest error " << worst << " mm, " << mesh.cellCount()
            << " cells" << std::endl;
}

/** Cells that hold a point, by looking at each of them. */
std::vector<std::size_t>
cellsAround(const HexMesh & mesh, const Vector3 & p)
{
  std::vector<std::size_t> holding;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const HexCorners corners = cellCorners(mesh, cell);
    Vector3          lower = corners[0];
    Vector3          upper = corners[0];
    for (const Vector3 & corner : corners)
    {
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
    if ((p - lower).minCoeff() >= 0.0 && (upper - p).minCoeff() >= 0.0 && trilinearInverse(corners, p, 1e-12))
    {
      holding.push_back(cell);
    }
  }
  return holding;
}

/** Of random points in the mesh's box: a point is in one cell or in none, and as many are in one as volumes say. */
void
expectOneCellEach(const HexMesh & mesh, const CubeMap & map)
{
  constexpr std::size_t lookedAtEach = 1000;
  Vector3               lower = mesh.nodes.front();
  Vector3               upper = lower;
  for (const Vector3 & node : mesh.nodes)
  {
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  const Positions random = randomPoints(lower, upper, points);
  const auto      places = map.find(random, 2);
  for (std::size_t n = 0; n < lookedAtEach; ++n)
  {
    const std::vector<std::size_t> holding = cellsAround(mesh, random[n]);
    ASSERT_EQ(holding.size(), places[n] ? 1u : 0u) << random[n].transpose();
    EXPECT_TRUE(!places[n] || places[n]->cell == holding.front());
  }
  const auto found = static_cast<double>(
    std::count_if(places.begin(), places.end(), [](const auto & place) { return place.has_value(); }));
  const double part = found / static_cast<double>(points);
  const auto   volumes = cellVolumes(mesh);
  const double expected = std::accumulate(volumes.begin(), volumes.end(), 0.0) / (upper - lower).prod();
  EXPECT_NEAR(part, expected, 4.0 * std::sqrt(expected * (1.0 - expected) / static_cast<double>(points)));
}

void
expectContract(const HexMesh & mesh)
{
  const CubeMap map(mesh);
  expectPositionsBack(mesh, map);
  expectOneCellEach(mesh, map);
}

} // namespace

TEST(CubeMapOfOrgans, TheSample)
{
  PipelineOptions options;
  options.lastStage = MeshingStage::Exact;
  expectContract(runPipeline(labelImage(makeSampleProstate().gland), options)->GetHexMesh());
}

TEST(CubeMapOfOrgans, RealProstates)
{
  const std::filesystem::path folder = std::filesystem::path(MOSERHEX_DEVELOPMENT_DATA) / "dev" / "Bosma22b";
  if (std::string(MOSERHEX_DEVELOPMENT_DATA).empty() || !std::filesystem::is_directory(folder))
  {
    GTEST_SKIP() << "no development data: set MoserHex_DEVELOPMENT_DATA to their folder";
  }
  for (const char * study : { "10134_1000136", "10404_1000410", "11106_1001129" })
  {
    SCOPED_TRACE(study);
    const LabelImage image = readLabelImage((folder / (std::string(study) + ".nii.gz")).string());
    auto             pipeline = itk::MassPreservingHexahedralMeshFilter<LabelImageType>::New();
    pipeline->SetInput(image.image);
    pipeline->SetLabel(chooseLabel(image, std::nullopt).value);
    pipeline->Update();
    expectContract(pipeline->GetHexMesh());
  }
}
