#pragma once

#include "moserhex/HexMeshIO/FileErrors.h"
#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/Quality/CellLabels.h"

#include <itkImage.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** A label; 0 is the background. */
using LabelValue = std::int32_t;
/** A labelmap in ITK's terms. */
using LabelImageType = itk::Image<LabelValue, 3>;

/** One label of an image. */
struct LabelEntry
{
  LabelValue  value{ 0 };  ///< not 0
  std::size_t voxels{ 0 }; ///< that have it
  std::string name;        ///< segment name of a Slicer .seg.nrrd; empty elsewhere
};

/** One segment of a Slicer .seg.nrrd: the voxels of one label value in one layer. Layers overlap, segments of a layer
 * do not. */
struct SegmentEntry
{
  std::string name;        ///< empty: the file gives none
  std::string id;          ///< as Slicer gives it; empty: the file gives none
  int         layer{ 0 };  ///< from 0; 0 in a file without layers
  LabelValue  value{ 1 };  ///< of its voxels in the layer
  std::size_t voxels{ 0 }; ///< of it; 0 where a threshold was asked for
};

/** A labelmap as read: LPS millimetres, right-handed or not as the file says. */
struct LabelImage
{
  std::string               fileName; ///< as given to the reader
  LabelImageType::Pointer   image;    ///< the voxels
  std::vector<LabelEntry>   labels;   ///< labels other than 0, ascending by value
  std::vector<std::string>  warnings; ///< one line each
  std::vector<SegmentEntry> segments; ///< all of a Slicer .seg.nrrd, in its order; empty elsewhere
};

/** Options of readLabelImage. */
struct LabelReadOptions
{
  std::optional<double>      threshold;       ///< voxels at or above it become label 1, all others 0
  std::optional<std::string> segment;         ///< of a .seg.nrrd: its name, its ID, or its number in the file, from 1
  bool                       sandbox{ true }; ///< read in a child process; see readLabelImage
  bool                       allowEmpty{ false }; ///< an image without labels is read, with a warning, not refused
  /** What the user can do about values that are fractions. */
  std::string remedyForFractions{ "give --threshold for a probability map, or integer labels" };
};

/** Whether this reader takes a file of this name: .nrrd .nhdr .nii .nii.gz .mha .mhd (any case), or a name without any
 * ending when the content is of one of these formats. */
[[nodiscard]] bool
isLabelImageName(const std::string & fileName);

/** Reads a three-dimensional labelmap: NRRD (.seg.nrrd too), NIfTI-1, MetaImage.
 *
 * Any integer pixel type; floating-point pixels when every value is within 1e-4 of a whole number (those that are not
 * exactly whole are counted in a warning). Nothing wraps around: a value outside LabelValue is refused, and so are
 * negative ones, which are no labels. Exactly one reader looks at the file. Before ITK sees it, its header is checked
 * and its voxels are decoded once, so a cut file is refused and never filled with zeros; afterwards ITK's voxels are
 * compared with those (CRC-32).
 *
 * Voxel sizes, axes and origin are those of the file's own grid: a cropped segmentation stands where its header says,
 * whatever its Segmentation_ReferenceImageExtentOffset. Of a segmentation in layers (4-D) one segment must be chosen
 * when there are several; a name counts before an ID, an ID before a number.
 *
 * With options.sandbox (the default) all this is done in a forked child process with limits of memory, CPU and wall
 * time, which writes no files; see the notes on threads at runInSandbox in src/ReaderSandbox.h: call it before other
 * threads work, or switch it off.
 *
 * \throws BadInput  the file is missing or damaged; not a 3-D scalar image; spacing not in [1e-3, 1e3] mm; direction
 *                   not orthonormal within 1e-3; a value that is not a label; no label, unless it may be empty; no such
 *                   segment; the child died
 * \throws InvalidInput (Usage)  both a threshold and a segment; a threshold that is not finite
 * \throws IOError   the file cannot be opened or read */
[[nodiscard]] LabelImage
readLabelImage(const std::string & fileName, const LabelReadOptions & options = {});

/** The entry to work on: `wanted`, or the only label there is.
 * \throws BadInput  `wanted` is absent, or nothing is wanted and there are several; the message lists the labels */
[[nodiscard]] const LabelEntry &
chooseLabel(const LabelImage & image, const std::optional<LabelValue> & wanted);

/** The voxels of one label. */
[[nodiscard]] LabelVolume
labelVolumeOf(const LabelImageType & image, LabelValue label);

/** The voxels of all labels together: every one that is not 0. */
[[nodiscard]] LabelVolume
labelVolumeOfAll(const LabelImageType & image);

/** All labels on their voxels. */
[[nodiscard]] LabelValues
labelValuesOf(const LabelImageType & image);

/** The voxels of a volume as an image: 1 inside, 0 outside. */
[[nodiscard]] LabelImageType::Pointer
labelImageOf(const LabelVolume & volume);

} // namespace moserhex
