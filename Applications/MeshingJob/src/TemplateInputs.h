#pragma once

#include "MeshOptions.h"
#include "MeshRecord.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/RunReport.h"
#include "moserhex/HexMeshIO/ScalarImageReader.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** What a mesh is tied to, as read. */
struct TemplateInputs
{
  HexMesh                  mesh;         ///< in its own space
  std::optional<Positions> nodesAtSolid; ///< taken to the label's space by the transform of a file [mm]
  TemplateRefinement       refinement;
  std::vector<std::string> warnings;      ///< one line each
  std::optional<Vector3>   latticeTurn{}; ///< of the template, as LatticeTurn::rotation; empty: none, or not known
};

/** Whether a template is brought to the label by a transform of a file: --align names none of the ways. */
[[nodiscard]] bool
isAlignedByFile(const MeshCommandOptions & options);

/** An image to compare with another one. \throws BadInput (PixelType)  a value is not finite */
[[nodiscard]] ScalarVolume
comparableVolume(const ScalarImage & image);

/** Reads what options say of a template in memory: its transform, landmarks and images.
 * \param mesh  named in messages as options.templateMesh
 * \throws BadInput  the mesh has another number of shells, or padding, or uneven cells, for local growth; a file is
 * none of what it should be: a transform that keeps its cells' orientation; landmarks of which some correspond; images
 * with finite values; IOError */
[[nodiscard]] TemplateInputs
tiedTo(HexMesh mesh, const MeshCommandOptions & options);

/** What makes nodes of a template and of a mesh that is tied to it differ although nothing has changed: cells that are
 * other parts of the organ. \param cells  of the template */
[[nodiscard]] std::vector<std::string>
templateCellWarnings(const CellRecord & cells, const MeshCommandOptions & options);

/** The same with the mesh of a file, options.templateMesh. */
[[nodiscard]] TemplateInputs
readTemplate(const MeshCommandOptions & options);

/** The files that readTemplate reads, without their checksums; none without a template. */
[[nodiscard]] std::vector<RunReport::File>
templateFiles(const MeshCommandOptions & options);

/** Names of all files that a run reads, the label's first. */
[[nodiscard]] std::vector<std::string>
inputFiles(const MeshCommandOptions & options);

} // namespace moserhex::app
