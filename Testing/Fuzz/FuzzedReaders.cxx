#include "FuzzedReaders.h"

#include "ImageFile.h"
#include "ImageFileCheck.h"
#include "LegacyVtkCheck.h"
#include "PointFile.h"
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

/** Several numbers per voxel; those that ITK does not rearrange, by our own code. */
template <ImageFormat format>
void
readField(const std::string & fileName)
{
  const ImageDescription image = checkImageFile(fileName, format, VoxelContent::ManyValues);
  if (!image.layout.isPlain())
  {
    (void)rearrangedValues(image);
  }
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
readPointList(const std::string & fileName)
{
  (void)app::readPoints(fileName);
}

void
readCells(const std::string & fileName)
{
  (void)readHexCellsWithArrays(fileName);
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
    { "field_nrrd", ".nrrd", readField<ImageFormat::Nrrd> },
    { "field_nifti", ".nii", readField<ImageFormat::Nifti> },
    { "field_meta", ".mha", readField<ImageFormat::Meta> },
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
    { "points_fcsv", ".fcsv", readPointList },
    { "points_json", ".mrk.json", readPointList },
    { "points_csv", ".csv", readPointList },
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
