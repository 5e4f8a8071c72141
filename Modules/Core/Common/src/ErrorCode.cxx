#include "moserhex/Common/ErrorCode.h"

#include <array>

namespace moserhex
{
namespace
{

struct Entry
{
  const char * name;
  int          exitStatus;
};

// In the order of ErrorCode.
constexpr std::array<Entry, static_cast<std::size_t>(lastErrorCode) + 1> table{ {
  { "E_USAGE", 2 },
  { "E_NOINPUT", 3 },
  { "E_EMPTY", 3 },
  { "E_FORMAT", 3 },
  { "E_HEADER", 3 },
  { "E_TRUNCATED", 3 },
  { "E_CHECKSUM", 3 },
  { "E_TOO_BIG", 3 },
  { "E_REFERENCE", 3 },
  { "E_UNSUPPORTED", 3 },
  { "E_DIMENSION", 3 },
  { "E_PIXELTYPE", 3 },
  { "E_GEOMETRY", 3 },
  { "E_LABELS", 3 },
  { "E_EMPTY_LABEL", 3 },
  { "E_TOPOLOGY", 3 },
  { "E_THIN", 3 },
  { "E_DENSITY", 3 },
  { "E_TEMPLATE", 3 },
  { "E_TEMPLATE_IMAGE", 3 },
  { "E_TEMPLATE_LANDMARKS", 3 },
  { "E_IMAGE", 3 },
  { "E_LANDMARKS", 3 },
  { "E_SURFACE_OPEN", 3 },
  { "E_SURFACE_NONMANIFOLD", 3 },
  { "E_SURFACE_INDEX", 3 },
  { "E_SURFACE_NAN", 3 },
  { "E_SURFACE_DEGENERATE", 3 },
  { "E_SURFACE_INTERSECTS", 3 },
  { "E_NOT_HEXAHEDRA", 3 },
  { "E_READER", 3 },
  { "E_PRECONDITION", 3 },
  { "E_NOT_CONVERGED", 4 },
  { "E_NOT_EXACT", 4 },
  { "E_SHAPE", 4 },
  { "E_MEMORY", 4 },
  { "E_TIMEOUT", 4 },
  { "E_CRASH", 70 },
  { "E_INTERNAL", 70 },
  { "E_CANTCREAT", 74 },
  { "E_IO", 74 },
  { "E_LOCKED", 75 },
  { "E_CANCELLED", 130 },
} };

} // namespace

const char *
nameOf(ErrorCode code)
{
  return table[static_cast<std::size_t>(code)].name;
}

int
exitStatusOf(ErrorCode code)
{
  return table[static_cast<std::size_t>(code)].exitStatus;
}

} // namespace moserhex
