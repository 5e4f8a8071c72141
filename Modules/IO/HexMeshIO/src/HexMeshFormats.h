#pragma once

#include "HexMeshSets.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <string>
#include <vector>

namespace moserhex
{

/** What writeHexMesh has checked and derived; the sizes fit. */
struct HexMeshContent
{
  const HexMesh &       mesh;
  const HexMeshFields & fields;
  std::vector<double>   volumeRatio; ///< per cell, volume over the mean [1]
  std::vector<int>      shell;       ///< per cell, 1 in the middle, N outermost
};

// One writer per format, each in a file of its own. Numbers of nodes and cells in text formats are those of the
// lattice plus 1.

/** \throws IOError  the part cannot be written */
void
writeVtkMesh(const AtomicFile & file, const HexMeshContent & content, const HexMeshWriterOptions & options);

[[nodiscard]] std::string
gmshText(const HexMeshContent & content, GmshVersion version);

[[nodiscard]] std::string
abaqusText(const HexMeshContent & content);

[[nodiscard]] std::string
meditText(const HexMeshContent & content);

[[nodiscard]] std::string
febioText(const HexMeshContent & content);

[[nodiscard]] std::string
exodusBytes(const HexMeshContent & content);

} // namespace moserhex
