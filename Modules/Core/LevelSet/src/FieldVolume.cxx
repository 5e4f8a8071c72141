#include "moserhex/LevelSet/FieldVolume.h"

#include "moserhex/Common/Errors.h"

namespace moserhex
{

void
requireValid(const FieldVolume & image, const std::string & what)
{
  requireValid(static_cast<const VoxelGrid &>(image), what);
  if (image.components < 1 || image.values.size() != image.gridVoxels() * static_cast<std::size_t>(image.components))
  {
    throw InvalidInput(what + ": " + std::to_string(image.values.size()) + " values for " +
                       std::to_string(image.gridVoxels()) + " voxels of " + std::to_string(image.components) +
                       " components");
  }
}

} // namespace moserhex
