#include "LabelShares.h"

#include "CommandErrors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace moserhex::app
{
namespace
{

constexpr std::size_t mostShares = 256;

std::string
amountText(double amount)
{
  char text[32];
  std::snprintf(text, sizeof text, amount < 1000.0 ? "%.4g" : "%.0f", amount); // no powers of ten
  return text;
}

double
amountOf(const LabelAmounts & amounts, LabelValue label)
{
  const auto entry = amounts.find(label);
  return entry == amounts.end() ? 0.0 : entry->second;
}

} // namespace

void
keepLabelsAround(const HexMesh & mesh, TransferImage & image)
{
  if (image.labels.empty())
  {
    return;
  }
  const FieldVolume & volume = image.volume;
  Vector3             lower = volume.continuousIndex(mesh.nodes.front());
  Vector3             upper = lower;
  for (const Vector3 & node : mesh.nodes)
  {
    lower = lower.cwiseMin(volume.continuousIndex(node));
    upper = upper.cwiseMax(volume.continuousIndex(node));
  }
  int begin[3];
  int end[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = volume.size[static_cast<std::size_t>(axis)];
    begin[axis] = static_cast<int>(std::clamp(std::floor(lower[axis]), 0.0, size));
    end[axis] = static_cast<int>(std::clamp(std::ceil(upper[axis]) + 1.0, 0.0, size));
  }
  std::set<double> found;
  for (int k = begin[2]; k < end[2]; ++k)
  {
    for (int j = begin[1]; j < end[1]; ++j)
    {
      for (int i = begin[0]; i < end[0]; ++i)
      {
        found.insert(*volume.at(volume.voxelNumber(i, j, k)));
      }
    }
  }
  const auto isElsewhere = [&found](const LabelEntry & entry) { return found.count(entry.value) == 0; };
  image.labels.erase(std::remove_if(image.labels.begin(), image.labels.end(), isElsewhere), image.labels.end());
}

bool
hasShares(const TransferImage & image)
{
  return image.labels.size() + 2 <= mostShares; // with 0 and the background
}

std::vector<double>
labelsOfPlaces(const TransferImage & image, double background)
{
  std::set<double> labels{ 0.0, background };
  for (const LabelEntry & entry : image.labels)
  {
    labels.insert(entry.value);
  }
  if (labels.size() > mostShares)
  {
    throw UsageError("--labels: " + std::to_string(labels.size()) +
                     " labels around the organ with 0 and the background, at most " + std::to_string(mostShares) +
                     " by cells; take --sampling nodes without --fractions");
  }
  return { labels.begin(), labels.end() };
}

CubeMeans
labelFractions(const HexMesh &             mesh,
               const CubeFunction &        labelAt,
               const std::vector<double> & labels,
               const CubeMeanOptions &     options)
{
  const auto indicators = [&labelAt, &labels](const CubePoint & point, double * values) {
    double label = 0.0;
    labelAt(point, &label);
    std::transform(labels.begin(), labels.end(), values, [label](double other) { return label == other ? 1.0 : 0.0; });
  };
  return cubeMeans(mesh, indicators, static_cast<int>(labels.size()), options);
}

FieldVolume
majority(const FieldVolume & fractions, const std::vector<double> & labels)
{
  FieldVolume result{ fractions, 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    const double * const first = fractions.at(box);
    const auto           largest = std::max_element(first, first + fractions.components) - first;
    result.values.push_back(labels[static_cast<std::size_t>(largest)]);
  }
  return result;
}

FieldVolume
withoutZero(const FieldVolume & fractions)
{
  FieldVolume result{ fractions, fractions.components - 1, {} };
  for (std::size_t box = 0; box < fractions.gridVoxels(); ++box)
  {
    result.values.insert(result.values.end(), fractions.at(box) + 1, fractions.at(box) + fractions.components);
  }
  return result;
}

LabelAmounts
volumesOf(const CubeMeans & fractions, const std::vector<double> & labels)
{
  LabelAmounts volumes;
  for (std::size_t box = 0; box < fractions.volumes.size(); ++box)
  {
    for (std::size_t n = 0; n < labels.size(); ++n)
    {
      volumes[labels[n]] += fractions.volumes[box] * fractions.image.at(box)[n];
    }
  }
  return volumes;
}

LabelAmounts
amountsOf(const std::vector<double> & labels, const std::vector<double> & weights)
{
  LabelAmounts amounts;
  for (std::size_t place = 0; place < labels.size(); ++place)
  {
    if (std::isfinite(labels[place]))
    {
      amounts[labels[place]] += weights[place];
    }
  }
  return amounts;
}

void
reportLabels(const std::vector<LabelEntry> & labels,
             const LabelAmounts &            before,
             const LabelsAfter &             after,
             const TransferLog &             log)
{
  constexpr std::size_t longestName = 40;
  for (const LabelEntry & entry : labels)
  {
    const std::string name = "label " + std::to_string(entry.value) +
                             (entry.name.empty() ? "" : " (" + oneLine(entry.name, longestName) + ")");
    const double volume = amountOf(before, entry.value);
    const double amount = amountOf(after.amounts, entry.value);
    log.say(name + ": " + amountText(volume) + " mm3 in the organ, " + amountText(amount) + ' ' + after.unit);
    if (volume > 0.0 && amount == 0.0)
    {
      log.warn(name + " has " + amountText(volume) + " mm3 in the organ, but is in no " + after.place + "; " +
               after.remedy);
    }
  }
}

} // namespace moserhex::app
