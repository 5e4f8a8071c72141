#include "NrrdWriter.h"

#include "FileNames.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <itkMetaDataObject.h>
#include <itkNrrdImageIO.h>

namespace moserhex
{
namespace
{

constexpr const char * freeSpace = "free some space or choose another folder";

void
writeNrrd(const std::string & fileName, const VoxelGrid & grid, const NrrdVoxels & voxels)
{
  const auto         writer = itk::NrrdImageIO::New();
  itk::ImageIORegion region(3);
  writer->SetNumberOfDimensions(3);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const Vector3 column = grid.direction.col(axis);
    writer->SetDimensions(axis, static_cast<itk::SizeValueType>(grid.size[axis]));
    writer->SetSpacing(axis, grid.spacing[axis]);
    writer->SetOrigin(axis, grid.origin[axis]);
    writer->SetDirection(axis, std::vector<double>(column.data(), column.data() + 3));
    region.SetSize(axis, static_cast<itk::SizeValueType>(grid.size[axis]));
  }
  writer->SetNumberOfComponents(voxels.components);
  writer->SetPixelType(voxels.pixel);
  writer->SetComponentType(voxels.component);
  writer->SetIORegion(region);
  if (!voxels.axes.empty())
  {
    itk::EncapsulateMetaData<std::string>(writer->GetMetaDataDictionary(), nrrdAxesKey, voxels.axes);
  }
  writer->SetUseCompression(true);
  writer->SetFileName(fileName);
  writer->WriteImageInformation();
  writer->Write(voxels.values);
}

} // namespace

void
writeNrrdFile(const std::string &                              fileName,
              const std::string &                              what,
              const VoxelGrid &                                grid,
              const NrrdVoxels &                               voxels,
              const std::function<bool(const std::string &)> & isSame)
{
  if (!endsWith(fileName, ".nrrd"))
  {
    throw BadInput(ErrorCode::Usage, fileName, what + "s are written as NRRD", "give a name that ends with .nrrd");
  }
  AtomicFile file(fileName);
  try
  {
    writeNrrd(file.partName(), grid, voxels);
    if (!isSame(file.partName()))
    {
      throw IOError(ErrorCode::InputOutput, fileName, "the file reads back differently", freeSpace);
    }
  }
  catch (const IOError &)
  {
    throw;
  }
  catch (const std::exception & error)
  {
    throw IOError(ErrorCode::InputOutput, fileName, "cannot write the " + what + " (" + error.what() + ")", freeSpace);
  }
  file.commit();
}

bool
isSamePlace(const VoxelGrid & read, const VoxelGrid & written)
{
  return read.size == written.size && read.spacing.isApprox(written.spacing, 1e-9) &&
         (read.origin - written.origin).norm() <= 1e-6 && read.direction.isApprox(written.direction, 1e-6);
}

} // namespace moserhex
