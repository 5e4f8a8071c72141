#include "moserhex/HexMeshIO/SurfaceReader.h"

#include "FileNames.h"
#include "ImageFileCheck.h"
#include "MeshBytes.h"
#include "SurfaceCheck.h"
#include "SurfaceFormats.h"

namespace moserhex
{

RawSurface
readRawSurface(const std::string & fileName, const ReadOptions & options)
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
  if (endsWith(fileName, ".vtk"))
  {
    return readVtk(fileName);
  }
  const auto read = [&fileName] { return readVtp(fileName); };
  return options.sandbox ? inSandbox(fileName, read, rawSurfaceOf) : read();
}

bool
isSurfaceName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".vtk", ".vtp", ".stl", ".obj", ".ply", ".off" });
}

SurfaceFile
readSurface(const std::string & fileName, const ReadOptions & options)
{
  return checkedSurface(fileName, readRawSurface(fileName, options));
}

} // namespace moserhex
