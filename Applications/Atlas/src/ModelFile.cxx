#include "ModelFile.h"

#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/Sha256.h"

#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace moserhex::app
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr const char *                 formatName = "moserhex shape model";
constexpr int                          formatVersion = 1;
constexpr std::array<AlignmentKind, 3> kinds{ AlignmentKind::None, AlignmentKind::Rigid, AlignmentKind::Similarity };
constexpr int                          mostNodesPerSide = 1024;
constexpr int                          mostLayers = 100;

std::string
numbersFile(const std::string & fileName)
{
  return std::filesystem::path(fileName).replace_extension(".f64").string();
}

[[noreturn]] void
refuse(const std::string & fileName, ErrorCode code, const std::string & cause)
{
  throw BadInput(code, fileName, cause, "give the model.json of an atlas, with its .f64 beside it");
}

std::string
bytesOf(const Eigen::MatrixXd & numbers)
{
  return { reinterpret_cast<const char *>(numbers.data()), static_cast<std::size_t>(numbers.size()) * sizeof(double) };
}

std::string
sha256Of(const std::string & bytes)
{
  Sha256 sha;
  sha.update(bytes.data(), bytes.size());
  return sha.hexDigest();
}

std::string
contentOf(const std::string & fileName)
{
  std::ifstream stream(fileName, std::ios::binary);
  if (!stream)
  {
    refuse(fileName, ErrorCode::NoInput, "cannot be opened");
  }
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

AlignmentKind
kindNamed(const std::string & fileName, const std::string & name)
{
  for (const AlignmentKind kind : kinds)
  {
    if (name == nameOf(kind))
    {
      return kind;
    }
  }
  refuse(fileName, ErrorCode::Format, "no alignment " + name);
}

/** The numbers' file, checked. */
void
readNumbers(AtlasModel & model, const std::string & fileName, const std::string & sha256)
{
  const std::string bytes = contentOf(fileName);
  const auto        rows = static_cast<Eigen::Index>(3 * nodeCount(model.nodesPerSide, model.paddingLayers));
  const auto        modes = model.shape.variances.size();
  if (bytes.size() != static_cast<std::size_t>(rows * (1 + modes)) * sizeof(double))
  {
    refuse(fileName, ErrorCode::Truncated, "another size than the model's");
  }
  if (sha256Of(bytes) != sha256)
  {
    refuse(fileName, ErrorCode::Checksum, "not the model's numbers");
  }
  Eigen::MatrixXd numbers(rows, 1 + modes);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char *>(numbers.data()));
  if (!numbers.allFinite())
  {
    refuse(fileName, ErrorCode::Format, "a number is not finite");
  }
  model.shape.mean = numbers.col(0);
  model.shape.modes = numbers.rightCols(modes);
}

} // namespace

const char *
nameOf(AlignmentKind kind)
{
  switch (kind)
  {
    case AlignmentKind::None:
      return "none";
    case AlignmentKind::Rigid:
      return "rigid";
    case AlignmentKind::Similarity:
      return "similarity";
  }
  return "";
}

void
writeAtlasModel(const std::string & fileName, const AtlasModel & model)
{
  Eigen::MatrixXd numbers(model.shape.mean.size(), 1 + model.shape.modes.cols());
  numbers << model.shape.mean, model.shape.modes;
  const std::string bytes = bytesOf(numbers);
  const auto &      variances = model.shape.variances;
  const Json        header{ { "format", formatName },
                     { "version", formatVersion },
                     { "nodes_per_side", model.nodesPerSide },
                     { "padding_layers", model.paddingLayers },
                     { "alignment", nameOf(model.alignment) },
                     { "centroid_size_mm", model.size },
                     { "subjects", model.subjects },
                     { "variances_mm2", std::vector<double>(variances.data(), variances.data() + variances.size()) },
                     { "total_variance_mm2", model.shape.totalVariance },
                     { "numbers", "little-endian doubles: mean, then every mode; x y z of every node" },
                     { "numbers_sha256", sha256Of(bytes) } };
  writeTextFile(numbersFile(fileName), bytes);
  writeTextFile(fileName, header.dump(2) + "\n");
}

AtlasModel
readAtlasModel(const std::string & fileName)
{
  const Json  header = Json::parse(contentOf(fileName), nullptr, false);
  AtlasModel  model;
  std::string sha256;
  try
  {
    if (header.at("format") != formatName || header.at("version") != formatVersion)
    {
      refuse(fileName, ErrorCode::Format, "not a shape model of this version");
    }
    model.nodesPerSide = header.at("nodes_per_side").get<int>();
    model.paddingLayers = header.at("padding_layers").get<int>();
    model.alignment = kindNamed(fileName, header.at("alignment").get<std::string>());
    model.size = header.at("centroid_size_mm").get<double>();
    model.subjects = header.at("subjects").get<std::size_t>();
    const auto variances = header.at("variances_mm2").get<std::vector<double>>();
    model.shape.variances =
      Eigen::Map<const Eigen::VectorXd>(variances.data(), static_cast<Eigen::Index>(variances.size()));
    model.shape.totalVariance = header.at("total_variance_mm2").get<double>();
    sha256 = header.at("numbers_sha256").get<std::string>();
  }
  catch (const Json::exception &)
  {
    refuse(fileName, ErrorCode::Format, "not a shape model's header");
  }
  const bool isPossible = model.nodesPerSide >= 2 && model.nodesPerSide <= mostNodesPerSide &&
                          model.paddingLayers >= 0 && model.paddingLayers <= mostLayers &&
                          (model.shape.variances.array() > 0.0).all() && model.size > 0.0;
  if (!isPossible)
  {
    refuse(fileName, ErrorCode::Header, "sizes or variances out of range");
  }
  readNumbers(model, numbersFile(fileName), sha256);
  return model;
}

HexMesh
meshOf(const AtlasModel & model, const Eigen::VectorXd & coordinates)
{
  return { model.nodesPerSide, pointsOf(coordinates), model.paddingLayers };
}

} // namespace moserhex::app
