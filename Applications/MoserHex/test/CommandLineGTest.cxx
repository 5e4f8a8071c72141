// Exact: exit codes, streams and files of the program as a user runs it. A lattice of 4 shells keeps the runs short.
#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace moserhex;
namespace fs = std::filesystem;

namespace
{

struct Outcome
{
  int         exitCode{ -1 };    ///< -1: ended by a signal
  int         signalNumber{ 0 }; ///< 0: ended by itself
  std::string out;
  std::string error;
};

std::string
contentOf(const fs::path & path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/** Starts the program with its streams in files. `fileSizeLimit` > 0 makes larger files fail like a full disk. */
pid_t
start(const std::vector<std::string> & arguments, const fs::path & folder, rlim_t fileSizeLimit = 0)
{
  const pid_t child = ::fork();
  if (child == 0)
  {
    std::vector<char *> argv{ const_cast<char *>(MOSERHEX_EXECUTABLE) };
    for (const std::string & argument : arguments)
    {
      argv.push_back(const_cast<char *>(argument.c_str()));
    }
    argv.push_back(nullptr);
    ::dup2(::open((folder / "out.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
    ::dup2(::open((folder / "error.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    if (fileSizeLimit > 0)
    {
      const rlimit limit{ fileSizeLimit, fileSizeLimit };
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(MOSERHEX_EXECUTABLE, argv.data());
    ::_exit(127);
  }
  return child;
}

Outcome
finish(pid_t child, const fs::path & folder)
{
  int status = 0;
  ::waitpid(child, &status, 0);
  return { WIFEXITED(status) ? WEXITSTATUS(status) : -1,
           WIFSIGNALED(status) ? WTERMSIG(status) : 0,
           contentOf(folder / "out.txt"),
           contentOf(folder / "error.txt") };
}

/** A folder for the streams, another for the files of a test, and the sample prostate. */
class CommandLine : public testing::Test
{
protected:
  void
  SetUp() override
  {
    std::string name = (fs::temp_directory_path() / "moserhex-XXXXXX").string();
    ASSERT_TRUE(::mkdtemp(name.data()));
    m_Root = name;
    fs::create_directory(m_Root / "files");
    fs::create_directory(m_Root / "streams");
  }

  void
  TearDown() override
  {
    fs::remove_all(m_Root);
  }

  [[nodiscard]] std::string
  path(const std::string & name) const
  {
    return (m_Root / "files" / name).string();
  }

  [[nodiscard]] Outcome
  run(const std::vector<std::string> & arguments, rlim_t fileSizeLimit = 0) const
  {
    return finish(start(arguments, m_Root / "streams", fileSizeLimit), m_Root / "streams");
  }

  [[nodiscard]] std::size_t
  fileCount() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_Root / "files"), fs::directory_iterator()));
  }

  void
  writeSample() const
  {
    writeLabelImage(path("prostate.nrrd"), makeSampleProstate().gland);
  }

  fs::path m_Root;
};

/** One line, at most 200 characters, "error: ...". */
void
expectOneLineError(const Outcome & outcome, int exitCode)
{
  EXPECT_EQ(outcome.exitCode, exitCode) << outcome.error;
  EXPECT_EQ(outcome.error.compare(0, 7, "error: "), 0) << outcome.error;
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  EXPECT_LE(outcome.error.size(), 201u) << outcome.error;
}

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

/** A box of 4^3 voxels of 10 mm as two hexahedra, MSH 2.2, left-handed when asked for; of other heights when given. */
void
writeBoxMesh(const std::string & fileName, bool leftHanded, const std::array<int, 3> & heights = { 0, 20, 40 })
{
  std::ofstream file(fileName);
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n12\n";
  for (int node = 0; node < 12; ++node)
  {
    file << node + 1 << ' ' << 40 * (node % 2) << ' ' << 40 * (node / 2 % 2) << ' '
         << heights[static_cast<std::size_t>(node / 4)] << '\n';
  }
  file << "$EndNodes\n$Elements\n3\n1 15 2 0 0 1\n";
  for (const int first : { 1, 5 })
  {
    const int a = leftHanded ? first + 4 : first;
    const int b = leftHanded ? first : first + 4;
    file << first + 1 << " 5 2 0 0";
    for (const int node : { a, a + 1, a + 3, a + 2, b, b + 1, b + 3, b + 2 })
    {
      file << ' ' << node;
    }
    file << '\n';
  }
  file << "$EndElements\n";
}

/** Voxels [2,6)^3 of 10 mm; their faces lie at 0 and 40 mm. */
LabelVolume
boxLabel()
{
  LabelVolume label;
  label.size = { 8, 8, 8 };
  label.spacing = Vector3::Constant(10.0);
  label.origin = Vector3::Constant(-15.0);
  for (int voxel = 0; voxel < 512; ++voxel)
  {
    const auto within = [](int i) { return i >= 2 && i < 6; };
    label.inside.push_back(within(voxel % 8) && within(voxel / 8 % 8) && within(voxel / 64) ? 1 : 0);
  }
  return label;
}

} // namespace

TEST_F(CommandLine, VersionNamesTheProgramAndItsLibraries)
{
  const Outcome outcome = run({ "--version" });
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.out.compare(0, 9, "moserhex "), 0);
  EXPECT_NE(outcome.out.find("ITK"), std::string::npos);
  EXPECT_TRUE(outcome.error.empty());
}

TEST_F(CommandLine, HelpNamesEveryOption)
{
  const Outcome outcome = run({ "mesh", "--help" });
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char * option : { "INPUT",
                               "OUTPUT",
                               "--shells",
                               "--label",
                               "--stage",
                               "--way",
                               "--frame",
                               "--density",
                               "--allow-partial",
                               "--report",
                               "--shell-method",
                               "--threads",
                               "--quiet" })
  {
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  }
  const Outcome quality = run({ "quality", "--help" });
  for (const char * option : { "MESH", "--label-image", "--label ", "--json", "--threads", "--quiet" })
  {
    EXPECT_NE(quality.out.find(option), std::string::npos) << option;
  }
}

TEST_F(CommandLine, WrongUsageEndsWithTwo)
{
  expectOneLineError(run({}), 2);
  expectOneLineError(run({ "polish" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--shells", "1" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--stage", "polished" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--threads", "0" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.stl" }), 2);
  expectOneLineError(run({ "mesh", "a.vtk", "a.vtk" }), 2);
  expectOneLineError(run({ "mesh", "a.nrrd", "b.vtu", "--report", "./b.vtu" }), 2);
}

TEST_F(CommandLine, OptionsOfTheExactStageAreRefusedWithAnother)
{
  for (const char * option : { "--way=fast", "--way=faithful", "--density=d.nrrd" })
  {
    for (const char * stage : { "initial", "smoothed", "moser" })
    {
      const Outcome outcome = run({ "mesh", "a.nrrd", "b.vtu", "--stage", stage, option });
      expectOneLineError(outcome, 2);
      EXPECT_NE(outcome.error.find("needs --stage exact"), std::string::npos) << outcome.error;
    }
  }
}

TEST_F(CommandLine, WrongUsageSaysWhereToLook)
{
  EXPECT_NE(run({ "qualty", "a.vtu" }).error.find("no command qualty"), std::string::npos);
  EXPECT_NE(run({ "quality", "a.vtu", "--lable", "1" }).error.find("see moserhex quality --help"), std::string::npos);
  EXPECT_NE(run({ "mesh", "a.nrrd" }).error.find("see moserhex mesh --help"), std::string::npos);
}

TEST_F(CommandLine, BadInputEndsWithThreeAndLeavesNothing)
{
  expectOneLineError(run({ "mesh", path("missing.nrrd"), path("b.vtu") }), 3);
  expectOneLineError(run({ "mesh", path("image.png"), path("b.vtu") }), 3);
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(CommandLine, SeveralLabelsAreListed)
{
  writeLabelImage(path("zones.nrrd"), makeSampleProstate().zones);
  const Outcome outcome = run({ "mesh", path("zones.nrrd"), path("b.vtu") });
  expectOneLineError(outcome, 3);
  EXPECT_NE(outcome.error.find("2 labels: 1, 2"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("--label"), std::string::npos) << outcome.error;
}

TEST_F(CommandLine, LabelThatIsNotASphereIsRefusedWithItsNumbers)
{
  // A square ring of one-voxel-thick sides would be too thin; this one is a solid torus.
  LabelVolume ring;
  ring.size = { 40, 40, 20 };
  for (int k = 0; k < 20; ++k)
  {
    for (int j = 0; j < 40; ++j)
    {
      for (int i = 0; i < 40; ++i)
      {
        const double distance = std::hypot(std::hypot(i - 19.5, j - 19.5) - 12.0, k - 9.5);
        ring.inside.push_back(distance < 5.0 ? 1 : 0);
      }
    }
  }
  writeLabelImage(path("ring.nrrd"), ring);
  const Outcome outcome = run({ "mesh", path("ring.nrrd"), path("b.vtu") });
  expectOneLineError(outcome, 3);
  EXPECT_NE(outcome.error.find("handle"), std::string::npos) << outcome.error;
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CommandLine, UnwritableOutputEndsWithSeventyFourBeforeTheWork)
{
  writeSample();
  expectOneLineError(run({ "mesh", path("prostate.nrrd"), path("no/b.vtu") }), 74);
  expectOneLineError(run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--report", path("no/r.json") }), 74);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CommandLine, SampleWritesThreeLabelmaps)
{
  const Outcome outcome = run({ "sample", path("sample") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.error.empty());
  EXPECT_EQ(readLabelImage(path("sample/prostate.nrrd")).labels.size(), 1u);
  EXPECT_EQ(readLabelImage(path("sample/prostate_zones.nrrd")).labels.size(), 2u);
  EXPECT_EQ(readLabelImage(path("sample/prostate_followup.nrrd")).labels.size(), 1u);
}

TEST_F(CommandLine, SampleOnAFullDiskEndsWithSeventyFourAndLeavesNoFile)
{
  const Outcome outcome = run({ "sample", path("sample") }, 300);
  EXPECT_EQ(outcome.exitCode, 74);
  EXPECT_TRUE(fs::is_empty(path("sample")));
}

TEST_F(CommandLine, MeshWritesLatticeReportAndTable)
{
  writeSample();
  const Outcome outcome = run(
    { "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "4", "--stage=initial", "--report", path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(readHexMesh(path("b.vtu")).nodesPerSide, 8);
  EXPECT_NE(outcome.out.find("vol. var."), std::string::npos);
  EXPECT_NE(outcome.out.find(path("b.vtu")), std::string::npos);
  EXPECT_EQ(fileCount(), 3u);

  const auto report = nlohmann::json::parse(contentOf(path("r.json")));
  EXPECT_EQ(report["input"]["sha256"], sha256OfFile(path("prostate.nrrd")));
  EXPECT_EQ(report["input"]["label"], 1);
  EXPECT_EQ(report["parameters"]["stage"], "initial");
  EXPECT_EQ(report["mesh"]["nodes"], 512);
  EXPECT_EQ(report["mesh"]["cells"], 343);
  EXPECT_NEAR(report["mesh"]["volume_mm3"].get<double>(), report["input"]["volume_mm3"].get<double>(), 0.1 * 51000);
  EXPECT_TRUE(report["stages"].back().contains("volume_variance"));
  EXPECT_EQ(report["stages"][1]["name"], "shell ordering");
  EXPECT_NE(report["stages"][1]["note"].get<std::string>().find("chan-vese"), std::string::npos) << report["stages"][1];
  EXPECT_GT(report["threads"], 0);
}

TEST_F(CommandLine, MeshThatIsNotExactEndsWithFourUnlessItIsAllowed)
{
  // One voxel holds nearly all of the mass: no lattice has cells of equal mass then.
  const LabelVolume gland = makeSampleProstate().gland;
  writeSample();
  const std::size_t centre = voxelsOf(gland)[voxelsOf(gland).size() / 2];
  writeDensity(path("density.nrrd"), gland, [centre](std::size_t voxel) { return voxel == centre ? 1e6 : 1.0; });
  const std::vector<std::string> arguments{ "mesh",      path("prostate.nrrd"), path("b.vtu"),           "--shells=2",
                                            "--density", path("density.nrrd"),  "--shell-method=eikonal" };
  const Outcome                  refused = run(arguments);
  expectOneLineError(refused, 4);
  EXPECT_NE(refused.error.find(": not exact: cells are not equal: variance "), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("; try other --shells, or --allow-partial\n"), std::string::npos) << refused.error;
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

TEST_F(CommandLine, DensityThatIsNotPositiveInTheLabelEndsWithThreeAndNamesTheVoxel)
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
    expectOneLineError(outcome, 3);
    EXPECT_NE(outcome.error.find(voxel), std::string::npos) << outcome.error;
  }
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(CommandLine, NumberThatIsNotFiniteInANiftiDensityIsNotSaidToBeAZeroAlone)
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

TEST_F(CommandLine, DensityIsReportedWithItsMassAndChecksum)
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

TEST_F(CommandLine, RidgeFrameSaysHowFarItIsTurned)
{
  writeSample();
  const Outcome outcome = run({ "mesh",
                                path("prostate.nrrd"),
                                path("b.vtu"),
                                "--shells=4",
                                "--stage=initial",
                                "--frame=ridge",
                                "--report",
                                path("r.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.out.find("\nframe: turned by "), std::string::npos) << outcome.out;
  const auto frame = nlohmann::json::parse(contentOf(path("r.json")))["frame"];
  EXPECT_LE(frame["turned_degrees"].get<double>(), 10.0);
  EXPECT_LE(frame["edge_score_after"].get<double>(), frame["edge_score_before"].get<double>());
}

TEST_F(CommandLine, QuietRunPrintsNothing)
{
  writeSample();
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.vtk"), "--shells", "3", "--stage", "initial", "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
}

TEST_F(CommandLine, OneAndTwoThreadsWriteTheSameBytes)
{
  writeSample();
  for (const char * threads : { "1", "2" })
  {
    const Outcome outcome = run({ "mesh",
                                  path("prostate.nrrd"),
                                  path(std::string("mesh") + threads + ".vtu"),
                                  "--shells",
                                  "3",
                                  "--threads",
                                  threads });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  }
  EXPECT_EQ(contentOf(path("mesh1.vtu")), contentOf(path("mesh2.vtu")));
}

TEST_F(CommandLine, MeshOnAFullDiskEndsWithSeventyFourAndLeavesNoFile)
{
  writeSample();
  const Outcome outcome =
    run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "3", "--stage", "initial", "--quiet" }, 2000);
  expectOneLineError(outcome, 74);
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(CommandLine, ClosedSurfaceIsMeshed)
{
  // A cube of 40 mm, two triangles a side.
  std::ofstream(path("cube.off")) << "OFF\n8 12 0\n0 0 0\n40 0 0\n0 40 0\n40 40 0\n0 0 40\n40 0 40\n0 40 40\n40 40 40\n"
                                     "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n"
                                     "3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n";
  const Outcome outcome = run({ "mesh", path("cube.off"), path("b.vtu"), "--shells", "3", "--stage", "initial" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(fs::exists(path("b.vtu")));
}

TEST_F(CommandLine, InterruptedRunLeavesNoFile)
{
  writeSample();
  for (const int milliseconds : { 50, 400, 1200 })
  {
    const pid_t child = start({ "mesh", path("prostate.nrrd"), path("b.vtu") }, m_Root / "streams");
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGINT);
    const Outcome outcome = finish(child, m_Root / "streams");
    if (outcome.signalNumber == 0)
    {
      EXPECT_EQ(outcome.exitCode, 0); // it was faster
      return;
    }
    EXPECT_EQ(outcome.signalNumber, SIGINT);
    EXPECT_EQ(fileCount(), 1u);
  }
}

TEST_F(CommandLine, QualityOfAnotherToolsMeshIsMeasuredAndComparedWithTheLabel)
{
  writeBoxMesh(path("box.msh"), false);
  writeLabelImage(path("box.nrrd"), boxLabel());
  const Outcome outcome =
    run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--label=1", "--json", path("q.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("warning: ignored: 1 x point"), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.out.find("2 certified, 0 are not, 0 undecided"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Dice 1.0000"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("corner"), std::string::npos) << outcome.out; // no lattice, no classes

  const auto json = nlohmann::json::parse(contentOf(path("q.json")));
  EXPECT_EQ(json["mesh"]["cells"], 2);
  EXPECT_EQ(json["mesh"]["lattice"], false);
  EXPECT_NEAR(json["quality"]["volume_mm3"].get<double>(), 64000.0, 1e-6);
  EXPECT_NEAR(json["label"]["volume_error"].get<double>(), 0.0, 1e-12);
  EXPECT_NEAR(json["label"]["dice"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(json["label"]["face_centres_mm"]["max"].get<double>(), 0.0, 1e-9);
}

TEST_F(CommandLine, QualityOfALatticeShowsItsClasses)
{
  writeSample();
  ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("b.vtu"), "--shells", "3", "--stage", "initial" }).exitCode, 0);
  const Outcome outcome = run({ "quality", path("b.vtu"), "--json", path("q.json") });
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  for (const char * name : { "\ncorner ", "\nedge ", "\nrest ", "\nall ", "(lattice)" })
  {
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name << outcome.out;
  }
  const auto classes = nlohmann::json::parse(contentOf(path("q.json")))["quality"]["classes"];
  EXPECT_EQ(classes["corner"]["cells"], 8);
  EXPECT_EQ(classes["edge"]["cells"], 36);
  EXPECT_EQ(classes["rest"]["cells"], 81);
}

TEST_F(CommandLine, QualityOfALeftHandedMeshWarns)
{
  writeBoxMesh(path("box.msh"), true);
  const Outcome outcome = run({ "quality", path("box.msh"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  EXPECT_NE(outcome.error.find("left-handed"), std::string::npos) << outcome.error;
}

TEST_F(CommandLine, QualityOfAMeshWithoutVolumeSaysThatRatiosAreUndefined)
{
  // Two flat cells; a cell of positive volume on one of negative volume.
  for (const std::array<int, 3> & heights : { std::array<int, 3>{ 0, 0, 0 }, std::array<int, 3>{ 0, 20, 0 } })
  {
    writeBoxMesh(path("box.msh"), false, heights);
    const Outcome outcome = run({ "quality", path("box.msh"), "--json", path("q.json") });
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_NE(outcome.error.find("the mesh has no volume: the variance"), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.out.find("volume ratio undefined to undefined"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("inf "), std::string::npos) << outcome.out;
    const auto quality = nlohmann::json::parse(contentOf(path("q.json")))["quality"];
    EXPECT_NEAR(quality["volume_mm3"].get<double>(), 0.0, 1e-9);
    EXPECT_TRUE(quality["volume_variance"].is_null());
    EXPECT_TRUE(quality["ratio_max"].is_null());
    EXPECT_TRUE(quality["minimum_jacobian"]["min"].is_null());
  }
}

TEST_F(CommandLine, QualityWarnsOfALabelElsewhere)
{
  writeBoxMesh(path("box.msh"), false);
  LabelVolume label = boxLabel();
  label.origin += Vector3(300.0, 0.0, 0.0);
  writeLabelImage(path("box.nrrd"), label);
  const Outcome outcome = run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--quiet" });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("hardly overlap"), std::string::npos) << outcome.error;
}

TEST_F(CommandLine, QualityRefusesWithTheExitCodesOfTheOthers)
{
  writeBoxMesh(path("box.msh"), false);
  expectOneLineError(run({ "quality" }), 2);
  expectOneLineError(run({ "quality", path("box.msh"), "--label", "1" }), 2);
  expectOneLineError(run({ "quality", path("box.msh"), "--json", path("box.msh") }), 2);
  expectOneLineError(run({ "quality", path("missing.msh") }), 3);
  expectOneLineError(run({ "quality", path("box.stl") }), 3);
  expectOneLineError(run({ "quality", path("box.msh"), "--label-image", path("missing.nrrd") }), 3);
  expectOneLineError(run({ "quality", path("box.msh"), "--json", path("no/q.json") }), 74);
  writeLabelImage(path("box.nrrd"), boxLabel());
  expectOneLineError(run({ "quality", path("box.msh"), "--label-image", path("box.nrrd"), "--label", "7" }), 3);
  EXPECT_EQ(fileCount(), 2u);
}

TEST_F(CommandLine, MeshSavedAgainByMeshioHasTheSameQuality)
{
  if (std::system("/usr/bin/python3 -c 'import meshio' > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "no python3-meshio here";
  }
  writeSample();
  ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("b.vtk"), "--shells", "3", "--stage", "initial" }).exitCode, 0);
  const auto qualityOf = [this](const std::string & name) {
    const Outcome outcome = run({ "quality", path(name), "--json", path("q.json"), "--quiet" });
    EXPECT_EQ(outcome.exitCode, 0) << name << outcome.error;
    return nlohmann::json::parse(contentOf(path("q.json")))["quality"];
  };
  const auto        expected = qualityOf("b.vtk");
  const std::string script = "import sys, meshio\nm = meshio.read(sys.argv[1])\n"
                             "cells = [(c.type, c.data.astype(int)) for c in m.cells]\n"
                             "for name in sys.argv[2:]: meshio.Mesh(m.points.astype(float), cells).write(name)\n";
  std::ofstream(path("convert.py")) << script;
  std::string command = "/usr/bin/python3 '" + path("convert.py") + "' '" + path("b.vtk") + "'";
  const auto  names = { "c.inp", "c.mesh", "c.vtk", "c.vtu" };
  for (const char * name : names)
  {
    command += " '" + path(name) + "'";
  }
  ASSERT_EQ(std::system((command + " > /dev/null 2>&1").c_str()), 0);
  for (const char * name : names)
  {
    EXPECT_EQ(qualityOf(name), expected) << name; // meshio writes all digits
  }
}
