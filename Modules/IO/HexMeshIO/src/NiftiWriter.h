#pragma once

#include "moserhex/HexMeshIO/FieldImageWriter.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moserhex
{

/** Whether the name is one of those that writeNiftiFile takes: .nii .nii.gz. */
[[nodiscard]] bool
isNiftiName(const std::string & fileName);

/** Writes an image as NIfTI-1 with qform and sform, complete or not at all; by ending compressed or not.
 *
 * Several numbers per voxel lie along dim[5], symmetric tensors by their lower triangle with intent 1005, others with
 * intent 1007; intent_name says that they are in LPS. Place and sizes of the voxels are 32-bit numbers in this format.
 * \param labels  of the voxels, written instead of the image's values; empty: none
 * \throws BadInput (Usage)  a value that is not finite, which readers make 0 of; more than 32767 voxels along an axis
 *                           or numbers per voxel
 * \throws IOError           it cannot be written, or reads back differently */
void
writeNiftiFile(const std::string &               fileName,
               const FieldVolume &               image,
               FieldValues                       values,
               ValueAxes                         axes,
               const std::vector<std::int32_t> & labels);

} // namespace moserhex
