#include "CellField.h"

#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>

namespace moserhex::app
{
namespace
{

/** Numbers that differ by less than this part of them are the same but for rounding. */
constexpr double sameBut = 1e-9;

constexpr double none = 1e-300; ///< what is not larger is 0

std::vector<CellField>
emptyQualityFields()
{
  return {
    { "volume-ratio",
      "Volume ratio",
      "Volume of the cell over the mean volume. 1 everywhere is what an exact mesh promises (with a density the masses "
      "are equal, and this need not be 1).",
      {},
      {},
      { 0.5, 1.5 } },
    { "scaled-jacobian",
      "Scaled Jacobian",
      "How close the cell's corners are to right angles: 1 is a box, 0 is flat, below 0 the cell is turned inside out. "
      "Cells along the cube's twelve edges lie on the smooth surface of the organ and stay low; padding lifts them.",
      {},
      CellField::Range{ 0.5, 1.0 },
      { 0.0, 1.0 } },
    { "aspect-ratio",
      "Aspect ratio",
      "The longest of the cell's three mean extents over the shortest: 1 is as long as it is wide.",
      {},
      CellField::Range{ 1.0, 4.0 },
      { 1.0, 5.0 } },
    { "taper",
      "Taper",
      "How much opposite sides of the cell differ in length: 0 is a parallelepiped.",
      {},
      CellField::Range{ 0.0, 0.4 },
      { 0.0, 1.0 } },
  };
}

std::vector<double>
asNumbers(const std::vector<int> & values)
{
  return { values.begin(), values.end() };
}

} // namespace

std::vector<CellField>
cellFieldsOf(const HexMesh & mesh, const std::vector<std::int32_t> & labels)
{
  std::vector<CellField> fields = emptyQualityFields();
  double                 volume = 0.0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    const HexCellQuality quality = hexCellQuality(cellCorners(mesh, cell));
    volume += quality.volume;
    fields[0].values.push_back(quality.volume);
    fields[1].values.push_back(quality.scaledJacobian);
    fields[2].values.push_back(quality.aspectRatio);
    fields[3].values.push_back(quality.taper);
  }
  for (double & value : fields[0].values)
  {
    value *= static_cast<double>(mesh.cellCount()) / volume;
  }
  const std::vector<int> shells = shellOfCells(mesh);
  const double           outermost = *std::max_element(shells.begin(), shells.end());
  fields.push_back({ "shell",
                     "Shell",
                     "1 in the middle, outwards; numbers above the lattice's shells are padding.",
                     asNumbers(shells),
                     {},
                     { 1.0, outermost },
                     true });
  if (!labels.empty())
  {
    const auto [least, most] = std::minmax_element(labels.begin(), labels.end());
    fields.push_back({ "label",
                       "Label",
                       "The label that most of the cell lies in.",
                       asNumbers({ labels.begin(), labels.end() }),
                       {},
                       { static_cast<double>(*least), static_cast<double>(*most) },
                       true });
  }
  return fields;
}

CellField::Range
rangeOf(const CellField & field)
{
  CellField::Range range = field.shown;
  for (const double value : field.values)
  {
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low <= std::max(sameBut * size, none))
  {
    range = size > none ? CellField::Range{ range.low - 0.05 * size, range.high + 0.05 * size }
                        : CellField::Range{ 0.0, 1.0 };
  }
  return range;
}

double
acceptablePart(const CellField & field)
{
  if (!field.acceptable || field.values.empty())
  {
    return 1.0;
  }
  const auto count = std::count_if(field.values.begin(), field.values.end(), [&field](double value) {
    return value >= field.acceptable->low && value <= field.acceptable->high;
  });
  return static_cast<double>(count) / static_cast<double>(field.values.size());
}

} // namespace moserhex::app
