#pragma once

#include <string>

namespace moserhex
{

/** SHA-256 of all that an input consists of: of the file, or, where that is the header of an image whose voxels lie in
 * a file of their own (.nhdr, .mhd), over the checksums of both. \throws BadInput (NoInput)  no regular file, or it may
 * not be read; IOError  it cannot be read */
[[nodiscard]] std::string
sha256OfInput(const std::string & fileName);

} // namespace moserhex
