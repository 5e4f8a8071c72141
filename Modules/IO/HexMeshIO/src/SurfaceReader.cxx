#include "moserhex/HexMeshIO/SurfaceReader.h"

#include "FileNames.h"
#include "ImageFileCheck.h"
#include "SurfaceCheck.h"
#include "SurfaceFormats.h"

namespace moserhex
{

RawSurface
readRawSurface(const std::string & fileName)
{
  if (!isSurfaceName(fileName))
  {
    throw BadInput(
      ErrorCode::Format, fileName, "not a surface's name", "give a .vtk, .vtp, .stl, .obj, .ply or .off file");
  }
  requireReadableFile(fileName);
  if (endsWith(fileName, ".stl"))
  {
    return readStl(fileName);
  }
  if (endsWith(fileName, ".obj"))
  {
    return readObj(fileName);
  }
  if (endsWith(fileName, ".ply"))
  {
    return readPly(fileName);
  }
  if (endsWith(fileName, ".off"))
  {
    return readOff(fileName);
  }
  return endsWith(fileName, ".vtk") ? readVtk(fileName) : readVtp(fileName);
}

bool
isSurfaceName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtk", ".vtp", ".stl", ".obj", ".ply", ".off" });
}

SurfaceFile
readSurface(const std::string & fileName)
{
  return checkedSurface(fileName, readRawSurface(fileName));
}

} // namespace moserhex
