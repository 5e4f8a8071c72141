#pragma once

#include "AtlasOptions.h"
#include "AtlasSubjects.h"
#include "SubjectFile.h"
#include "moserhex/Geometry/HexMesh.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace moserhex::app
{

/** What is known of a subject besides its nodes. */
struct SubjectFigures
{
  double      volume{ 0.0 };       ///< of its mesh [mm^3]
  double      centroidSize{ 0.0 }; ///< of its nodes [mm]
  std::string outline{};           ///< of its mesh, see silhouette()
};

/** The nodes of all subjects, and what was noticed on reading. */
struct SubjectMeshes
{
  int                          nodesPerSide{ 0 };
  int                          paddingLayers{ 0 };
  std::unique_ptr<SubjectFile> nodes; ///< a row a subject [mm]
  std::vector<SubjectFigures>  figures;
  std::vector<std::string>     warnings; ///< of lattices that were turned against the others, see turnWarnings
};

/** Reads the meshes one after the other.
 * \param done  is told the part that is read, in [0,1]
 * \throws BadInput  as readHexMesh; a mesh of another lattice or padding than the first; IOError */
[[nodiscard]] SubjectMeshes
readSubjectMeshes(const AtlasSubjects &               subjects,
                  const AtlasOptions &                options,
                  const std::function<void(double)> & done);

} // namespace moserhex::app
