#pragma once

#include "SurfaceFormats.h"

#include <string>

namespace moserhex
{

/** A surface as bytes, to be handed from the process that read it to the one that uses it. */
[[nodiscard]] std::string
bytesOf(const RawSurface & surface);

/** The inverse. The other process saw a file that nobody vouches for, so nothing is taken on trust.
 * \throws BadInput (ReaderFailed)  not what bytesOf makes of a surface with finite coordinates and indices in range */
[[nodiscard]] RawSurface
rawSurfaceOf(const std::string & fileName, const std::string & bytes);

} // namespace moserhex
