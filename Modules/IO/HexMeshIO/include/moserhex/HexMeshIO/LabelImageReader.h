#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <itkImage.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

using LabelValue = std::int32_t;
using LabelImageType = itk::Image<LabelValue, 3>;

/** One label of an image. */
struct LabelEntry
{
  LabelValue  value{ 0 };
  std::size_t voxels{ 0 };
  std::string name; ///< segment name of a Slicer .seg.nrrd; empty elsewhere
};

/** A labelmap as read: LPS millimetres, right-handed or not as the file says. */
struct LabelImage
{
  std::string              fileName;
  LabelImageType::Pointer  image;
  std::vector<LabelEntry>  labels;   ///< labels other than 0, ascending by value
  std::vector<std::string> warnings; ///< one line each
};

/** Whether the name ends like a labelmap this reader takes: .nrrd .nii .nii.gz .mha .mhd (any case). */
[[nodiscard]] bool
isLabelImageName(const std::string & fileName);

/** Reads a three-dimensional labelmap: .nrrd (.seg.nrrd), .nii, .nii.gz, .mha, .mhd.
 *
 * Any integer pixel type; floating-point pixels when every value is a whole number. Nothing wraps around: a value
 * outside LabelValue is refused. Exactly one reader looks at the file, chosen by extension. Before ITK sees the file,
 * its header is checked for what ITK does not survive (non-finite geometry, over-long tokens, impossible dimensions)
 * and the bytes present are compared with the bytes promised, so a cut file is refused and never filled with zeros.
 *
 * \throws BadInput  the file is missing or damaged; not a 3-D scalar image; spacing not in [1e-3, 1e3] mm; direction
 *                   not orthonormal within 1e-3; a value that is not a whole number or not a LabelValue; no label
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] LabelImage
readLabelImage(const std::string & fileName);

/** The entry to work on: `wanted`, or the only label there is.
 * \throws BadInput  `wanted` is absent, or nothing is wanted and there are several; the message lists the labels */
[[nodiscard]] const LabelEntry &
chooseLabel(const LabelImage & image, const std::optional<LabelValue> & wanted);

/** The voxels of one label. */
[[nodiscard]] LabelVolume
labelVolumeOf(const LabelImageType & image, LabelValue label);

/** The voxels of a volume as an image: 1 inside, 0 outside. */
[[nodiscard]] LabelImageType::Pointer
labelImageOf(const LabelVolume & volume);

} // namespace moserhex
