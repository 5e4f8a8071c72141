#include "moserhex/HexMeshIO/HexCellReader.h"

#include "FileNames.h"
#include "HexCellFormats.h"
#include "ImageFileCheck.h"
#include "MeshBytes.h"

namespace moserhex
{

bool
isHexCellName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtu", ".vtk", ".msh", ".mesh", ".inp" });
}

namespace
{

using FormatReader = HexCellFile (*)(const std::string &);

HexCellFile
readWith(FormatReader readVtk, const std::string & fileName, const ReadOptions & options)
{
  if (!isHexCellName(fileName))
  {
    throw BadInput(
      ErrorCode::Format, fileName, "not a mesh file's name", "give a .vtu, .vtk, .msh, .mesh or .inp file");
  }
  requireReadableFile(fileName);
  if (endsWith(fileName, ".msh"))
  {
    return readGmshCells(fileName);
  }
  if (endsWith(fileName, ".mesh"))
  {
    return readMeditCells(fileName);
  }
  if (endsWith(fileName, ".inp"))
  {
    return readAbaqusCells(fileName);
  }
  const auto read = [&] { return readVtk(fileName); };
  return options.sandbox ? inSandbox(fileName, read, hexCellFileOf) : read();
}

} // namespace

HexCellFile
readHexCells(const std::string & fileName, const ReadOptions & options)
{
  return readWith(readVtkCells, fileName, options);
}

HexCellFile
readHexCellsWithArrays(const std::string & fileName, const ReadOptions & options)
{
  return readWith(readVtkCellsWithArrays, fileName, options);
}

} // namespace moserhex
