#include "OutputRoom.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <filesystem>

namespace moserhex::app
{

namespace fs = std::filesystem;

std::uint64_t
bytesOfCase(int shells, int paddingLayers)
{
  // The longest are texts: 3 x 25 characters a node, 9 x 8 and three fields of 25 a cell, sets; and the report.
  constexpr std::uint64_t bytesPerNode = 400;
  constexpr std::uint64_t bytesOfReport = 64 * 1024;
  return bytesPerNode * nodeCount(2 * shells, paddingLayers) + bytesOfReport;
}

bool
hasRoom(const std::string & folder, std::uint64_t bytes, bool tryIt)
{
  std::error_code      failed;
  const fs::space_info space = fs::space(folder, failed);
  if (!failed && space.available < bytes)
  {
    return false;
  }
  if (!tryIt)
  {
    return true;
  }
  try
  {
    const AtomicFile probe((fs::path(folder) / ".room").string());
    probe.writeText(std::string(bytes, '\0'));
    return true;
  }
  catch (const Error &)
  {
    return false;
  }
}

} // namespace moserhex::app
