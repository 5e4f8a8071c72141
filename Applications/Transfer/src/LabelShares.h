#pragma once

#include "TransferFiles.h"
#include "TransferLog.h"
#include "moserhex/CubeTransfer/CubeSamples.h"

#include <map>
#include <string>
#include <vector>

namespace moserhex::app
{

/** Leaves out labels that have no voxel around the mesh: nothing of them can be in the organ. */
void
keepLabelsAround(const HexMesh & mesh, TransferImage & image);

/** Whether there are few enough labels for shares. */
[[nodiscard]] bool
hasShares(const TransferImage & image);

/** The labels that places can have, ascending: 0, those of the image, and the background's.
 * \throws UsageError  more than 256, which is too many for shares */
[[nodiscard]] std::vector<double>
labelsOfPlaces(const TransferImage & image, double background);

/** Of every box the part of its volume in each label. \param labelAt  sets the label of a place */
[[nodiscard]] CubeMeans
labelFractions(const HexMesh &             mesh,
               const CubeFunction &        labelAt,
               const std::vector<double> & labels,
               const CubeMeanOptions &     options);

/** The label with the largest part of each box, of equal ones the smallest. \param labels  of the fractions */
[[nodiscard]] FieldVolume
majority(const FieldVolume & fractions, const std::vector<double> & labels);

/** Without the first component, that of label 0. */
[[nodiscard]] FieldVolume
withoutZero(const FieldVolume & fractions);

/** How much there is of each label: a volume, or a number of places. */
using LabelAmounts = std::map<double, double>;

/** Volumes of labels in the organ [mm3]. \param fractions  of `labels`, with volumes */
[[nodiscard]] LabelAmounts
volumesOf(const CubeMeans & fractions, const std::vector<double> & labels);

/** Sums of the weights of places by their labels; labels that are not finite are of no place.
 * \param weights  one for each place */
[[nodiscard]] LabelAmounts
amountsOf(const std::vector<double> & labels, const std::vector<double> & weights);

/** What an output holds of each label. */
struct LabelsAfter
{
  LabelAmounts amounts;
  std::string  unit;   ///< "mm3 in the cube"
  std::string  place;  ///< "box of the cube", in warnings
  std::string  remedy; ///< for labels that have no place
};

/** Tells each label's volume in the organ and what came of it, and warns of those that have no place any more. */
void
reportLabels(const std::vector<LabelEntry> & labels,
             const LabelAmounts &            before,
             const LabelsAfter &             after,
             const TransferLog &             log);

} // namespace moserhex::app
