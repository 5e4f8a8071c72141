// Exact: a model comes back bit for bit, or is refused.
#include "ModelFile.h"

#include "TestFolder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

AtlasModel
smallModel()
{
  AtlasModel model;
  model.nodesPerSide = 2;
  model.alignment = AlignmentKind::Similarity;
  model.size = 12.5;
  model.subjects = 7;
  model.shape.mean = Eigen::VectorXd::LinSpaced(24, 0.1, 3.0);
  model.shape.modes = Eigen::MatrixXd::Identity(24, 2) / 3.0;
  model.shape.variances = Eigen::Vector2d(2.0, 1.0 / 7.0);
  model.shape.totalVariance = 3.1;
  return model;
}

} // namespace

TEST(ModelFile, AModelComesBack)
{
  const TestFolder folder;
  writeAtlasModel(folder / "model.json", smallModel());
  const AtlasModel read = readAtlasModel(folder / "model.json");
  EXPECT_EQ(read.shape.mean, smallModel().shape.mean);
  EXPECT_EQ(read.shape.modes, smallModel().shape.modes);
  EXPECT_EQ(read.shape.variances, smallModel().shape.variances);
  EXPECT_EQ(read.shape.totalVariance, 3.1);
  EXPECT_EQ(read.alignment, AlignmentKind::Similarity);
  EXPECT_EQ(read.size, 12.5);
  EXPECT_EQ(read.nodesPerSide, 2);
}

TEST(ModelFile, WhatIsDamagedIsRefused)
{
  const TestFolder folder;
  const auto refusal = [&] { return analytic::messageOf<Error>([&] { (void)readAtlasModel(folder / "model.json"); }); };
  EXPECT_NE(refusal().find("cannot be opened"), std::string::npos);
  writeTextFile(folder / "model.json", "{\"status\": \"meshed\"}");
  EXPECT_NE(refusal().find("not a shape model"), std::string::npos);
  writeTextFile(folder / "model.json", "nonsense");
  EXPECT_NE(refusal().find("not a shape model"), std::string::npos);
  writeAtlasModel(folder / "model.json", smallModel());
  writeTextFile(folder / "model.f64", std::string(24 * 3 * 8, 'x'));
  EXPECT_NE(refusal().find("not the model's numbers"), std::string::npos);
  writeTextFile(folder / "model.f64", "short");
  EXPECT_NE(refusal().find("another size"), std::string::npos);
  std::filesystem::remove(folder / "model.f64");
  EXPECT_NE(refusal().find("cannot be opened"), std::string::npos);
}
