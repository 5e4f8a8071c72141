#pragma once

#include "ImageDescription.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

namespace moserhex
{

/** The segments of a Slicer .seg.nrrd, from its SegmentN_ID, _Name, _Layer and _LabelValue; none for other images.
 * Where layer and value are missing (Slicer before 4.11) a segment of a 4-D file is a layer of its own with value 1,
 * and of a 3-D file it has the value N + 1. \throws BadInput (Header)  a layer that is not there, a value that is not a
 * label */
[[nodiscard]] std::vector<SegmentEntry>
segmentsOf(const ImageDescription & image);

/** Number in `segments` of the one to read: by name, ID or number from 1; without a choice that of the only one in
 * layers, otherwise nothing: the file is a labelmap.
 * \throws BadInput (Labels)  the choice fits none or several; (Dimension)  several in layers and no choice. Both list
 *         the segments. */
[[nodiscard]] std::optional<std::size_t>
chosenSegment(const ImageDescription &           image,
              const std::vector<SegmentEntry> &  segments,
              const std::optional<std::string> & choice);

} // namespace moserhex
