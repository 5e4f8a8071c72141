// Round-off of 1/65535 of the range: what a page holds of a mesh.
#include "MeshData.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** Decodes by a way of its own. */
std::vector<std::uint8_t>
bytesOf(const std::string & text)
{
  const std::string         letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t             held = 0;
  int                       bits = 0;
  for (const char letter : text)
  {
    if (letter == '=')
    {
      break;
    }
    held = held << 6 | static_cast<std::uint32_t>(letters.find(letter));
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(held >> bits & 255));
    }
  }
  return bytes;
}

unsigned int
number16(const std::vector<std::uint8_t> & bytes, std::size_t at)
{
  return bytes.at(2 * at) + 256u * bytes.at(2 * at + 1);
}

HexMesh
bentMesh(int n, int layers)
{
  return analytic::paddedLattice(n, layers, [](const Vector3 & i) {
    return Vector3(3.0 * i[0] - 100.0, 2.0 * i[1] + 0.1 * i[0], 0.5 * i[2] + 0.05 * i[0] * i[1]);
  });
}

} // namespace

TEST(MeshData, PositionsComeBackWithinTheirStep)
{
  const HexMesh             mesh = bentMesh(5, 1);
  const nlohmann::json      json = nlohmann::json::parse(meshDataJson(mesh, cellFieldsOf(mesh, {})));
  const nlohmann::json &    positions = json["positions"];
  std::vector<std::uint8_t> bytes = bytesOf(positions["data"]);
  ASSERT_EQ(bytes.size(), 6 * mesh.nodes.size());
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double step = positions["step"][axis];
      const double value = positions["low"][axis].get<double>() + step * number16(bytes, 3 * node + axis);
      EXPECT_NEAR(value, mesh.nodes[node][static_cast<int>(axis)], 0.51 * step);
    }
  }
}

TEST(MeshData, ValuesOfCellsComeBackWithinTheirStep)
{
  const HexMesh                mesh = bentMesh(4, 0);
  const std::vector<CellField> fields = cellFieldsOf(mesh, std::vector<std::int32_t>(27, 7));
  const nlohmann::json         json = nlohmann::json::parse(meshDataJson(mesh, fields));
  ASSERT_EQ(json["fields"].size(), 6u);
  for (std::size_t f = 0; f < fields.size(); ++f)
  {
    const nlohmann::json & values = json["fields"][f]["values"];
    const auto             bytes = bytesOf(values["data"]);
    ASSERT_EQ(bytes.size(), 2 * mesh.cellCount());
    for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
    {
      const double step = values["step"];
      EXPECT_NEAR(
        values["low"].get<double>() + step * number16(bytes, cell), fields[f].values[cell], 0.51 * step + 1e-12);
    }
  }
}

TEST(MeshData, PaddingHasItsConnectivity)
{
  const HexMesh        mesh = bentMesh(3, 1);
  const nlohmann::json json = nlohmann::json::parse(meshDataJson(mesh, cellFieldsOf(mesh, {})));
  const auto           bytes = bytesOf(json["padding"]["nodes"]);
  ASSERT_EQ(bytes.size(), 4u * 8u * 24u);
  for (std::size_t cell = 8; cell < mesh.cellCount(); ++cell)
  {
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      EXPECT_EQ(bytes[4 * (8 * (cell - 8) + corner)], mesh.cellNodes(cell)[corner]);
    }
  }
  EXPECT_FALSE(
    nlohmann::json::parse(meshDataJson(bentMesh(3, 0), cellFieldsOf(bentMesh(3, 0), {}))).contains("padding"));
}

TEST(MeshData, OfATooLargeMeshIsRefused)
{
  HexMesh mesh;
  mesh.nodesPerSide = mostNodesPerSide + 2;
  EXPECT_THROW((void)meshDataJson(mesh, {}), InvalidInput);
}

TEST(CellField, OfACubeIsPerfect)
{
  const HexMesh mesh = analytic::cubeLattice(4, 6.0);
  const auto    fields = cellFieldsOf(mesh, {});
  ASSERT_EQ(fields.size(), 5u);
  const double expected[] = { 1.0, 1.0, 1.0, 0.0 };
  for (std::size_t f = 0; f < 4; ++f)
  {
    for (const double value : fields[f].values)
    {
      EXPECT_NEAR(value, expected[f], 1e-12) << fields[f].name;
    }
  }
  EXPECT_EQ(fields[4].values[13], 1.0);
  EXPECT_EQ(fields[4].values[0], 2.0);
  EXPECT_EQ(acceptablePart(fields[3]), 1.0);
}

TEST(CellField, AcceptablePartCountsTheEndsOfTheRange)
{
  CellField field;
  field.values = { 0.4, 0.5, 1.0, 1.1 };
  field.acceptable = CellField::Range{ 0.5, 1.0 };
  EXPECT_EQ(acceptablePart(field), 0.5);
  field.shown = { 0.0, 1.0 };
  EXPECT_EQ(rangeOf(field).low, 0.0);
  EXPECT_EQ(rangeOf(field).high, 1.1);
}
