#include "SubjectMeshes.h"

#include "Silhouette.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <numeric>

namespace moserhex::app
{
namespace
{

void
requireSameLattice(const std::string & fileName, const HexMesh & mesh, const SubjectMeshes & first)
{
  if (mesh.nodesPerSide != first.nodesPerSide || mesh.paddingLayers != first.paddingLayers)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   fileName,
                   std::to_string(mesh.nodesPerSide) + " nodes a side and " + std::to_string(mesh.paddingLayers) +
                     " layers of padding, the first mesh has " + std::to_string(first.nodesPerSide) + " and " +
                     std::to_string(first.paddingLayers),
                   "mesh all subjects alike");
  }
}

} // namespace

std::string
turnedLatticeWarning(const std::string & mesh)
{
  std::ifstream        stream(std::filesystem::path(mesh).replace_extension(".json"));
  const nlohmann::json report = nlohmann::json::parse(stream, nullptr, false);
  const auto           warnings = report.is_object() ? report.find("warnings") : report.end();
  if (!report.is_object() || warnings == report.end() || !warnings->is_array())
  {
    return "";
  }
  for (const nlohmann::json & warning : *warnings)
  {
    if (warning.is_string() && warning.get<std::string>().find("lattice is turned") != std::string::npos)
    {
      return fileMessage(mesh, warning.get<std::string>(), "its nodes may not correspond to the others'");
    }
  }
  return "";
}

SubjectMeshes
readSubjectMeshes(const AtlasSubjects &               subjects,
                  const AtlasOptions &                options,
                  const std::function<void(double)> & done)
{
  SubjectMeshes result;
  for (std::size_t i = 0; i < subjects.subjects.size(); ++i)
  {
    const std::string & file = subjects.subjects[i].mesh;
    const HexMesh       mesh = readHexMesh(file, { options.sandbox });
    if (i == 0)
    {
      result.nodesPerSide = mesh.nodesPerSide;
      result.paddingLayers = mesh.paddingLayers;
      result.nodes =
        std::make_unique<SubjectFile>(options.outputFolder, subjects.subjects.size(), 3 * mesh.nodes.size());
    }
    requireSameLattice(file, mesh, result);
    result.nodes->writeSubject(i, coordinatesOf(mesh.nodes));
    const std::vector<double> volumes = cellVolumes(mesh);
    result.figures.push_back(
      { std::accumulate(volumes.begin(), volumes.end(), 0.0), centroidSize(mesh.nodes), silhouette(mesh) });
    const std::string warning = turnedLatticeWarning(file);
    if (!warning.empty())
    {
      result.warnings.push_back(warning);
    }
    done(static_cast<double>(i + 1) / static_cast<double>(subjects.subjects.size()));
  }
  return result;
}

} // namespace moserhex::app
