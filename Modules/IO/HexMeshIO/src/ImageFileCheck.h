#pragma once

#include <string>
#include <vector>

namespace moserhex
{

/** The image formats, by extension. */
enum class ImageFormat
{
  Nrrd,
  Nifti,
  Meta
};

/** Checks an image file before ITK's reader sees it.
 *
 * ITK 5.2 aborts, hangs or overruns memory on some headers and fills cut NIfTI and MetaImage files with zeros, so:
 * a regular file of its format; every header token of sane length; exactly three dimensions (further ones of size 1
 * allowed in NIfTI); scalar pixels; finite geometry; data in the same file, or for .mhd in one plain file beside it;
 * and as many bytes of data as the header promises, compressed streams decoded to the end with their checksum.
 *
 * \return warnings, one line each
 * \throws BadInput, IOError */
std::vector<std::string>
checkImageFile(const std::string & fileName, ImageFormat format);

/** \throws BadInput unless the name is an existing, non-empty, regular file; IOError when it cannot be opened */
void
requireReadableFile(const std::string & fileName);

} // namespace moserhex
