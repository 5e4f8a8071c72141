#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/HexMeshIO/FieldValues.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** An image of one or several numbers per voxel as read. */
struct FieldImage
{
  std::string fileName; ///< as given to the reader
  FieldVolume volume;   ///< LPS mm
  std::vector<unsigned char>
    hasValue; ///< 1 for each voxel with data, 0 for those outside the mask of masked tensors or
              ///< with a number that is not finite; these are as in the file; empty: all have
  FieldValues kind{ FieldValues::Numbers }; ///< SymmetricTensors where the file says so: its kind, or its intent
  /** Takes vectors to LPS from the space that the file has them in: the measurement frame of a NRRD, or LPS. Nothing
   * where the file leaves that space open: a NRRD in RAS or LAS without a measurement frame, a NIfTI with several
   * numbers per voxel unless its intent_name is LPS, and what writeFieldImage wrote so. The values are as in the file.
   */
  std::optional<Matrix3>   valuesToLps{ Matrix3::Identity() };
  bool                     inCubeAxes{ false }; ///< the values are in the cube's axes, and valuesToLps is nothing
  std::vector<std::string> warnings;            ///< one line each
  std::vector<std::string> gridWarnings; ///< those of them that are about the header and its grid, not the values
};

/** Reads a three-dimensional image with any number of values per voxel, at most 4096: the files of readScalarImage, and
 *
 * - NRRD: a first or last axis of a kind that is not of space or time: vector, list, 3D-symmetric-matrix, RGB-color,
 *   ...; of 2D- and 3D-masked-matrix and -masked-symmetric-matrix the mask is taken apart: a voxel has data where it is
 *   at least 0.5.
 * - NIfTI-1: dim[5] values (dim[4] is 1) of any intent; of a symmetric matrix (intent 1005) the lower triangle comes
 * out as xx, xy, xz, yy, yz, zz.
 * - MetaImage: ElementNumberOfChannels.
 *
 * As strict about the file as readScalarImage, and by the same code. Values are not judged, but voxels with one that is
 * not finite count as without data, with a warning; they come out as they are, of NIfTI too.
 *
 * \param options  read in a child process or not, as with readLabelImage
 * \throws BadInput, IOError  as readScalarImage; (Header) another number of values than the kind or intent has */
[[nodiscard]] FieldImage
readFieldImage(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
