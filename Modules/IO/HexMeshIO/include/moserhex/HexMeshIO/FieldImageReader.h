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
  std::string fileName;
  FieldVolume volume;                ///< LPS mm
  bool        valuesInLps{ true };   ///< false: a NRRD in RAS or LAS, or with a measurement frame, which
                                     ///< vectors and tensors may be in; their values are as in the file
  std::vector<std::string> warnings; ///< one line each
};

/** Reads a three-dimensional image with any number of values per voxel, at most 4096: the files of readScalarImage,
 * NRRD with a first axis of a kind that is not of space (list, vector, 3D-symmetric-matrix, RGB-color, ...) and
 * MetaImage with ElementNumberOfChannels. As strict about the file as readScalarImage, and by the same code. Values are
 * not judged. NIfTI vectors and masked tensors are refused, and so is a last axis of values.
 *
 * \param options  read in a child process or not, as with readLabelImage
 * \throws BadInput, IOError  as readScalarImage */
[[nodiscard]] FieldImage
readFieldImage(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
