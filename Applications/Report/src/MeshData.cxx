#include "MeshData.h"

#include "HtmlText.h"
#include "moserhex/Common/Errors.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

using Json = nlohmann::ordered_json;

/** Little endian whatever the machine is. */
template <typename TNumber>
std::string
base64OfNumbers(const std::vector<TNumber> & numbers)
{
  std::vector<std::uint8_t> bytes;
  bytes.reserve(numbers.size() * sizeof(TNumber));
  for (const TNumber number : numbers)
  {
    for (std::size_t byte = 0; byte < sizeof(TNumber); ++byte)
    {
      bytes.push_back(static_cast<std::uint8_t>(number >> (8 * byte) & 0xff));
    }
  }
  return base64(bytes.data(), bytes.size());
}

/** Whole numbers 0 ... 65535 over a range. */
struct Rounding
{
  double low{ 0.0 };
  double step{ 1.0 };

  explicit Rounding(double least, double most) : low(least), step(most > least ? (most - least) / 65535.0 : 1.0)
  {}

  [[nodiscard]] std::uint16_t
  operator()(double value) const
  {
    return static_cast<std::uint16_t>(std::clamp(std::round((value - low) / step), 0.0, 65535.0));
  }
};

Json
positionsJson(const Positions & nodes)
{
  Vector3 least = nodes.front();
  Vector3 most = nodes.front();
  for (const Vector3 & node : nodes)
  {
    least = least.cwiseMin(node);
    most = most.cwiseMax(node);
  }
  Json                       json{ { "low", Json::array() }, { "step", Json::array() } };
  std::vector<std::uint16_t> numbers(3 * nodes.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    const Rounding rounding(least[axis], most[axis]);
    json["low"].push_back(rounding.low);
    json["step"].push_back(rounding.step);
    for (std::size_t node = 0; node < nodes.size(); ++node)
    {
      numbers[3 * node + static_cast<std::size_t>(axis)] = rounding(nodes[node][axis]);
    }
  }
  json["data"] = base64OfNumbers(numbers);
  return json;
}

Json
paddingJson(const HexMesh & mesh)
{
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint16_t> index;
  for (std::size_t cell = mesh.latticeCellCount(); cell < mesh.cellCount(); ++cell)
  {
    for (const std::size_t node : mesh.cellNodes(cell))
    {
      nodes.push_back(static_cast<std::uint32_t>(node));
    }
    for (const int corner : pillowCell(mesh, cell).quad)
    {
      index.push_back(static_cast<std::uint16_t>(std::min(corner, mesh.nodesPerSide - 2)));
    }
  }
  return { { "nodes", base64OfNumbers(nodes) }, { "index", base64OfNumbers(index) } };
}

Json
fieldJson(const CellField & field)
{
  const auto [least, most] = std::minmax_element(field.values.begin(), field.values.end());
  const Rounding             rounding(*least, *most);
  std::vector<std::uint16_t> numbers;
  for (const double value : field.values)
  {
    numbers.push_back(rounding(value));
  }
  const CellField::Range range = rangeOf(field);
  Json                   json{
    { "id", field.id }, { "name", field.name }, { "low", range.low }, { "high", range.high }, { "whole", field.isWhole }
  };
  json["acceptable"] = field.acceptable ? Json{ field.acceptable->low, field.acceptable->high } : Json();
  json["values"] = { { "low", rounding.low }, { "step", rounding.step }, { "data", base64OfNumbers(numbers) } };
  return json;
}

} // namespace

std::string
meshDataJson(const HexMesh & mesh, const std::vector<CellField> & fields)
{
  if (mesh.nodesPerSide > mostNodesPerSide)
  {
    throw InvalidInput("mesh of " + std::to_string(mesh.nodesPerSide) + " nodes a side, at most " +
                       std::to_string(mostNodesPerSide) + " fit into a page");
  }
  Json json{ { "nodesPerSide", mesh.nodesPerSide },
             { "paddingLayers", mesh.paddingLayers },
             { "cells", mesh.cellCount() },
             { "positions", positionsJson(mesh.nodes) } };
  if (mesh.paddingLayers > 0)
  {
    json["padding"] = paddingJson(mesh);
  }
  json["fields"] = Json::array();
  for (const CellField & field : fields)
  {
    json["fields"].push_back(fieldJson(field));
  }
  return json.dump();
}

} // namespace moserhex::app
