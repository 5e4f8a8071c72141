#pragma once

#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/LevelSet/VoxelGrid.h"

#include <itkImageIOBase.h>

#include <functional>
#include <string>

namespace moserhex
{

/** The key of the axes that values are in: "cube" or "unknown". */
constexpr const char * nrrdAxesKey = "MoserHexValueAxes";

/** What the voxels of a file to write are. */
struct NrrdVoxels
{
  const void *         values{ nullptr }; ///< components fastest
  itk::IOComponentEnum component{ itk::IOComponentEnum::UCHAR };
  itk::IOPixelEnum     pixel{ itk::IOPixelEnum::SCALAR };
  unsigned int         components{ 1 };
  std::string          axes{}; ///< of the key nrrdAxesKey; empty: none
};

/** Writes a gzip-compressed NRRD in LPS, complete or not at all.
 * \param what    of the file, in messages: "labelmap"
 * \param isSame  whether the file of this name reads back as what was to be written
 * \throws BadInput (Usage)  the name does not end with .nrrd; IOError  it cannot be written, or reads back differently
 */
void
writeNrrdFile(const std::string &                              fileName,
              const std::string &                              what,
              const VoxelGrid &                                grid,
              const NrrdVoxels &                               voxels,
              const std::function<bool(const std::string &)> & isSame);

/** Whether a grid that was read is the one that was written. */
[[nodiscard]] bool
isSamePlace(const VoxelGrid & read, const VoxelGrid & written);

} // namespace moserhex
