#pragma once

#include "SubjectFunction.h"
#include "TransferFiles.h"
#include "moserhex/CubeTransfer/CubeSamples.h"

#include <vector>

namespace moserhex::app
{

/** Of every box the part of its volume in each label, 0 first. \throws UsageError  more than 255 labels */
[[nodiscard]] CubeMeans
labelFractions(const HexMesh &         mesh,
               const SubjectFunction & f,
               const TransferImage &   image,
               const CubeMeanOptions & options);

/** The label with the largest part of each box, of equal ones the smallest. */
[[nodiscard]] FieldVolume
majority(const FieldVolume & fractions, const std::vector<LabelEntry> & labels);

/** Without the first component, the background's. */
[[nodiscard]] FieldVolume
withoutBackground(const FieldVolume & fractions);

} // namespace moserhex::app
