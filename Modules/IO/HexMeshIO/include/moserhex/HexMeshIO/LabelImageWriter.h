#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <string>

namespace moserhex
{

/** Writes a labelmap as gzip-compressed NRRD in LPS, complete or not at all.
 *
 * \param fileName  ends with .nrrd
 * \param labels    `inside` holds the label of each voxel, 0 to 255
 * \throws BadInput  the name does not end with .nrrd
 * \throws IOError   the file cannot be written, or reads back differently */
void
writeLabelImage(const std::string & fileName, const LabelVolume & labels);

} // namespace moserhex
