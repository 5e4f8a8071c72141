#pragma once

#include "LabelSlice.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What the slices of a page show. */
struct SliceContent
{
  const LabelImageType *  image{ nullptr };
  std::vector<LabelEntry> labels;          ///< at least one, each in the image
  const HexMesh *         mesh{ nullptr }; ///< null: there is none
};

/** Nine <figure>: axial, coronal and sagittal, each through the middle and halfway to both ends of the label. The label
 * is filled, the mesh's surface and shells are lines. Seen as radiologists do: the patient's right on the left. Letters
 * mark the directions, a bar has its length in mm.
 * \return empty where the image has none of the labels */
[[nodiscard]] std::string
sliceFigures(const SliceContent & content);

/** What the colours of the slices mean, as a list. */
[[nodiscard]] std::string
sliceLegend(const SliceContent & content);

} // namespace moserhex::app
