#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <itkImageIOBase.h>

#include <new>
#include <string>
#include <vector>

namespace moserhex
{

/** A three-dimensional scalar image: header read and checked, voxels not yet. */
struct ImageFile
{
  std::string               name;
  itk::ImageIOBase::Pointer reader;
  VoxelGrid                 grid;     ///< direction orthonormal to round-off
  std::vector<std::string>  warnings; ///< one line each
};

/** Opens .nrrd .nii .nii.gz .mha .mhd. Exactly one reader looks at the file, chosen by extension, and only after
 * checkImageFile has passed it.
 * \throws BadInput  see readLabelImage, apart from what it says about the values
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] ImageFile
openImageFile(const std::string & fileName);

/** Whether openImageFile takes a file of this name. */
[[nodiscard]] bool
isImageFileName(const std::string & fileName);

/** What a library said, without the place in its source that ITK puts before it. */
[[nodiscard]] std::string
firstLine(std::string text);

/** Runs `read` and turns what it throws, other than errors of ours, into BadInput about the file. */
template <typename TRead>
auto
withImageErrors(const std::string & fileName, const TRead & read)
{
  try
  {
    return read();
  }
  catch (const Error &)
  {
    throw;
  }
  catch (const std::bad_alloc &)
  {
    throw BadInput(ErrorCode::TooBig, fileName, "not enough memory for the image", "crop the image around the label");
  }
  catch (const std::exception & error)
  {
    throw BadInput(
      ErrorCode::PixelType, fileName, firstLine(error.what()), "export the image again, for example as .nrrd");
  }
}

/** Reads the voxels as they are stored and calls body(std::vector<TVoxel>), TVoxel any arithmetic type.
 * \throws BadInput  an unknown voxel type; itk::ExceptionObject */
template <typename TBody>
void
withVoxels(const ImageFile & file, const TBody & body)
{
  const auto readAs = [&](auto zero) {
    std::vector<decltype(zero)> voxels(file.grid.gridVoxels());
    file.reader->Read(voxels.data());
    body(voxels);
  };
  using Component = itk::ImageIOBase::IOComponentEnum;
  switch (file.reader->GetComponentType())
  {
    case Component::UCHAR:
      return readAs(static_cast<unsigned char>(0));
    case Component::CHAR:
      return readAs(static_cast<signed char>(0));
    case Component::USHORT:
      return readAs(static_cast<unsigned short>(0));
    case Component::SHORT:
      return readAs(static_cast<short>(0));
    case Component::UINT:
      return readAs(0U);
    case Component::INT:
      return readAs(0);
    case Component::ULONG:
      return readAs(0UL);
    case Component::LONG:
      return readAs(0L);
    case Component::ULONGLONG:
      return readAs(0ULL);
    case Component::LONGLONG:
      return readAs(0LL);
    case Component::FLOAT:
      return readAs(0.0F);
    case Component::DOUBLE:
      return readAs(0.0);
    default:
      throw BadInput(
        ErrorCode::PixelType, file.name, "an unknown voxel type", "export one integer or real number per voxel");
  }
}

} // namespace moserhex
