#pragma once

#include "ImageDescription.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace moserhex
{

/** How values become labels. */
struct LabelRules
{
  std::optional<double>     threshold; ///< values at or above it are label 1, all others and NaN 0
  int                       layer{ 0 };
  std::optional<LabelValue> only; ///< other labels of the layer become 0
  bool                      allowEmpty{ false };
  std::string               remedyForFractions{ LabelReadOptions().remedyForFractions };
};

/** The labels of an image in as few bytes as hold them. */
struct LabelVoxels
{
  using Counts = std::map<LabelValue, std::size_t>;

  std::string         bytes;
  std::uint8_t        width{ 1 }; ///< bytes of a label, which is unsigned
  std::vector<Counts> counts;     ///< of each layer, before `only`; 0 included
};

constexpr std::size_t mostLabels = 4096;

/** Refusals and warnings about values. */
[[noreturn]] void
throwNoLabel(const ImageDescription & image, std::size_t voxel, double value, const LabelRules & rules);
[[noreturn]] void
throwTooManyLabels(const ImageDescription & image);
void
warnOfRounding(ImageDescription & image, std::size_t rounded);
void
warnOfNaN(ImageDescription & image, std::size_t notNumbers);

/** The labels to report of those counted in the rules' layer, named by their segments.
 * \throws BadInput (EmptyLabel)  none, and the rules do not allow that; else that is a warning of the image */
[[nodiscard]] std::vector<LabelEntry>
labelEntries(ImageDescription &                image,
             const LabelVoxels::Counts &       counts,
             const LabelRules &                rules,
             const std::vector<SegmentEntry> & segments);

/** Turns values into labels, see readLabelImage. */
template <typename TVoxel>
class LabelMaker
{
public:
  explicit LabelMaker(const std::optional<double> & threshold) : m_Threshold(threshold)
  {}

  /** The label of a value; -1 when it is none. */
  [[nodiscard]] LabelValue
  operator()(TVoxel value) const
  {
    if (m_Threshold)
    {
      return static_cast<double>(value) >= *m_Threshold ? 1 : 0; // NaN is not
    }
    if constexpr (std::is_floating_point_v<TVoxel>)
    {
      constexpr double noise = 1e-4;
      // Beyond it neighbouring whole numbers are the same float.
      constexpr double largest = sizeof(TVoxel) == 4 ? 16777216.0 : std::numeric_limits<LabelValue>::max();
      const double     real = static_cast<double>(value);
      const double     whole = std::round(real);
      return whole >= 0.0 && whole <= largest && std::abs(real - whole) <= noise ? static_cast<LabelValue>(whole) : -1;
    }
    else if constexpr (std::is_signed_v<TVoxel>)
    {
      return value >= 0 && static_cast<std::int64_t>(value) <= std::numeric_limits<LabelValue>::max()
               ? static_cast<LabelValue>(value)
               : -1;
    }
    else
    {
      return static_cast<std::uint64_t>(value) <= static_cast<std::uint64_t>(std::numeric_limits<LabelValue>::max())
               ? static_cast<LabelValue>(value)
               : -1;
    }
  }

private:
  std::optional<double> m_Threshold;
};

/** Counts the labels of every layer. \throws BadInput (Labels)  a value that is no label, or more than 4096 labels */
template <typename TVoxel>
std::vector<LabelVoxels::Counts>
countLabels(ImageDescription & image, const std::vector<TVoxel> & values, const LabelRules & rules)
{
  const LabelMaker<TVoxel>         labelOf(rules.threshold);
  const auto                       layers = static_cast<std::size_t>(image.layers);
  std::vector<LabelVoxels::Counts> counts(layers);
  std::size_t                      rounded = 0;
  std::size_t                      notNumbers = 0;
  for (std::size_t layer = 0; layer < layers; ++layer)
  {
    for (std::size_t n = layer; n < values.size();)
    {
      const std::size_t begin = n;
      const TVoxel      value = values[n];
      while (n < values.size() && values[n] == value)
      {
        n += layers;
      }
      n = std::max(n, begin + layers); // NaN equals nothing
      const LabelValue label = labelOf(value);
      if (label < 0)
      {
        throwNoLabel(image, begin / layers, static_cast<double>(value), rules);
      }
      const std::size_t run = (n - begin) / layers;
      counts[layer][label] += run;
      if (counts[layer].size() > mostLabels)
      {
        throwTooManyLabels(image);
      }
      if constexpr (std::is_floating_point_v<TVoxel>)
      {
        notNumbers += std::isnan(value) ? run : 0;
        rounded += !rules.threshold && value != std::round(value) ? run : 0;
      }
    }
  }
  warnOfRounding(image, rounded);
  warnOfNaN(image, notNumbers);
  return counts;
}

/** The labels of one layer, TLabel the type to keep them in. */
template <typename TLabel, typename TVoxel>
void
appendLabels(const ImageDescription &    image,
             const std::vector<TVoxel> & values,
             const LabelRules &          rules,
             std::string &               bytes)
{
  const LabelMaker<TVoxel> labelOf(rules.threshold);
  const auto               layers = static_cast<std::size_t>(image.layers);
  constexpr std::size_t    margin = 1 << 16; // for what is put behind them
  bytes.reserve(values.size() / layers * sizeof(TLabel) + margin);
  bytes.resize(values.size() / layers * sizeof(TLabel));
  char * next = bytes.data();
  for (std::size_t n = static_cast<std::size_t>(rules.layer); n < values.size(); n += layers)
  {
    LabelValue label = labelOf(values[n]);
    label = rules.only && label != *rules.only ? 0 : label;
    const auto narrow = static_cast<TLabel>(label);
    next = std::copy_n(reinterpret_cast<const char *>(&narrow), sizeof narrow, next);
  }
}

/** Labels from the voxels of a file. \throws BadInput (Labels)  see countLabels */
template <typename TVoxel>
LabelVoxels
labelsFrom(ImageDescription & image, const std::vector<TVoxel> & values, const LabelRules & rules)
{
  LabelVoxels labels;
  labels.counts = countLabels(image, values, rules);
  const LabelValue largest = labels.counts[static_cast<std::size_t>(rules.layer)].rbegin()->first;
  if (largest <= std::numeric_limits<std::uint8_t>::max())
  {
    labels.width = 1;
    appendLabels<std::uint8_t>(image, values, rules, labels.bytes);
  }
  else if (largest <= std::numeric_limits<std::uint16_t>::max())
  {
    labels.width = 2;
    appendLabels<std::uint16_t>(image, values, rules, labels.bytes);
  }
  else
  {
    labels.width = 4;
    appendLabels<std::uint32_t>(image, values, rules, labels.bytes);
  }
  return labels;
}

} // namespace moserhex
