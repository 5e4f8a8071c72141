#include "MeshRecord.h"

#include "moserhex/HexMeshIO/FileErrors.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

namespace moserhex::app
{
namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char * turnArray = "LatticeTurn";
constexpr const char * smallestGrowthArray = "SmallestGrowth";
constexpr const char * largestGrowthArray = "LargestGrowth";
constexpr const char * meanDensityArray = "MeanDensity";
constexpr const char * notExactArray = "NotExact";
const double           degree = pi / 180.0;

bool
has(const std::vector<NamedArray> & meshArrays, const std::string & name)
{
  return std::any_of(
    meshArrays.begin(), meshArrays.end(), [&name](const NamedArray & array) { return array.name == name; });
}

bool
isOfCells(const NamedArray & array)
{
  return array.name == smallestGrowthArray || array.name == largestGrowthArray || array.name == meanDensityArray ||
         array.name == notExactArray;
}

/** The report; discarded when there is none. */
Json
reportBeside(const std::string & meshFile)
{
  if (meshFile.empty()) // of a mesh that has no file
  {
    return Json(Json::value_t::discarded);
  }
  const fs::path  report = fs::path(meshFile).replace_extension(".json");
  std::error_code missing;
  if (!fs::is_regular_file(report, missing) || fs::file_size(report, missing) > largestReport)
  {
    return Json(Json::value_t::discarded);
  }
  std::ifstream file(report, std::ios::binary);
  return Json::parse(file, nullptr, false);
}

/** Nothing where it is no turn. */
std::optional<LatticeTurn>
turnBy(const std::vector<double> & rotation)
{
  if (rotation.size() != 3)
  {
    return std::nullopt;
  }
  const Vector3 vector(rotation[0], rotation[1], rotation[2]);
  const double  angle = vector.norm();
  if (!std::isfinite(angle) || !(angle > 0.0))
  {
    return std::nullopt;
  }
  const Vector3      axis = vector / angle;
  std::ostringstream text;
  text << "the lattice is turned by " << std::round(angle) << " degrees about (" << std::setprecision(2) << axis[0]
       << ' ' << axis[1] << ' ' << axis[2] << ")";
  return LatticeTurn{ text.str(), vector };
}

/** Neither is turned, or both by one rotation, up to what is told in words. */
bool
areTurnedAlike(const std::optional<LatticeTurn> & a, const std::optional<LatticeTurn> & b)
{
  constexpr double tolerance = 0.5; // [degree]
  if (!a || !b)
  {
    return !a && !b;
  }
  return a->rotation && b->rotation && (*a->rotation - *b->rotation).norm() <= tolerance;
}

std::optional<LatticeTurn>
turnInReport(const Json & report)
{
  const Json & rotation = report.contains("lattice_turn_degrees") ? report.at("lattice_turn_degrees") : Json();
  if (rotation.is_array() &&
      std::all_of(rotation.begin(), rotation.end(), [](const Json & entry) { return entry.is_number(); }))
  {
    return turnBy(rotation.get<std::vector<double>>());
  }
  for (const Json & warning : report.value("warnings", Json::array()))
  {
    const std::string text = warning.is_string() ? warning.get<std::string>() : "";
    const std::size_t begin = text.find("the lattice is turned by ");
    if (begin != std::string::npos)
    {
      return LatticeTurn{ text.substr(begin, text.find_first_of(":;", begin) - begin), {} };
    }
  }
  const Json::json_pointer ridge("/frame/turned_degrees");
  if (report.contains(ridge) && report.at(ridge).is_number() && report.at(ridge).get<double>() > 0.0)
  {
    const long degrees = std::lround(report.at(ridge).get<double>());
    return LatticeTurn{ "the lattice is turned by " + std::to_string(degrees) + " degrees (--frame ridge)", {} };
  }
  return std::nullopt;
}

bool
isInexactBy(const Json & report)
{
  const auto isAt = [&report](const char * place, const auto & isWrong) {
    const Json::json_pointer pointer(place);
    return report.contains(pointer) && isWrong(report.at(pointer));
  };
  return isAt("/parameters/stage", [](const Json & stage) { return stage.is_string() && stage != "exact"; }) ||
         isAt("/exact/reached", [](const Json & reached) { return reached.is_boolean() && !reached.get<bool>(); });
}

} // namespace

Vector3
rotationVector(const Matrix3 & rotation)
{
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() / degree * turn.axis();
}

std::vector<NamedArray>
latticeTurnArrays(const Vector3 & rotation)
{
  if (rotation.norm() == 0.0)
  {
    return {};
  }
  return { { turnArray, 3, { rotation[0], rotation[1], rotation[2] } } };
}

std::optional<LatticeTurn>
turnOfLattice(const std::string & meshFile, const std::vector<NamedArray> & meshArrays)
{
  const auto array = std::find_if(
    meshArrays.begin(), meshArrays.end(), [](const NamedArray & named) { return named.name == turnArray; });
  if (array != meshArrays.end())
  {
    return turnBy(array->values);
  }
  const Json report = reportBeside(meshFile);
  return report.is_object() ? turnInReport(report) : std::nullopt;
}

std::vector<std::string>
turnWarnings(const std::vector<TurnOfFile> & meshes, const std::string & consequence)
{
  const bool               areAlike = std::all_of(meshes.begin(), meshes.end(), [&meshes](const TurnOfFile & mesh) {
    return areTurnedAlike(mesh.turn, meshes.front().turn);
  });
  std::vector<std::string> warnings;
  for (const TurnOfFile & mesh : meshes)
  {
    if (mesh.turn && !areAlike)
    {
      warnings.push_back(fileMessage(mesh.file, mesh.turn->description, consequence));
    }
  }
  return warnings;
}

std::vector<NamedArray>
localGrowthArrays(double smallest, double largest)
{
  return { { smallestGrowthArray, 1, { smallest } }, { largestGrowthArray, 1, { largest } } };
}

std::vector<NamedArray>
notExactArrays()
{
  return { { notExactArray, 1, { 1.0 } } };
}

CellRecord
cellRecordOf(const std::string & meshFile, const std::vector<NamedArray> & meshArrays)
{
  CellRecord record;
  record.hasLocalGrowth = has(meshArrays, smallestGrowthArray) || has(meshArrays, largestGrowthArray);
  record.hasDensity = has(meshArrays, meanDensityArray);
  record.isInexact = has(meshArrays, notExactArray);
  const Json report = reportBeside(meshFile);
  if (report.is_object())
  {
    record.hasLocalGrowth = record.hasLocalGrowth || report.contains(Json::json_pointer("/template/local_growth"));
    record.hasDensity = record.hasDensity || report.contains("density");
    record.isInexact = record.isInexact || isInexactBy(report);
  }
  return record;
}

std::vector<NamedArray>
recordOf(const RunReport & report)
{
  std::vector<NamedArray> arrays = latticeTurnArrays(report.latticeTurn.value_or(Vector3::Zero()));
  if (report.templateMesh && report.templateMesh->growth)
  {
    const RunReport::Growth & growth = *report.templateMesh->growth;
    for (NamedArray & array : localGrowthArrays(growth.smallest, growth.largest))
    {
      arrays.push_back(std::move(array));
    }
  }
  if (report.density)
  {
    arrays.push_back({ meanDensityArray, 1, { report.density->mean } });
  }
  if (!report.exact || !report.exact->reached)
  {
    arrays.push_back(notExactArrays().front());
  }
  return arrays;
}

std::vector<NamedArray>
recordOf(const std::string & meshFile, const std::vector<NamedArray> & meshArrays)
{
  const std::optional<LatticeTurn> turn = turnOfLattice(meshFile, meshArrays);
  std::vector<NamedArray> record = latticeTurnArrays(turn ? turn->rotation.value_or(Vector3::Zero()) : Vector3::Zero());
  std::copy_if(meshArrays.begin(), meshArrays.end(), std::back_inserter(record), isOfCells);
  const Json       report = reportBeside(meshFile);
  const CellRecord cells = cellRecordOf(meshFile, meshArrays);
  const auto       numberAt = [&report](const char * place) {
    const Json::json_pointer pointer(place);
    const bool isNumber = report.is_object() && report.contains(pointer) && report.at(pointer).is_number();
    return isNumber ? report.at(pointer).get<double>() : 0.0; // not known
  };
  if (cells.hasLocalGrowth && !has(record, smallestGrowthArray))
  {
    const auto growth =
      localGrowthArrays(numberAt("/template/local_growth/smallest"), numberAt("/template/local_growth/largest"));
    record.insert(record.end(), growth.begin(), growth.end());
  }
  if (cells.hasDensity && !has(record, meanDensityArray))
  {
    record.push_back({ meanDensityArray, 1, { numberAt("/density/mean") } });
  }
  if (cells.isInexact && !has(record, notExactArray))
  {
    record.push_back(notExactArrays().front());
  }
  return record;
}

} // namespace moserhex::app
