#pragma once

#include "ImageDescription.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <itkMacro.h>

#include <new>
#include <string>
#include <vector>

namespace moserhex
{

/** Whether the voxels are read without ITK: their layout is not plain, or ITK would make 0 of some of them. */
[[nodiscard]] bool
isReadWithoutItk(const ImageDescription & image);

/** What a voxel is when it is handed over: the type of the file, or a real number where slope and intercept are applied
 * (NIfTI): float, or double where the file has doubles. Always double where they are read without ITK. */
[[nodiscard]] ComponentType
deliveredComponent(const ImageDescription & image);

/** Reads the voxels of a checked image into `buffer`, as many deliveredComponent as there are voxels times layers. The
 * one reader of the format is called by name: no factory, so no other parser ever sees the file.
 * \param itkName  see NiftiLink
 * \throws BadInput (ReaderFailed)  it sees another image than the check did; itk::ExceptionObject */
void
readByItk(const ImageDescription & image, const std::string & itkName, void * buffer);

/** \throws BadInput (ReaderFailed)  ITK delivered other bytes than the file holds. Not known for scaled images. */
void
requireDelivered(const ImageDescription & image, const void * buffer);

/** The values of a checked image without ITK, which leaves masks out and takes fewer kinds: a voxel's together, its
 * mask first, symmetric matrices as xx, xy, xz, yy, yz, zz, scaled. \throws BadInput (ReaderFailed)  the file has
 * changed since it was checked; as checkVoxelBytes */
[[nodiscard]] std::vector<double>
rearrangedValues(const ImageDescription & image);

/** Checks the whole file and calls body(description, std::vector<TVoxel>): the voxels as stored, layers fastest, of
 * type deliveredComponent. \param sandboxed  in a child of runInSandbox: memory is
 * allowed as the header's promises are believed \throws BadInput  see checkImageFile; (ReaderFailed)  ITK refuses the
 * file or reads other bytes; IOError */
template <typename TBody>
void
withCheckedVoxels(const std::string & fileName,
                  const std::string & itkName,
                  bool                sandboxed,
                  VoxelContent        content,
                  const TBody &       body);

/** Header, memory, bytes: what withCheckedVoxels does before ITK. */
[[nodiscard]] ImageDescription
checkedDescription(const std::string & fileName, bool sandboxed, VoxelContent content);

/** What a library said, in one line and without the place in its source that ITK puts before it. */
[[nodiscard]] std::string
withoutPlace(std::string text);

/** \throws BadInput (TooBig) */
[[noreturn]] void
throwTooBig(const std::string & fileName);

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
    throwTooBig(fileName);
  }
  catch (const itk::MemoryAllocationError &)
  {
    throwTooBig(fileName);
  }
  catch (const std::exception & error)
  {
    throw BadInput(
      ErrorCode::ReaderFailed, fileName, withoutPlace(error.what()), "export the image again, for example as .nrrd");
  }
}

template <typename TBody>
void
withCheckedVoxels(const std::string & fileName,
                  const std::string & itkName,
                  bool                sandboxed,
                  VoxelContent        content,
                  const TBody &       body)
{
  withImageErrors(fileName, [&] {
    const ImageDescription image = checkedDescription(fileName, sandboxed, content);
    if (isReadWithoutItk(image))
    {
      body(image, rearrangedValues(image));
      return;
    }
    withComponent(deliveredComponent(image), [&](auto zero) {
      std::vector<decltype(zero)> voxels(image.grid.gridVoxels() * static_cast<std::size_t>(image.layers));
      readByItk(image, itkName, voxels.data());
      requireDelivered(image, voxels.data());
      body(image, voxels);
    });
  });
}

} // namespace moserhex
