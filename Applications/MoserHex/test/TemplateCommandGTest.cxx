// Exact: what the command makes and says of a mesh that is tied to another one. Distances of nodes: bounds above what
// was measured. A lattice of 4 shells keeps the runs short.
#include "CommandTest.h"

#include "SampleProstate.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class TemplateCommand : public CommandTest
{
protected:
  void
  SetUp() override
  {
    CommandTest::SetUp();
    writeSample();
    ASSERT_EQ(run({ "mesh", path("prostate.nrrd"), path("baseline.vtu"), "--shells=4", "--quiet" }).exitCode, 0);
  }

  [[nodiscard]] Outcome
  tied(const std::string & label, const std::vector<std::string> & more = {}) const
  {
    std::vector<std::string> arguments{ "mesh",
                                        path(label),
                                        path("tied.vtu"),
                                        "--shells=4",
                                        "--quiet",
                                        "--template=" + path("baseline.vtu"),
                                        "--report=" + path("tied.json") };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /** Of corresponding nodes [mm]. */
  [[nodiscard]] double
  medianDistance() const
  {
    const HexMesh       a = readHexMesh(path("baseline.vtu"));
    const HexMesh       b = readHexMesh(path("tied.vtu"));
    std::vector<double> distances;
    for (std::size_t node = 0; node < a.nodes.size(); ++node)
    {
      distances.push_back((a.nodes[node] - b.nodes[node]).norm());
    }
    std::sort(distances.begin(), distances.end());
    return distances[distances.size() / 2];
  }

  [[nodiscard]] nlohmann::json
  report() const
  {
    return nlohmann::json::parse(contentOf(path("tied.json")));
  }
};

} // namespace

TEST_F(TemplateCommand, TheSameLabelGetsTheSameMesh)
{
  ASSERT_EQ(tied("prostate.nrrd", { "--align=none" }).exitCode, 0);
  EXPECT_LT(medianDistance(), 1e-9); // scaled to the same volume, to round-off
  const nlohmann::json said = report();
  EXPECT_EQ(said["template"]["file"], path("baseline.vtu"));
  EXPECT_EQ(said["template"]["sha256"], sha256OfFile(path("baseline.vtu")));
  EXPECT_EQ(said["stages"][1]["name"], "template");
  EXPECT_TRUE(said["exact"]["reached"]);
}

TEST_F(TemplateCommand, AMovedLabelIsFound)
{
  LabelVolume gland = makeSampleProstate().gland;
  gland.origin += Vector3(30.0, -20.0, 100.0);
  writeLabelImage(path("moved.nrrd"), gland);
  const Outcome outcome = tied("moved.nrrd");
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NEAR(report()["template"]["moved_mm"], Vector3(30.0, -20.0, 100.0).norm(), 0.5);
  EXPECT_LT(report()["template"]["turned_degrees"], 1.0);
  EXPECT_NEAR(medianDistance(), Vector3(30.0, -20.0, 100.0).norm(), 0.5);
}

TEST_F(TemplateCommand, TemplatesThatDoNotFitAreRefused)
{
  expectErrorCode(tied("prostate.nrrd", { "--padding=1" }), "E_USAGE");
  expectErrorCode(
    run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--template=" + path("baseline.vtu"), "--quiet" }),
    "E_NOT_HEXAHEDRA"); // 10 shells
  expectErrorCode(run({ "mesh", path("prostate.nrrd"), path("a.vtu"), "--template=" + path("missing.vtu"), "--quiet" }),
                  "E_NOINPUT");
  expectErrorCode(
    run({ "mesh", path("prostate.nrrd"), path("baseline.vtu"), "--template=" + path("baseline.vtu"), "--quiet" }),
    "E_USAGE");
  expectErrorCode(tied("prostate.nrrd", { "--align=affine" }), "E_USAGE");
}
