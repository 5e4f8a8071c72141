#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <string>
#include <vector>

namespace moserhex
{

/** An image of one or several numbers per voxel as read. */
struct FieldImage
{
  std::string                fileName; ///< as given to the reader
  FieldVolume                volume;   ///< LPS mm
  std::vector<unsigned char> hasValue; ///< of masked tensors, 1 for each voxel in the mask, 0 for those without data,
                                       ///< whose numbers are as in the file; empty: all voxels have data
  /** Whether vectors and tensors are known to be in LPS. Not of a NRRD in RAS or LAS, or with a measurement frame, and
   * of a NIfTI with several numbers per voxel unless its intent_name is LPS, as that of writeFieldImage is. The values
   * are as in the file. */
  bool                     valuesInLps{ true };
  std::vector<std::string> warnings; ///< one line each
};

/** Reads a three-dimensional image with any number of values per voxel, at most 4096: the files of readScalarImage, and
 *
 *   NRRD       a first or last axis of a kind that is not of space or time: vector, list, 3D-symmetric-matrix,
 *              RGB-color, ...; of 2D- and 3D-masked-matrix and -masked-symmetric-matrix the mask is taken apart: a
 * voxel has data where it is at least 0.5 NIfTI-1    dim[5] values (dim[4] is 1) of any intent; of a symmetric matrix
 * (intent 1005) the lower triangle comes out as xx, xy, xz, yy, yz, zz MetaImage  ElementNumberOfChannels
 *
 * As strict about the file as readScalarImage, and by the same code. Values are not judged.
 *
 * \param options  read in a child process or not, as with readLabelImage
 * \throws BadInput, IOError  as readScalarImage; (Header) another number of values than the kind or intent has */
[[nodiscard]] FieldImage
readFieldImage(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
