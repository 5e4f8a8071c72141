#include "TransferTest.h"

#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cmath>
#include <numeric>

namespace moserhex::app
{

HexMesh
bentBar(double bend)
{
  HexMesh mesh;
  mesh.nodesPerSide = 8;
  for (int k = 0; k < mesh.nodesPerSide; ++k)
  {
    for (int j = 0; j < mesh.nodesPerSide; ++j)
    {
      for (int i = 0; i < mesh.nodesPerSide; ++i)
      {
        const Vector3 c = Vector3(i, j, k) / (mesh.nodesPerSide - 1);
        mesh.nodes.emplace_back(5.0 + 30.0 * c[0],
                                5.0 + 20.0 * c[1] * (1.0 - 0.2 * c[0]) + bend * c[0] * c[0],
                                3.0 + 12.0 * c[2] + 2.0 * c[1]);
      }
    }
  }
  return mesh;
}

double
smoothDensity(const Vector3 & p)
{
  return 3.0 + std::sin(0.1 * p[0]) + 0.02 * p[1] * p[2];
}

VoxelGrid
gridAroundBars()
{
  return { { { 50, 45, 14 } }, { 0.9, 1.0, 1.7 }, { -2.0, -2.0, -1.0 } };
}

FieldVolume
constantImage(const std::vector<double> & numbers)
{
  return imageOf(static_cast<int>(numbers.size()), [&numbers](const Vector3 &, std::vector<double> & values) {
    values.insert(values.end(), numbers.begin(), numbers.end());
  });
}

FieldVolume
imageOfPositions()
{
  return imageOf(
    3, [](const Vector3 & p, std::vector<double> & values) { values.insert(values.end(), p.data(), p.data() + 3); });
}

double
sumOfValues(const FieldVolume & image)
{
  return std::accumulate(image.values.begin(), image.values.end(), 0.0);
}

void
TransferCommand::SetUp()
{
  CommandTest::SetUp();
  m_Mesh = bentBar(15.0);
  writeHexMesh(path("a.vtu"), m_Mesh);
  writeHexMesh(path("b.vtu"), bentBar(4.0));
  writeFieldImage(path("smooth.nrrd"), imageOf(1, [](const Vector3 & p, std::vector<double> & values) {
                    values.push_back(smoothDensity(p));
                  }));
}

FieldVolume
TransferCommand::image(const std::string & name) const
{
  return readFieldImage(path(name)).volume;
}

Outcome
TransferCommand::transferOf(const std::string & input, const std::vector<std::string> & options) const
{
  std::vector<std::string> arguments{ "transfer", path(input), "--mesh", path("a.vtu") };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run(arguments);
}

void
TransferCommand::transfer(const std::string & input, const std::vector<std::string> & options) const
{
  const Outcome outcome = transferOf(input, options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
}

} // namespace moserhex::app
