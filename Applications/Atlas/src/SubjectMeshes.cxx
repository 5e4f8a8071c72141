#include "SubjectMeshes.h"

#include "MeshRecord.h"
#include "Silhouette.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/ShapeStatistics/ShapeModel.h"

#include <algorithm>
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

struct CellsOfFile
{
  std::string file;
  CellRecord  cells;
};

/** Of meshes whose cells are not the same parts of their organs' volumes. */
std::vector<std::string>
cellWarnings(const std::vector<CellsOfFile> & meshes)
{
  const auto isOfMass = [](const CellsOfFile & mesh) { return mesh.cells.hasDensity; };
  const bool areMixed =
    std::any_of(meshes.begin(), meshes.end(), isOfMass) && !std::all_of(meshes.begin(), meshes.end(), isOfMass);
  std::vector<std::string> warnings;
  for (const CellsOfFile & mesh : meshes)
  {
    if (mesh.cells.isInexact)
    {
      warnings.push_back(fileMessage(
        mesh.file, "it was not made exact, or fell short of it", "its cells are not equal parts of the organ"));
    }
    if (mesh.cells.hasLocalGrowth)
    {
      warnings.push_back(fileMessage(
        mesh.file, "its cells were free to grow (--local-growth)", "the mean has equal cells, and does not show it"));
    }
    if (areMixed && mesh.cells.hasDensity)
    {
      warnings.push_back(
        fileMessage(mesh.file, "its cells hold equal masses, those of others equal volumes", "make all alike"));
    }
  }
  return warnings;
}

} // namespace

SubjectMeshes
readSubjectMeshes(const AtlasSubjects &               subjects,
                  const AtlasOptions &                options,
                  const std::function<void(double)> & done)
{
  SubjectMeshes            result;
  std::vector<TurnOfFile>  turns;
  std::vector<CellsOfFile> cells;
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
    cells.push_back({ file, cellRecordOf(file, read.meshArrays) });
    done(static_cast<double>(i + 1) / static_cast<double>(subjects.subjects.size()));
  }
  result.warnings = turnWarnings(turns, "its nodes may not correspond to the others'");
  const std::vector<std::string> ofCells = cellWarnings(cells);
  result.warnings.insert(result.warnings.end(), ofCells.begin(), ofCells.end());
  return result;
}

} // namespace moserhex::app
