#include "FuzzedReaders.h"

#include "ImageFileCheck.h"
#include "LegacyVtkCheck.h"
#include "SurfaceCheck.h"
#include "SurfaceFormats.h"
#include "XmlVtkCheck.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <stdexcept>

namespace moserhex::fuzz
{
namespace
{

template <ImageFormat format>
void
checkImage(const std::string & fileName)
{
  (void)checkImageFile(fileName, format);
}

template <RawSurface (*read)(const std::string &)>
void
readTriangles(const std::string & fileName)
{
  (void)read(fileName);
}

void
checkSurface(const std::string & fileName)
{
  (void)checkedSurface(fileName, readOff(fileName));
}

void
checkXml(const std::string & fileName)
{
  requireHonestXml(fileName, "PolyData", exportSurfaceAgain);
}

void
readCells(const std::string & fileName)
{
  (void)readHexCells(fileName);
}

} // namespace

const std::vector<FuzzedReader> &
fuzzedReaders()
{
  static const std::vector<FuzzedReader> readers{
    { "nrrd", ".nrrd", checkImage<ImageFormat::Nrrd> },
    { "nifti", ".nii", checkImage<ImageFormat::Nifti> },
    { "nifti_gz", ".nii.gz", checkImage<ImageFormat::Nifti> },
    { "meta", ".mha", checkImage<ImageFormat::Meta> },
    { "stl", ".stl", readTriangles<readStl> },
    { "obj", ".obj", readTriangles<readObj> },
    { "ply", ".ply", readTriangles<readPly> },
    { "off", ".off", readTriangles<readOff> },
    { "vtk_surface", ".vtk", readTriangles<readVtk> },
    { "vtk_counts", ".vtk", requireHonestCounts },
    { "vtk_xml", ".vtp", checkXml },
    { "surface", ".off", checkSurface },
    { "gmsh", ".msh", readCells },
    { "medit", ".mesh", readCells },
    { "abaqus", ".inp", readCells },
  };
  return readers;
}

const FuzzedReader &
fuzzedReader(const std::string & name)
{
  for (const FuzzedReader & reader : fuzzedReaders())
  {
    if (reader.name == name)
    {
      return reader;
    }
  }
  throw std::out_of_range("no reader '" + name + "'");
}

} // namespace moserhex::fuzz
