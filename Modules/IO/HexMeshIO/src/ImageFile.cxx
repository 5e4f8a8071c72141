#include "ImageFile.h"

#include "FileNames.h"
#include "ImageFileCheck.h"
#include "ImageHeader.h"

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <Eigen/SVD>

#include <cmath>

namespace moserhex
{
namespace
{

constexpr std::size_t mostVoxels = 500'000'000;

ImageFormat
formatOf(const std::string & fileName)
{
  if (endsWith(fileName, ".nrrd"))
  {
    return ImageFormat::Nrrd;
  }
  if (endsWithAny(fileName, { ".nii", ".nii.gz" }))
  {
    return ImageFormat::Nifti;
  }
  if (endsWithAny(fileName, { ".mha", ".mhd" }))
  {
    return ImageFormat::Meta;
  }
  throw BadInput(
    ErrorCode::Format, fileName, "not the name of an image", "give a .nrrd, .nii, .nii.gz, .mha or .mhd file");
}

/** The one reader for a format: no factory, so no other parser ever sees the file. */
itk::ImageIOBase::Pointer
makeReader(ImageFormat format)
{
  switch (format)
  {
    case ImageFormat::Nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case ImageFormat::Nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case ImageFormat::Meta:
      return itk::MetaImageIO::New().GetPointer();
  }
  return nullptr;
}

void
requireScalarVolume(const std::string & fileName, const itk::ImageIOBase & reader)
{
  for (unsigned int axis = 3; axis < reader.GetNumberOfDimensions(); ++axis)
  {
    if (reader.GetDimensions(axis) != 1)
    {
      throw BadInput(ErrorCode::Dimension,
                     fileName,
                     "a " + std::to_string(reader.GetNumberOfDimensions()) + "-D image, need a 3-D one",
                     "export one 3-D volume");
    }
  }
  if (reader.GetNumberOfDimensions() < 3)
  {
    throw BadInput(ErrorCode::Dimension, fileName, "a 2-D image, need a 3-D one", "export one 3-D volume");
  }
  if (reader.GetNumberOfComponents() != 1)
  {
    throw BadInput(ErrorCode::PixelType,
                   fileName,
                   std::to_string(reader.GetNumberOfComponents()) + " values per voxel, need one",
                   "export one number per voxel");
  }
  if (static_cast<std::size_t>(reader.GetImageSizeInPixels()) > mostVoxels)
  {
    throw BadInput(ErrorCode::TooBig,
                   fileName,
                   std::to_string(reader.GetImageSizeInPixels()) + " voxels, at most " + std::to_string(mostVoxels),
                   "crop the image around the label");
  }
}

/** The nearest orthonormal matrix; headers carry seven digits at best. */
Matrix3
orthonormalDirection(const std::string & fileName, const Matrix3 & direction)
{
  if (!direction.allFinite())
  {
    throw BadInput(ErrorCode::Geometry, fileName, "the direction matrix is not finite", "correct the header");
  }
  const Eigen::JacobiSVD<Matrix3> svd(direction, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double                    deviation = (svd.singularValues().array() - 1.0).abs().maxCoeff();
  if (!(deviation <= 1e-3))
  {
    throw BadInput(ErrorCode::Geometry,
                   fileName,
                   "the image axes are not at right angles (direction matrix off by " + std::to_string(deviation) + ")",
                   "resample the image to a rectangular grid");
  }
  return svd.matrixU() * svd.matrixV().transpose();
}

/** Twelve significant digits: the length of a direction vector comes back as 0.49999999999999994 for 0.5. */
double
withoutRoundOff(double spacing)
{
  const double scale = std::pow(10.0, 12.0 - std::ceil(std::log10(spacing)));
  return std::round(spacing * scale) / scale;
}

/** The file's size and place. */
VoxelGrid
gridOf(const std::string & fileName, const itk::ImageIOBase & reader)
{
  VoxelGrid grid;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    grid.size[axis] = static_cast<int>(reader.GetDimensions(axis));
    grid.origin[axis] = reader.GetOrigin(axis);
    const double spacing = reader.GetSpacing(axis);
    if (!(spacing >= 1e-3 && spacing <= 1e3))
    {
      throw BadInput(ErrorCode::Geometry,
                     fileName,
                     "voxel size " + std::to_string(spacing) + " mm along axis " + std::to_string(axis + 1) +
                       ", need 0.001 to 1000",
                     "correct the header's spacing");
    }
    grid.spacing[axis] = withoutRoundOff(spacing);
    if (!(std::abs(grid.origin[axis]) <= 1e6))
    {
      throw BadInput(
        ErrorCode::Geometry, fileName, "the origin is not finite or above 1e6 mm", "correct the header's origin");
    }
    const std::vector<double> column = reader.GetDirection(axis);
    grid.direction.col(axis) = Vector3(column[0], column[1], column[2]);
  }
  grid.direction = orthonormalDirection(fileName, grid.direction);
  return grid;
}

/** pixdim and the sform give the voxel's size twice, each rounded to a float. The axes come from the sform, so its
 * lengths count: the volume of a voxel is then the determinant of the file's own matrix. */
void
takeColumnLengths(const std::string & fileName, VoxelGrid & grid)
{
  constexpr double sameLength = 1e-5;
  const auto       lengths = niftiColumnLengths(fileName);
  for (Eigen::Index axis = 0; lengths && axis < 3; ++axis)
  {
    const double length = (*lengths)[static_cast<std::size_t>(axis)];
    if (std::abs(length / grid.spacing[axis] - 1.0) < sameLength)
    {
      grid.spacing[axis] = withoutRoundOff(length);
    }
  }
}

} // namespace

ImageFile
openImageFile(const std::string & fileName)
{
  const ImageFormat format = formatOf(fileName);
  ImageFile         file;
  file.name = fileName;
  file.warnings = checkImageFile(fileName, format);
  file.reader = makeReader(format);
  file.reader->SetFileName(fileName);
  file.reader->ReadImageInformation();
  requireScalarVolume(fileName, *file.reader);
  file.grid = gridOf(fileName, *file.reader);
  if (format == ImageFormat::Nifti)
  {
    takeColumnLengths(fileName, file.grid);
  }
  itk::ImageIORegion region(file.reader->GetNumberOfDimensions());
  for (unsigned int axis = 0; axis < file.reader->GetNumberOfDimensions(); ++axis)
  {
    region.SetSize(axis, file.reader->GetDimensions(axis));
  }
  file.reader->SetIORegion(region);
  return file;
}

bool
isImageFileName(const std::string & fileName)
{
  return endsWithAny(fileName, { ".nrrd", ".nii", ".nii.gz", ".mha", ".mhd" });
}

std::string
firstLine(std::string text)
{
  // ITK puts its file, line and class before the message.
  const auto colon = text.rfind("): ");
  if (colon != std::string::npos)
  {
    text = text.substr(colon + 3);
  }
  return text.substr(0, text.find('\n'));
}

} // namespace moserhex
