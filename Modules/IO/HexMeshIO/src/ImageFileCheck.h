#pragma once

#include "ImageDescription.h"

#include <string>

namespace moserhex
{

/** Checks an image file before ITK's reader sees it.
 *
 * ITK 5.2 aborts, hangs or overruns memory on some headers, accepts contradicting ones and fills cut NIfTI and
 * MetaImage files with zeros. So nothing goes on to it unless the header and the voxels pass: see checkImageHeader and
 * checkVoxelBytes. No library but zlib is used here.
 *
 * \throws BadInput, IOError */
ImageDescription
checkImageFile(const std::string & fileName, ImageFormat format, VoxelContent content = VoxelContent::OneValue);

/** The first half of checkImageFile, which reads no voxels: a regular file of its format; every token shorter than the
 * libraries' buffers; fields known, well-formed, given once and agreeing with each other; numbers per voxel as
 * `content` says on a 3-D grid (axes of size 1 apart); voxel sizes in [1e-3, 1e3] mm, right angles within 1e-3, finite
 * origin; data in the same file or in one plain file beside it, in the same folder after links are followed; no more
 * voxels than the library takes or than the bytes can hold. \throws BadInput, IOError */
ImageDescription
checkImageHeader(const std::string & fileName, ImageFormat format, VoxelContent content = VoxelContent::OneValue);

/** The second half: decodes the voxels to their end. Sets the checksum; bytes after the voxels are a warning, and of a
 * compressed stream that goes on at most 16 MB more are decoded in search of its own checksum.
 * \param kept  room for promisedBytes: the voxels in this machine's byte order, in the order of the file; null: not
 * kept \throws BadInput  fewer bytes than promised (Truncated), damaged compressed bytes (Checksum), text that is not
 * numbers of the voxel type (Header); IOError */
void
checkVoxelBytes(ImageDescription & image, char * kept = nullptr);

/** The format by the name's ending, or by the content where the name has no ending.
 * \throws BadInput  neither; content of another kind than the ending says, which is named */
[[nodiscard]] ImageFormat
imageFormatOf(const std::string & fileName);

/** Whether imageFormatOf finds a format, without judging the content of files that have an image's ending. */
[[nodiscard]] bool
isImageFileName(const std::string & fileName);

/** \throws BadInput (NoInput) unless the name is an existing, regular file that may be reached; IOError */
void
requireRegularFile(const std::string & fileName);

/** \throws BadInput unless the name is an existing, non-empty, regular file that may be read; IOError when
 * it cannot be opened for another reason */
void
requireReadableFile(const std::string & fileName);

} // namespace moserhex
