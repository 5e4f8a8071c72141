#include "ModeMeshFiles.h"

#include "moserhex/HexMeshIO/HexMeshWriter.h"
#include "moserhex/ShapeStatistics/ModeMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace moserhex::app
{
namespace
{

std::string
fileNameOf(std::size_t mode, double sign)
{
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "mode-%02zu-%s3.vtu", mode + 1, sign > 0.0 ? "plus" : "minus");
  return name.data();
}

/** With how far each node is from the mean mesh's. */
void
writeMesh(const std::string & fileName, const ModeMesh & made, double sign, const HexMesh & mean)
{
  NamedArray move{ "Displacement", 3, {} };
  for (std::size_t node = 0; node < mean.nodes.size(); ++node)
  {
    const Vector3 d = made.shape.mesh.nodes[node] - mean.nodes[node];
    move.values.insert(move.values.end(), d.data(), d.data() + 3);
  }
  HexMeshFields fields;
  fields.pointArrays = { move };
  fields.meshArrays = { { "StandardDeviations", 1, { sign * made.deviations } } };
  writeHexMesh(fileName, made.shape.mesh, fields);
}

std::string
warningOf(const ModeMeshFigures & figures)
{
  std::ostringstream text;
  if (figures.deviations == 0.0)
  {
    text << figures.file << ": not written, no exact mesh even of the smallest change; " << figures.attempts.back();
  }
  else
  {
    text << figures.file << ": shows " << figures.deviations << " standard deviations; " << figures.attempts.front();
  }
  return text.str();
}

} // namespace

void
writeModeMeshes(AtlasResult & result, const AtlasOptions & options, const std::function<void(double)> & progress)
{
  const ShapeModel & model = result.model.shape;
  const HexMesh      mean = meshOf(result.model, model.mean);
  const auto         modes = std::min(static_cast<Eigen::Index>(options.modeMeshes), model.modes.cols());
  ModeMeshOptions    making;
  making.threads = options.threads;
  for (Eigen::Index number = 0; number < 2 * modes; ++number)
  {
    const Eigen::Index mode = number / 2;
    const double       sign = number % 2 == 0 ? 1.0 : -1.0;
    const auto         displacement = pointsOf(sign * std::sqrt(model.variances[mode]) * model.modes.col(mode));
    const ModeMesh     made = exactModeMesh(mean, displacement, making, [&](double part) {
      progress((static_cast<double>(number) + part) / static_cast<double>(2 * modes));
      return true;
    });
    ModeMeshFigures    figures;
    figures.file = fileNameOf(static_cast<std::size_t>(mode), sign);
    figures.deviations = made.deviations == 0.0 ? 0.0 : sign * made.deviations;
    figures.volume = made.shape.volume;
    figures.volumeVariance = made.shape.varianceAfter;
    figures.boundaryDistance = made.shape.boundaryDistance;
    figures.attempts = made.attempts;
    if (made.deviations > 0.0)
    {
      writeMesh(options.outputFolder + "/" + figures.file, made, sign, result.mean.mesh);
    }
    if (!made.attempts.empty())
    {
      result.warnings.push_back(warningOf(figures));
    }
    result.modeMeshes.push_back(figures);
  }
}

} // namespace moserhex::app
