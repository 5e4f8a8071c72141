// Meshes of many made-up subjects and a table of them, to measure `moserhex atlas` with (Documentation/Atlas.md).
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Random.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace moserhex;

namespace
{

constexpr double noise = 0.1;     ///< of every node [mm]
constexpr double amplitude = 2.0; ///< of the smooth changes [mm]
const Vector3    halfSides(24.0, 18.0, 21.0);

double
monomial(const Vector3 & u, int a, int b, int c)
{
  double result = 1.0;
  for (const auto & [value, power] : { std::pair(u[0], a), std::pair(u[1], b), std::pair(u[2], c) })
  {
    for (int p = 0; p < power; ++p)
    {
      result *= value;
    }
  }
  return result;
}

/** A box that is changed by a random polynomial of third degree, and noise. */
HexMesh
subject(int nodesPerSide, std::uint64_t seed)
{
  Random     random(seed);
  const auto vector = [&random](double size) {
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    return Vector3(x, y, random.uniform(-size, size));
  };
  std::vector<Vector3> coefficients;
  for (int term = 0; term < 4 * 4 * 4; ++term)
  {
    coefficients.push_back(vector(amplitude / (1.0 + term % 4 + term / 4 % 4 + term / 16)));
  }
  return analytic::lattice(nodesPerSide, [&](const Vector3 & index) {
    const Vector3 u = 2.0 * index / (nodesPerSide - 1) - Vector3::Ones();
    Vector3       place = halfSides.cwiseProduct(u) + vector(noise);
    for (int term = 0; term < 4 * 4 * 4; ++term)
    {
      const int a = term % 4;
      const int b = term / 4 % 4;
      const int c = term / 16;
      if (a + b + c >= 1 && a + b + c <= 3)
      {
        place += monomial(u, a, b, c) * coefficients[static_cast<std::size_t>(term)];
      }
    }
    return place;
  });
}

} // namespace

int
main(int argc, char ** argv)
{
  if (argc != 4)
  {
    std::fprintf(stderr, "usage: moserhex_cohort FOLDER SUBJECTS NODES_PER_SIDE\n");
    return 2;
  }
  try
  {
    const std::string folder = argv[1];
    const int         subjects = std::atoi(argv[2]);
    const int         nodesPerSide = std::atoi(argv[3]);
    makeFolder(folder);
    std::string table = "mesh,arm,age\n";
    for (int i = 0; i < subjects; ++i)
    {
      const std::string name = std::to_string(i) + ".vtu";
      writeHexMesh(folder + "/" + name, subject(nodesPerSide, static_cast<std::uint64_t>(i)));
      table += name + "," + (i % 2 == 0 ? "control" : "treated") + "," + std::to_string(50 + i * 7 % 23) + "\n";
    }
    writeTextFile(folder + "/cohort.csv", table);
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
