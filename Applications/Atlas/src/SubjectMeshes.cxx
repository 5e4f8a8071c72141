#include "SubjectMeshes.h"

#include "MeshRecord.h"
#include "Silhouette.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

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

SubjectMeshes
readSubjectMeshes(const AtlasSubjects &               subjects,
                  const AtlasOptions &                options,
                  const std::function<void(double)> & done)
{
  SubjectMeshes           result;
  std::vector<TurnOfFile> turns;
  for (std::size_t i = 0; i < subjects.subjects.size(); ++i)
  {
    const std::string & file = subjects.subjects[i].mesh;
    const HexMeshFile   read = readHexMeshFile(file, { options.sandbox });
    const HexMesh &     mesh = read.mesh;
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
    turns.push_back({ file, turnOfLattice(file, read.meshArrays) });
    done(static_cast<double>(i + 1) / static_cast<double>(subjects.subjects.size()));
  }
  result.warnings = turnWarnings(turns, "its nodes may not correspond to the others'");
  return result;
}

} // namespace moserhex::app
