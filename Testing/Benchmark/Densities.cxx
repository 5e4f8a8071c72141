// What --conserve states of the integrals of densities, against other boxes and one rule of points
// (Documentation/Transfer.md).
#include "SubjectFunction.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/CubeTransfer/CubeMap.h"
#include "moserhex/CubeTransfer/RefinedMeans.h"
#include "moserhex/HexMeshIO/FieldImageReader.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

using namespace moserhex;

namespace
{

constexpr double lesionRadius = 6.0; // [mm]

struct TestDensity
{
  std::string                              name;
  std::function<double(const Vector3 & p)> valueAt;
  bool                                     nearest{ false };
};

FieldVolume
imageOf(const TestDensity & density, const VoxelGrid & grid)
{
  FieldVolume image{ grid, 1, {} };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i)
      {
        image.values.push_back(density.valueAt(grid.point(i, j, k)));
      }
    }
  }
  return image;
}

double
integralOf(const CubeMeans & means)
{
  return std::inner_product(means.volumes.begin(), means.volumes.end(), means.image.values.begin(), 0.0);
}

/** One row of the table. \return the integral */
double
measure(const TestDensity & density, const FieldVolume & image, const HexMesh & mesh, int boxes)
{
  app::TransferOptions options;
  options.nearest = density.nearest;
  const std::vector<unsigned char> everywhere;
  const app::SubjectFunction       f(image, everywhere, options);
  const CubeMeanOptions            rule = app::meanOptions(options, boxes, mesh, image);
  const std::clock_t               start = std::clock();
  const CubeMeans                  oneRule = cubeMeans(mesh, std::cref(f), 1, rule);
  const RefinedMeans               refined = refinedMeans(mesh, std::cref(f), oneRule, rule.pointsPerAxis);
  const double                     seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const double                     integral = refined.integrals[0];
  std::printf("| %s | %d | %.9g | %.0e | %.0e | %.1f |\n",
              density.name.c_str(),
              boxes,
              integral,
              refined.relativeError,
              std::abs(integralOf(oneRule) - integral) / std::abs(integral),
              seconds);
  std::fflush(stdout);
  return integral;
}

std::vector<TestDensity>
densitiesIn(const HexMesh & mesh)
{
  const CubeMap map(mesh);
  const Vector3 lesion = map.position(map.place(Vector3(0.35, 0.6, 0.5)));
  const auto    inLesion = [lesion](const Vector3 & p) { return (p - lesion).norm() < lesionRadius ? 1.0 : 0.0; };
  const auto    wave = [](const Vector3 & p) {
    return 100.0 + 35.0 * std::sin(2.0 * pi * p[0] / 42.0) * std::cos(2.0 * pi * p[1] / 50.0) *
                     std::cos(2.0 * pi * p[2] / 63.0);
  };
  const auto noisy = [random = Random(1)](const Vector3 &) mutable {
    return 100.0 + 25.0 * std::sqrt(3.0) * random.uniform(-1.0, 1.0); // a standard deviation of 25
  };
  return { { "smooth", wave }, { "noisy", noisy }, { "lesion", inLesion }, { "lesion, `--nearest`", inLesion, true } };
}

} // namespace

int
main(int argc, char ** argv)
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: moserhex_densities MESH IMAGE\nIMAGE: its grid of voxels is taken\n");
    return 2;
  }
  try
  {
    const HexMesh   mesh = readHexMesh(argv[1]);
    const VoxelGrid grid = readFieldImage(argv[2]).volume;
    std::printf("| density | boxes along an axis | integral | stated error, relative | one rule is off by, relative | "
                "processor seconds |\n| --- | --- | --- | --- | --- | --- |\n");
    for (const TestDensity & density : densitiesIn(mesh))
    {
      const FieldVolume image = imageOf(density, grid);
      const double      cells = measure(density, image, mesh, mesh.nodesPerSide - 1);
      const double      others = measure(density, image, mesh, 31);
      std::printf("| %s | difference | %.2e relative | | | |\n", density.name.c_str(), std::abs(others / cells - 1.0));
    }
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
