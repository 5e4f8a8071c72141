#pragma once

#include "moserhex/HexMeshIO/FieldValues.h"
#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/FieldVolume.h"

#include <string>

namespace moserhex
{

/** Whether writeFieldImage takes a name: it ends with .nrrd, .nii or .nii.gz. */
[[nodiscard]] bool
isFieldImageName(const std::string & fileName);

/** Writes an image in LPS, complete or not at all: as gzip-compressed NRRD, which keeps NaN and infinity, or as
 * NIfTI-1, with several numbers along dim[5] (tensors: intent 1005, others: 1007) and the voxels' sizes and place to
 * the 7 digits of that format.
 *
 * \param axes  of several numbers, if they are vectors or tensors: in NIfTI's intent_name (LPS, CUBE, or none), in a
 *              NRRD's key MoserHexValueAxes (cube, unknown; nothing for LPS). Other programs take a NRRD's for LPS.
 * \param fileName  ends with .nrrd, .nii or .nii.gz
 * \throws BadInput      the name does not end so; as NIfTI-1: values that are not finite, more than 32767 along an axis
 * \throws InvalidInput  as requireValid(image); tensors of other than 6 components; labels of several components, or
 *                       that are not whole numbers from 0 to 2^31 - 1
 * \throws IOError       the file cannot be written, or reads back differently */
void
writeFieldImage(const std::string & fileName,
                const FieldVolume & image,
                FieldValues         values = FieldValues::Numbers,
                ValueAxes           axes = ValueAxes::Lps);

} // namespace moserhex
