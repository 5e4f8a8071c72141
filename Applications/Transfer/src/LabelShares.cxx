#include "LabelShares.h"

#include "CommandErrors.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{

constexpr std::size_t mostFractions = 256;

} // namespace

CubeMeans
labelFractions(const HexMesh &         mesh,
               const SubjectFunction & f,
               const TransferImage &   image,
               const CubeMeanOptions & options)
{
  if (image.labels.size() >= mostFractions)
  {
    throw UsageError("--labels: " + std::to_string(image.labels.size()) + " labels, at most " +
                     std::to_string(mostFractions - 1) + " by cells; take --sampling nodes");
  }
  std::vector<double> labels{ 0.0 };
  std::transform(image.labels.begin(), image.labels.end(), std::back_inserter(labels), [](const LabelEntry & entry) {
    return static_cast<double>(entry.value);
  });
  const auto indicators = [&f, &labels](const CubePoint & point, double * values) {
    double label = 0.0;
    f(point, &label);
    std::transform(labels.begin(), labels.end(), values, [label](double other) { return label == other ? 1.0 : 0.0; });
  };
  return cubeMeans(mesh, indicators, static_cast<int>(labels.size()), options);
}

FieldVolume
majority(const FieldVolume & fractions, const std::vector<LabelEntry> & labels)
{
  FieldVolume result{ fractions, 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    const double * const first = fractions.at(box);
    const auto           largest = std::max_element(first, first + fractions.components) - first;
    result.values.push_back(largest == 0 ? 0.0 : labels[static_cast<std::size_t>(largest - 1)].value);
  }
  return result;
}

FieldVolume
withoutBackground(const FieldVolume & fractions)
{
  FieldVolume result{ fractions, fractions.components - 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    result.values.insert(result.values.end(), fractions.at(box) + 1, fractions.at(box) + fractions.components);
  }
  return result;
}

} // namespace moserhex::app
