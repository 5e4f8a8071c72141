#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/HexMeshIO/ReadOptions.h"

#include <itkImage.h>

#include <string>
#include <vector>

namespace moserhex
{

/** An image of one number per voxel in ITK's terms. */
using ScalarImageType = itk::Image<double, 3>;

/** A scalar image as read: LPS millimetres, right-handed or not as the file says. */
struct ScalarImage
{
  std::string              fileName; ///< as given to the reader
  ScalarImageType::Pointer image;    ///< the voxels
  std::vector<std::string> warnings; ///< one line each
};

/** Reads a three-dimensional scalar image, a density: the files of readLabelImage (isLabelImageName), of any integer
 * or real voxel type, with a NIfTI file's slope and intercept applied. As strict about the file as readLabelImage, and
 * by the same code. Values are not judged, NaN and infinity included (of NIfTI files ITK makes them 0): what counts is
 * the label (densityOnLabel).
 *
 * \param options  read in a child process or not, as with readLabelImage
 * \throws BadInput  the file is missing or damaged; not a 3-D scalar image; spacing not in [1e-3, 1e3] mm; direction
 *                   not orthonormal within 1e-3
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] ScalarImage
readScalarImage(const std::string & fileName, const ReadOptions & options = {});

} // namespace moserhex
