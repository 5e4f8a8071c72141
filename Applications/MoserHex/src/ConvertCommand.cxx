#include "ConvertCommand.h"

#include "Console.h"
#include "MeshRecord.h"
#include "OutputName.h"
#include "ScaledJacobians.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshReader.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <cstdio>

namespace moserhex::app
{
namespace
{

HexMeshWriterOptions
writerOptions(const ConvertCommandOptions & options)
{
  HexMeshWriterOptions result;
  result.gmshVersion = options.gmshVersion == "2.2" ? GmshVersion::Msh22 : GmshVersion::Msh41;
  return result;
}

} // namespace

void
runConvertCommand(const ConvertCommandOptions & options)
{
  requireHexMeshName(options.output);
  requireKept(options.input, options.output);
  const HexCellFile file = readHexCells(options.input, { options.sandbox });
  const HexMesh     mesh = latticeOf(file.mesh, options.input);
  HexMeshFields     fields;
  fields.scaledJacobian = scaledJacobiansOf(mesh);
  if (holdsNamedArrays(options.output))
  {
    fields.meshArrays = recordOf(options.input, file.meshArrays);
  }
  writeHexMesh(options.output, mesh, fields, writerOptions(options));
  for (const std::string & warning : file.warnings)
  {
    printWarning(warning);
  }
  if (!options.quiet)
  {
    std::printf("%s: %zu nodes, %zu cells\n", options.output.c_str(), mesh.nodes.size(), mesh.cellCount());
  }
}

} // namespace moserhex::app
