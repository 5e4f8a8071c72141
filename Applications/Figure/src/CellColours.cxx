#include "CellColours.h"

#include "ArrayValues.h"
#include "CommandErrors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/LabelImageReader.h"
#include "moserhex/Quality/CellLabels.h"
#include "moserhex/Quality/HexQuality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace moserhex::app
{
namespace
{

/** Half of the volume's range at least: rounding errors of an exact mesh must not fill the scale [1]. */
constexpr double smallestVolumeRange = 0.1;
constexpr double largestVolumeRange = 1.0; ///< likewise at most: no volume is below 0 [1]

/** Numbers that differ by less than this part of them are the same but for rounding. */
constexpr double roundingOfEqualNumbers = 1e-9;
constexpr double roundingOfZero = 1e-12; ///< likewise those that differ by less than this

constexpr std::size_t longestTitle = 80;

std::vector<double>
ofEveryCell(const DrawnMesh & mesh, double HexCellQuality::*member)
{
  std::vector<double> values;
  for (std::size_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
  {
    values.push_back(hexCellQuality(cellCorners(mesh.cells, cell)).*member);
  }
  return values;
}

std::vector<double>
volumeRatios(const DrawnMesh & mesh)
{
  std::vector<double> volumes = cellVolumes(mesh.cells);
  const double        mean = std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(volumes.size());
  if (!(mean > 0.0))
  {
    throw InvalidInput("the mean volume of the cells is not positive, so there is no ratio to it");
  }
  for (double & volume : volumes)
  {
    volume /= mean;
  }
  return volumes;
}

double
largestOf(const std::vector<double> & values)
{
  return *std::max_element(values.begin(), values.end());
}

/** Numbers of shells from the middle outwards: yellow to blue. */
std::vector<ColourClass>
shellClasses(const HexMesh & lattice, const std::vector<double> & shells)
{
  std::vector<ColourClass> classes;
  const int                inLattice = lattice.nodesPerSide / 2;
  const int                all = static_cast<int>(largestOf(shells));
  for (int shell = 1; shell <= all; ++shell)
  {
    const double position = all > 1 ? 1.0 - static_cast<double>(shell - 1) / (all - 1) : 1.0;
    const bool   isPadding = shell > inLattice;
    classes.push_back({ shell,
                        isPadding ? "padding " + std::to_string(shell - inLattice) : std::to_string(shell),
                        sequentialScale().at(0.3 + 0.7 * position) });
  }
  return classes;
}

CellColours
byShell(const DrawnMesh & mesh)
{
  const HexMesh &        lattice = requireLatticeFor(mesh, "colours by shell");
  const std::vector<int> shells = shellOfCells(lattice);
  CellColours            colours;
  colours.title = "shell";
  colours.values.assign(shells.begin(), shells.end());
  colours.classes = shellClasses(lattice, colours.values);
  return colours;
}

CellColours
byLabel(const DrawnMesh & mesh, const FigureOptions & options)
{
  if (options.labelImage.empty())
  {
    throw UsageError("--colour label needs --label-image IMAGE: which labelmap?");
  }
  const HexMesh &                 lattice = requireLatticeFor(mesh, "colours by label");
  const LabelImage                image = readLabelImage(options.labelImage, { {}, {}, options.sandbox });
  const std::vector<std::int32_t> labels = labelsOfCells(lattice, labelValuesOf(*image.image), options.threads);
  CellColours                     colours;
  colours.title = "label";
  colours.values.assign(labels.begin(), labels.end());
  const auto nameOfLabel = [&image](std::int32_t label) {
    for (const LabelEntry & entry : image.labels)
    {
      if (entry.value == label && !entry.name.empty())
      {
        return std::to_string(label) + " " + oneLine(entry.name, 20);
      }
    }
    return label == 0 ? std::string("none") : std::to_string(label);
  };
  for (const std::int32_t label : std::set<std::int32_t>(labels.begin(), labels.end()))
  {
    const Colour grey{ 0.85, 0.85, 0.85, 1.0 };
    colours.classes.push_back({ static_cast<int>(label),
                                nameOfLabel(label),
                                label == 0 ? grey : categoryColour(static_cast<std::size_t>(label - 1)) });
  }
  return colours;
}

CellColours
byArray(const DrawnMesh & mesh, const std::string & name)
{
  CellColours colours;
  colours.title = oneLine(name, longestTitle);
  colours.values = valuesOfArray(mesh, name);
  colours.low = std::numeric_limits<double>::max();
  colours.high = std::numeric_limits<double>::lowest();
  for (const double value : colours.values)
  {
    if (std::isfinite(value))
    {
      colours.low = std::min(colours.low, value);
      colours.high = std::max(colours.high, value);
    }
  }
  const double size = std::max(std::abs(colours.low), std::abs(colours.high));
  if (colours.high - colours.low <= std::max(roundingOfEqualNumbers * size, roundingOfZero))
  {
    const double room = size > roundingOfZero ? 0.05 * size : 1.0;
    colours.low -= room;
    colours.high += room;
  }
  else if (colours.low < 0.0 && colours.high > 0.0)
  {
    colours.low = -size;
    colours.high = size;
  }
  return colours;
}

CellColours
byQuality(const DrawnMesh & mesh, const std::string & name)
{
  CellColours colours;
  if (name == "volume")
  {
    colours.title = "volume / mean";
    colours.values = volumeRatios(mesh);
    double half = smallestVolumeRange;
    for (const double ratio : colours.values)
    {
      half = std::max(half, std::abs(ratio - 1.0));
    }
    half = std::min(half, largestVolumeRange); // the legend marks values beyond it
    colours.scale = divergingScale();
    colours.low = 1.0 - half;
    colours.high = 1.0 + half;
  }
  else if (name == "aspect")
  {
    colours.title = "aspect ratio";
    colours.values = ofEveryCell(mesh, &HexCellQuality::aspectRatio);
    colours.low = 1.0;
    colours.high = std::max(largestOf(colours.values), 1.1);
  }
  else if (name == "taper")
  {
    colours.title = "taper";
    colours.values = ofEveryCell(mesh, &HexCellQuality::taper);
    colours.high = std::max(largestOf(colours.values), 0.1);
  }
  else
  {
    colours.title = "scaled Jacobian";
    colours.values = ofEveryCell(mesh, &HexCellQuality::scaledJacobian);
    colours.low = std::min(*std::min_element(colours.values.begin(), colours.values.end()), 0.0);
  }
  return colours;
}

} // namespace

const HexMesh &
requireLatticeFor(const DrawnMesh & mesh, const std::string & what)
{
  if (!mesh.lattice)
  {
    throw BadInput(ErrorCode::NotHexahedra,
                   mesh.fileName,
                   "not a lattice, which " + what + " need",
                   "give a mesh of moserhex, or choose another picture");
  }
  return *mesh.lattice;
}

Colour
CellColours::of(std::size_t cell) const
{
  if (!hasNumber(cell))
  {
    return noNumberColour;
  }
  const double value = values[cell];
  for (const ColourClass & one : classes)
  {
    if (one.value == static_cast<int>(value))
    {
      return one.colour;
    }
  }
  return scale.at((value - low) / (high - low));
}

bool
CellColours::hasNumber(std::size_t cell) const
{
  return std::isfinite(values[cell]);
}

CellColours
colourCells(const DrawnMesh & mesh, const FigureOptions & options)
{
  const bool byClass = options.colour == "shell" || options.colour == "label";
  if (byClass && !options.range.empty())
  {
    throw UsageError("--range is for numbers along a scale; --colour " + options.colour + " has a colour for each");
  }
  if (options.colour != "label" && !options.labelImage.empty())
  {
    throw UsageError("--label-image is for --colour label");
  }
  if (!options.range.empty() && (options.range.size() != 2 || !(options.range[0] < options.range[1])))
  {
    throw UsageError("--range needs two numbers, the lower one first");
  }
  CellColours colours = options.colour == "shell"        ? byShell(mesh)
                        : options.colour == "label"      ? byLabel(mesh, options)
                        : isFigureColour(options.colour) ? byQuality(mesh, options.colour)
                                                         : byArray(mesh, options.colour);
  if (!options.range.empty())
  {
    colours.low = options.range[0];
    colours.high = options.range[1];
  }
  if (colours.classes.empty() && colours.low == -colours.high)
  {
    colours.scale = divergingScale(); // its middle is 0: what is above and what is below are told apart
  }
  return colours;
}

} // namespace moserhex::app
