#include "TransferTest.h"

#include "moserhex/CubeTransfer/CubeImage.h"

#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

TEST_F(TransferCommand, RefusesWithOneLine)
{
  const auto with = [this](const std::vector<std::string> & options) { return transferOf("smooth.nrrd", options); };
  const std::string out = path("out.nrrd");
  expectErrorCode(with({}), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--to-image", out }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("smooth.nrrd") }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--sampling", "many" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", out, "--sampling", "nodes", "--conserve" }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("out.mha") }), "E_USAGE");
  expectErrorCode(with({ "--to-cube", path("no/out.nrrd") }), "E_CANTCREAT");
  expectErrorCode(with({ "--to-cube", out, "--rotate" }), "E_PIXELTYPE");
  expectErrorCode(with({ "--to-cube", out, "--labels" }), "E_LABELS");
  expectErrorCode(with({ "--to-image", out, "--like", path("smooth.nrrd") }), "E_GEOMETRY"); // no image of the cube
  expectErrorCode(with({ "--to-image", out, "--to-mesh", path("b.vtu") }), "E_USAGE");
  expectErrorCode(with({ "--to-image", out, "--to-mesh", path("b.vtu"), "--spacing", "1", "2" }), "E_USAGE");
  expectErrorCode(with({ "--to-points", path("out.csv") }), "E_USAGE");
  expectErrorCode(transferOf("no.nrrd", { "--to-cube", out }), "E_NOINPUT");
  expectErrorCode(transferOf("no.csv", { "--to-cube", path("o.csv") }), "E_NOINPUT");
  EXPECT_EQ(fileCount(), 3U);
}

TEST_F(TransferCommand, RemediesAreOptionsOfThisCommand)
{
  const Outcome outcome = transferOf("smooth.nrrd", { "--labels", "--to-cube", path("cube.nrrd") });
  expectErrorCode(outcome, "E_LABELS");
  EXPECT_NE(outcome.error.find("leave --labels out"), std::string::npos) << outcome.error;
  const Outcome nodes = transferOf("smooth.nrrd",
                                   { "--to-mesh",
                                     path("b.vtu"),
                                     "--to-image",
                                     path("out.nrrd"),
                                     "--spacing",
                                     "2",
                                     "--conserve",
                                     "--sampling",
                                     "nodes" });
  expectErrorCode(nodes, "E_USAGE");
  EXPECT_NE(nodes.error.find("needs cells"), std::string::npos) << nodes.error;
}

TEST_F(TransferCommand, OptionsWithoutAPartAreRefused)
{
  std::ofstream(path("p.csv")) << "x,y,z\n20,15,8\n";
  writeFieldImage(path("cube.nrrd"), FieldVolume{ cubeGrid(CubeSampling::Cells, 7), 1, std::vector<double>(343, 1.0) });
  const std::size_t files = fileCount();
  const auto        refused =
    [this](const std::string & input, const std::vector<std::string> & options, const char * option) {
      const Outcome outcome = transferOf(input, options);
      expectErrorCode(outcome, "E_USAGE");
      EXPECT_NE(outcome.error.find(option), std::string::npos) << outcome.error;
    };
  const std::string out = path("out.nrrd");
  const std::string like = path("smooth.nrrd");
  refused("p.csv", { "--to-cube", path("q.csv"), "--background", "3" }, "--background");
  refused("p.csv", { "--to-cube", path("q.csv"), "--sampling", "40" }, "--sampling");
  refused("p.csv", { "--to-cube", path("q.csv"), "--points", "8" }, "--points");
  refused("p.csv", { "--to-cube", path("q.csv"), "--nearest" }, "--nearest");
  refused("smooth.nrrd", { "--to-cube", out, "--like", like }, "--like");
  refused("smooth.nrrd", { "--to-cube", out, "--segment", "1" }, "--segment");
  refused("smooth.nrrd", { "--to-cube", out, "--fractions" }, "--fractions");
  refused("smooth.nrrd", { "--to-cube", out, "--values-in", "LPS" }, "--values-in");
  refused("smooth.nrrd", { "--to-cube", out, "--sampling", "nodes", "--points", "8" }, "--points");
  refused("smooth.nrrd", { "--to-cube", out, "--labels", "--conserve" }, "--labels");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--sampling", "40" }, "--sampling");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--points", "8" }, "--points");
  refused("cube.nrrd", { "--to-image", out, "--like", like, "--conserve", "--nearest" }, "--nearest");
  refused(
    "smooth.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", out, "--like", like, "--sampling", "40" }, "--sampling");
  refused(
    "smooth.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", out, "--like", like, "--points", "8" }, "--points");
  EXPECT_EQ(fileCount(), files);
}

TEST_F(TransferCommand, AnOutputThatCannotBeWrittenIsRefusedBeforeAnythingIsRead)
{
  std::ofstream(path("damaged.nrrd")) << "no image";
  expectErrorCode(transferOf("damaged.nrrd", { "--to-cube", path("out.mha") }), "E_USAGE");
  expectErrorCode(transferOf("damaged.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd") }),
                  "E_USAGE");
  const Outcome large = transferOf("smooth.nrrd", { "--to-cube", path("out.nrrd"), "--sampling", "1000" });
  expectErrorCode(large, "E_USAGE");
  EXPECT_NE(large.error.find("--sampling 1000: 1e+09 numbers, more than an image file may hold"), std::string::npos)
    << large.error;
}

TEST_F(TransferCommand, WarningsOfTheReferenceImageAreTold)
{
  writeFieldImage(path("like.nii"), constantImage({ 1.0 }));
  std::string bytes = contentOf(path("like.nii"));
  const float shifted = 0.4F + 2.0F; // of the sform's origin [mm]: the qform says 2
  bytes.replace(280 + 12, sizeof shifted, reinterpret_cast<const char *>(&shifted), sizeof shifted);
  std::ofstream(path("like.nii"), std::ios::binary) << bytes;
  const Outcome outcome = transferOf(
    "smooth.nrrd", { "--to-mesh", path("b.vtu"), "--to-image", path("out.nrrd"), "--like", path("like.nii") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("qform and sform differ"), std::string::npos) << outcome.error;
}
