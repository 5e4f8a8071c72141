#pragma once

#include "ReaderSandbox.h"
#include "SurfaceFormats.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <string>

namespace moserhex
{

// A mesh as bytes, to be handed from the process that read it to the one that uses it. The other process saw a file
// that nobody vouches for, so nothing that comes back is taken on trust.

/** For a mesh that a library reads: 1 GB, and 64 times the file, whose arrays may be compressed. */
[[nodiscard]] SandboxLimits
meshReadingLimits(const std::string & fileName);

[[nodiscard]] std::string
bytesOf(const RawSurface & surface);

/** The inverse.
 * \throws BadInput (ReaderFailed)  not what bytesOf makes of a surface with finite coordinates and indices in range */
[[nodiscard]] RawSurface
rawSurfaceOf(const std::string & fileName, const std::string & bytes);

[[nodiscard]] std::string
bytesOf(const HexCellFile & file);

/** The inverse.
 * \throws BadInput (ReaderFailed)  not what bytesOf makes of a valid mesh (requireValid) */
[[nodiscard]] HexCellFile
hexCellFileOf(const std::string & fileName, const std::string & bytes);

/** Runs `read`, which calls a library, in a child process with memory in proportion to the file.
 * \param unpack  rawSurfaceOf or hexCellFileOf \throws BadInput  as read; (ReaderFailed, TooBig)  see runInSandbox */
template <typename TRead, typename TUnpack>
[[nodiscard]] auto
inSandbox(const std::string & fileName, const TRead & read, const TUnpack & unpack)
{
  return unpack(fileName, runInSandbox(fileName, meshReadingLimits(fileName), [&read] { return bytesOf(read()); }));
}

} // namespace moserhex
