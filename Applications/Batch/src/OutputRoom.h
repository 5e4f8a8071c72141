#pragma once

#include <cstdint>
#include <string>

namespace moserhex::app
{

/** Bytes that the files of one case may take, generously: a mesh of any format with its fields and report. */
[[nodiscard]] std::uint64_t
bytesOfCase(int shells, int paddingLayers);

/** Whether that many bytes can be written to a folder: by what its file system says is free, and, when asked to `try`,
 * by writing them, which also meets quotas and limits of file size. */
[[nodiscard]] bool
hasRoom(const std::string & folder, std::uint64_t bytes, bool tryIt);

} // namespace moserhex::app
