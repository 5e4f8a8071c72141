// Exact: what the command says of a density. A lattice of 4 shells keeps the runs short.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class DensityCommand : public CommandTest
{};

/** Numbers of the label's voxels. */
std::vector<std::size_t>
voxelsOf(const LabelVolume & label)
{
  std::vector<std::size_t> voxels;
  for (std::size_t voxel = 0; voxel < label.inside.size(); ++voxel)
  {
    if (label.inside[voxel] != 0)
    {
      voxels.push_back(voxel);
    }
  }
  return voxels;
}

/** A density on the label's grid, as NRRD. */
template <typename TValue>
void
writeDensity(const std::string & fileName, const LabelVolume & grid, TValue valueOf)
{
  std::ofstream file(fileName, std::ios::binary);
  file.precision(17);
  file << "NRRD0004\ntype: double\ndimension: 3\nspace: left-posterior-superior\nsizes:";
  for (int axis = 0; axis < 3; ++axis)
  {
    file << ' ' << grid.size[static_cast<std::size_t>(axis)];
  }
  const auto vector = [](const Vector3 & v) {
    std::ostringstream text;
    text.precision(17);
    text << " (" << v.x() << ',' << v.y() << ',' << v.z() << ')';
    return text.str();
  };
  file << "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis)
  {
    file << vector(grid.spacing[axis] * grid.direction.col(axis));
  }
  file << "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace origin:" << vector(grid.origin)
       << "\n\n";
  for (std::size_t voxel = 0; voxel < grid.inside.size(); ++voxel)
  {
    const double value = valueOf(voxel);
    file.write(reinterpret_cast<const char *>(&value), sizeof value);
  }
}

/** The same as NIfTI, with an sform. */
template <typename TValue>
void
writeNiftiDensity(const std::string & fileName, const LabelVolume & grid, TValue valueOf)
{
  std::array<char, 352> header{};
  const auto            put = [&header](std::size_t offset, auto value) {
    std::memcpy(header.data() + offset, &value, sizeof value);
  };
  put(0, std::int32_t{ 348 });
  put(40, std::int16_t{ 3 });
  put(70, std::int16_t{ 64 }); // double
  put(72, std::int16_t{ 64 });
  put(76, 1.0F);
  for (std::size_t axis = 0; axis < 4; ++axis)
  {
    put(48 + 2 * axis, std::int16_t{ 1 });
  }
  const Matrix3 columns = grid.direction * grid.spacing.asDiagonal();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto   a = static_cast<Eigen::Index>(axis);
    const double towardsRas = axis < 2 ? -1.0 : 1.0;
    put(42 + 2 * axis, static_cast<std::int16_t>(grid.size[axis]));
    put(80 + 4 * axis, static_cast<float>(grid.spacing[a]));
    for (std::size_t column = 0; column < 3; ++column)
    {
      put(280 + 16 * axis + 4 * column, static_cast<float>(towardsRas * columns(a, static_cast<Eigen::Index>(column))));
    }
    put(292 + 16 * axis, static_cast<float>(towardsRas * grid.origin[a]));
  }
  put(108, 352.0F); // where the voxels begin
  put(112, 1.0F);   // slope
  put(123, char{ 2 });
  put(254, std::int16_t{ 1 });
  std::memcpy(header.data() + 344, "n+1", 4);
  std::ofstream file(fileName, std::ios::binary);
  file.write(header.data(), sizeof header);
  for (std::size_t voxel = 0; voxel < grid.inside.size(); ++voxel)
  {
    const double value = valueOf(voxel);
    file.write(reinterpret_cast<const char *>(&value), sizeof value);
  }
}

} // namespace

TEST_F(DensityCommand, DensityThatIsNotPositiveInTheLabelEndsWithThreeAndNamesTheVoxel)
{
  const LabelVolume gland = makeSampleProstate().gland;
  writeSample();
  const std::size_t inside = voxelsOf(gland).front();
  const auto        nx = static_cast<std::size_t>(gland.size[0]);
  const auto        ny = static_cast<std::size_t>(gland.size[1]);
  const std::string voxel = "voxel (" + std::to_string(inside % nx) + ", " + std::to_string(inside / nx % ny) + ", " +
                            std::to_string(inside / (nx * ny)) + ")";
  for (const double value : { 0.0, -1.0, std::nan("") })
  {
    writeDensity(path("density.nrrd"), gland, [&](std::size_t at) { return at == inside ? value : 1.0; });
    const Outcome outcome =
      run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--density", path("density.nrrd"), "--shells", "2" });
    expectErrorCode(outcome, "E_DENSITY");
    EXPECT_NE(outcome.error.find(voxel), std::string::npos) << outcome.error;
  }
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(DensityCommand, NumberThatIsNotFiniteInANiftiDensityIsNotSaidToBeAZeroAlone)
{
  const LabelVolume gland = makeSampleProstate().gland;
  const std::size_t inside = voxelsOf(gland).front();
  writeSample();
  writeNiftiDensity(path("density.nii"), gland, [&](std::size_t at) { return at == inside ? std::nan("") : 1.0; });
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--density", path("density.nii"), "--shells", "2" });
  expectOneLineError(outcome, 3);
  EXPECT_NE(outcome.error.find(" holds 0 "), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("NaN and infinity in NIfTI files are read as 0"), std::string::npos) << outcome.error;
}

TEST_F(DensityCommand, DensityIsReportedWithItsMassAndChecksum)
{
  const LabelVolume gland = makeSampleProstate().gland;
  writeSample();
  writeDensity(path("density.nrrd"), gland, [](std::size_t) { return 2.5; });
  const Outcome outcome = run({ "mesh",
                                path("prostate.nrrd"),
                                path("b.vtu"),
                                "--shells=4",
                                "--density",
                                path("density.nrrd"),
                                "--report",
                                path("r.json"),
                                "--allow-partial" });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\ndensity: mean 2.5 in the label, mass "), std::string::npos) << outcome.out;
  const auto   report = nlohmann::json::parse(contentOf(path("r.json")));
  const auto & density = report["density"];
  EXPECT_EQ(density["sha256"], sha256OfFile(path("density.nrrd")));
  EXPECT_NEAR(density["mean"].get<double>(), 2.5, 1e-12);
  const double mass = 2.5 * report["input"]["volume_mm3"].get<double>();
  EXPECT_NEAR(density["mass"].get<double>(), mass, 1e-9 * mass);
  EXPECT_NEAR(density["mass_per_cell"].get<double>(), mass / 343.0, 1e-9 * mass);
}

TEST_F(DensityCommand, MeshThatIsNotExactEndsWithFourUnlessItIsAllowed)
{
  // One voxel holds nearly all of the mass: no lattice has cells of equal mass then.
  const LabelVolume gland = makeSampleProstate().gland;
  writeSample();
  const std::size_t centre = voxelsOf(gland)[voxelsOf(gland).size() / 2];
  writeDensity(path("density.nrrd"), gland, [centre](std::size_t voxel) { return voxel == centre ? 1e6 : 1.0; });
  const std::vector<std::string> arguments{ "mesh",      path("prostate.nrrd"), path("b.vtu"),           "--shells=2",
                                            "--density", path("density.nrrd"),  "--shell-method=eikonal" };
  const Outcome                  refused = run(arguments);
  expectErrorCode(refused, "E_NOT_EXACT");
  EXPECT_EQ(refused.exitCode, 4);
  EXPECT_NE(refused.error.find(": not exact: cells are not equal: variance "), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("; try other --shells, or --allow-partial [E_NOT_EXACT]\n"), std::string::npos)
    << refused.error;
  EXPECT_EQ(fileCount(), 2u);

  std::vector<std::string> partial = arguments;
  partial.insert(partial.end(), { "--allow-partial", "--report", path("r.json") });
  const Outcome allowed = run(partial);
  EXPECT_EQ(allowed.exitCode, 0) << allowed.error;
  EXPECT_NE(allowed.out.find("NOT EXACT"), std::string::npos) << allowed.out;
  EXPECT_EQ(readHexMesh(path("b.vtu")).nodesPerSide, 4);
  const auto exact = nlohmann::json::parse(contentOf(path("r.json")))["exact"];
  EXPECT_EQ(exact["reached"], false);
  ASSERT_FALSE(exact["shortcomings"].empty());
  for (const std::string shortcoming : exact["shortcomings"])
  {
    EXPECT_NE(allowed.error.find("warning: not exact: " + shortcoming + "\n"), std::string::npos) << allowed.error;
  }
}
