#include "moserhex/LevelSet/LabelConditioning.h"

#include "ShapeInterpolation.h"
#include "TopologyProtection.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/GaussianSmoothing.h"
#include "moserhex/LevelSet/KuhnConnectivity.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr double marginInNodes = 5.0;  ///< at least
constexpr double noteworthyDice = 0.9; ///< of an ordinary label: below it a warning is due
constexpr double marginInSigmas = 3.0;
constexpr double smallestSigmaInNodes = 0.7;
constexpr double largestSigmaOfThinLabels = 0.15; ///< of V^(1/3)
constexpr double repairRadiusInSigmas = 2.5;      ///< a cylinder of 1.25 sigma vanishes
constexpr double repairRadiusInVoxels = 1.5;      ///< at least, of the shortest side
constexpr double sphericalBand = 0.5;             ///< around the zero level, in spacings

void
requireValid(const ConditioningOptions & options)
{
  const auto require = [&](bool good, const std::string & name, double value, const std::string & range) {
    if (!good)
    {
      std::ostringstream message;
      message << options.labelName << ": " << name << " is " << value << ", need " << range;
      throw InvalidInput(message.str());
    }
  };
  require(options.nodesPerSide >= 2, "nodes per side", options.nodesPerSide, ">= 2");
  require(options.spacing >= 0.0 && std::isfinite(options.spacing), "grid spacing [mm]", options.spacing, ">= 0");
  require(options.smoothing >= 0.0 && options.smoothing <= 2.0, "smoothing", options.smoothing, "0 to 2");
  require(options.minimumSigma >= 0.0 && std::isfinite(options.minimumSigma),
          "smallest sigma [mm]",
          options.minimumSigma,
          ">= 0");
  require(options.roundingRadius >= 0.0 && std::isfinite(options.roundingRadius),
          "rounding radius [mm]",
          options.roundingRadius,
          ">= 0");
  require(options.sliceAnisotropy >= 1.0, "slice anisotropy", options.sliceAnisotropy, ">= 1");
  require(options.maximumRepair >= 0.0 && options.maximumRepair <= 1.0,
          "largest repair",
          options.maximumRepair,
          "0 to 1 (of the label's volume)");
  require(options.minimumDice >= 0.0 && options.minimumDice <= 1.0, "minimum Dice", options.minimumDice, "0 to 1");
}

[[noreturn]] void
refuseThin(const std::string & labelName, const std::string & finding, double sigma)
{
  std::ostringstream message;
  message << labelName << ": too thin for a smoothing of sigma " << sigma << " mm (" << finding
          << "); use less smoothing, a finer image, or a larger label";
  throw InvalidInput(ErrorCode::Thin, message.str());
}

/** Area of the faces between inside and outside voxels; the label has an empty margin. */
double
voxelFaceArea(const LabelVolume & padded)
{
  const std::array<std::size_t, 3> strides{ { 1, padded.voxelNumber(0, 1, 0), padded.voxelNumber(0, 0, 1) } };
  double                           area = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::size_t faces = 0;
    for (std::size_t voxel = strides[axis]; voxel < padded.inside.size(); ++voxel)
    {
      faces += padded.inside[voxel] != padded.inside[voxel - strides[axis]] ? 1 : 0;
    }
    area += static_cast<double>(faces) * padded.voxelVolume() / padded.spacing[static_cast<int>(axis)];
  }
  return area;
}

double
sigmaOfSmoothing(const ConditioningOptions & options, const Vector3 & voxel, double volume, double spacing)
{
  const double wanted = std::min(options.smoothing * voxel.maxCoeff(), largestSigmaOfThinLabels * std::cbrt(volume));
  return std::max({ smallestSigmaInNodes * spacing, wanted, options.minimumSigma });
}

double
volumeOf(const LabelVolume & label)
{
  return static_cast<double>(voxelCount(label)) * label.voxelVolume();
}

/** The label has an empty margin. */
double
spacingOfGrid(const LabelVolume & padded, const ConditioningOptions & options)
{
  return options.spacing > 0.0 ? options.spacing
                               : automaticSpacing(volumeOf(padded), voxelFaceArea(padded), options.nodesPerSide);
}

/** Step 1. The label has an empty margin of one voxel, and still has it afterwards. */
void
makeBallInPlace(LabelVolume & padded, const ConditioningOptions & options, ConditioningReport & report)
{
  if (options.topology == TopologyPolicy::Reject)
  {
    report.repair.before = voxelTopology(padded);
    if (!report.repair.before.isBall())
    {
      throw InvalidInput(ErrorCode::Topology, options.labelName + ": " + describe(report.repair.before));
    }
    return;
  }
  TopologyRepairOptions repair;
  repair.maximumChange = options.maximumRepair;
  repair.labelName = options.labelName;
  const double sigma = sigmaOfSmoothing(options, padded.spacing, volumeOf(padded), spacingOfGrid(padded, options));
  repair.radius = std::max(repairRadiusInSigmas * sigma, repairRadiusInVoxels * padded.spacing.minCoeff());
  TopologyRepairResult repaired = repairTopology(padded, repair);
  report.repair = std::move(repaired.report);
  if (!report.repair.changes.empty())
  {
    padded = cropAndPad(repaired.label, { { 1, 1, 1 } });
  }
}

/** Empty voxels on each side that cover the margin of the grid, and two for the splines across slices. */
std::array<int, 3>
voxelsForMargin(const Vector3 & voxel, double margin)
{
  std::array<int, 3> voxels{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    voxels[axis] = static_cast<int>(std::ceil(margin / voxel[static_cast<int>(axis)])) + 2;
  }
  return voxels;
}

void
shift(LevelSet & f, double level)
{
  for (double & value : f.values)
  {
    value -= level;
  }
}

long
surfaceEulerCharacteristic(const LevelSet & f)
{
  std::vector<std::uint8_t> inside(f.values.size());
  std::transform(f.values.begin(), f.values.end(), inside.begin(), [](double value) {
    return static_cast<std::uint8_t>(value < 0.0);
  });
  return 2 * kuhnEulerCharacteristic(f.grid, inside);
}

double
smallestBorderValue(const LevelSet & f)
{
  double smallest = f.values.front();
  for (std::size_t node = 0; node < f.values.size(); ++node)
  {
    if (f.grid.isBorder(node))
    {
      smallest = std::min(smallest, f.values[node]);
    }
  }
  return smallest;
}

/** Dice coefficient of the label's voxels and the voxels whose centre has phi < 0. phi is a distance, so farther away
 * from the surface than the nearest node can be, the sign of that node is enough. */
double
diceWithVoxels(const LabelVolume & label, const LevelSet & phi, unsigned int threads)
{
  constexpr double        farInSpacings = 1.25; // above sqrt(3) / 2
  const CubicInterpolator interpolator(phi);
  const RegularGrid &     grid = phi.grid;
  const auto              nearestNode = [&](double index, std::size_t axis) {
    return static_cast<int>(std::min(std::max(index + 0.5, 0.0), grid.size[axis] - 1.0));
  };
  const double step = label.spacing[0] / grid.spacing; // of the grid index from voxel to voxel of a row
  struct Counts
  {
    std::size_t label{ 0 };
    std::size_t solid{ 0 };
    std::size_t both{ 0 };
  };
  std::vector<Counts> slices(static_cast<std::size_t>(label.size[2]));
  parallelFor(slices.size(), threads, [&](std::size_t slice) {
    const int   k = static_cast<int>(slice);
    std::size_t voxel = label.voxelNumber(0, 0, k);
    Counts &    counts = slices[slice];
    for (int j = 0; j < label.size[1]; ++j)
    {
      const Vector3  row = grid.continuousIndex(label.point(0, j, k));
      const double * nodes = phi.values.data() + grid.nodeNumber(0, nearestNode(row[1], 1), nearestNode(row[2], 2));
      for (int i = 0; i < label.size[0]; ++i, ++voxel)
      {
        const bool   a = label.inside[voxel] != 0;
        const double value = nodes[nearestNode(row[0] + i * step, 0)];
        const bool   b =
          std::abs(value) > farInSpacings * grid.spacing ? value < 0.0 : interpolator.value(label.point(i, j, k)) < 0.0;
        counts.label += a ? 1 : 0;
        counts.solid += b ? 1 : 0;
        counts.both += a && b ? 1 : 0;
      }
    }
  });
  Counts sum;
  for (const Counts & counts : slices)
  {
    sum.label += counts.label;
    sum.solid += counts.solid;
    sum.both += counts.both;
  }
  return 2.0 * static_cast<double>(sum.both) / static_cast<double>(sum.label + sum.solid);
}

/** Opening and closing by a ball: what is narrower than it goes, be it solid or groove. */
void
roundInPlace(LevelSet & f, double radius, const ConditioningOptions & options)
{
  for (const double move : { -radius, 2.0 * radius, -radius })
  {
    try
    {
      f = redistance(f, options.threads);
    }
    catch (const InvalidInput &)
    {
      refuseThin(options.labelName, "narrower than the ball it is rounded with", radius);
    }
    shift(f, move);
  }
}

/** Steps 2 and 3: a smooth function whose zero level encloses V, its topology as it happens to be. */
LevelSet
smoothShape(const LabelVolume &         ball,
            double                      volume,
            double                      spacing,
            const ConditioningOptions & options,
            const ConditioningReport &  report)
{
  const double      reach = marginInSigmas * report.sigma + options.roundingRadius;
  const double      margin = std::max(marginInNodes, std::ceil(reach / spacing)) * spacing;
  const LabelVolume padded = cropAndPad(ball, voxelsForMargin(ball.spacing, margin));
  const RegularGrid grid = detail::gridAround(ball, spacing, margin);
  requireValid(grid, options.labelName);
  LevelSet f = detail::interpolateShape(padded, grid, report.sliceAxis, options.threads);
  if (options.roundingRadius > 0.0)
  {
    roundInPlace(f, options.roundingRadius, options);
  }
  gaussianSmoothInPlace(f, report.sigma / spacing);

  LevelOfVolumeOptions search;
  search.upper = smallestBorderValue(f);
  search.relativeTolerance = 1e-6; // the volume is set exactly at the end
  try
  {
    shift(f, levelOfVolume(f, volume, search));
  }
  catch (const InvalidInput &)
  {
    refuseThin(options.labelName, "no level of the smoothed label encloses its volume", report.sigma);
  }
  return f;
}

/** Step 5: moves the level that encloses V to 0, within the band where all levels are spheres. Returns what remains of
 * the error, relative to V. */
double
moveVolumeToZero(LevelSet & phi, double volume, const std::string & labelName, double sigma)
{
  LevelOfVolumeOptions search;
  search.lower = -0.5 * sphericalBand * phi.grid.spacing;
  search.upper = 0.5 * sphericalBand * phi.grid.spacing;
  try
  {
    const VolumeBelowLevel below(phi);
    const double           level = levelOfVolume(below, volume, search);
    const double           error = below.volume(level) / volume - 1.0;
    shift(phi, level);
    return error;
  }
  catch (const InvalidInput &)
  {
    refuseThin(labelName, "the protected solid cannot hold the label's volume", sigma);
  }
}

} // namespace

double
automaticSpacing(double volume, double faceArea, int nodesPerSide)
{
  const double side = std::cbrt(volume);
  const double halfCell = 0.5 * side / (nodesPerSide - 1);
  return std::min(std::min(halfCell, side / 24.0), std::max(0.5 * volume / faceArea, 0.5 * halfCell));
}

std::vector<std::string>
warningsOf(const ConditioningReport & report)
{
  std::vector<std::string> warnings = describe(report.repair);
  if (report.borders.any())
  {
    warnings.push_back("the label touches the border of the image and was closed off there (" + report.borders.names() +
                       ")");
  }
  if (report.nodesCut + report.nodesFilled > 0)
  {
    std::ostringstream text;
    text << "resampling would have changed the topology; keeping it moved " << 100.0 * report.changedVolumeFraction
         << " % of the volume";
    warnings.push_back(text.str());
  }
  if (report.dice > 0.0 && report.dice < noteworthyDice && report.rounding == 0.0)
  {
    std::ostringstream text;
    text << "thin for its voxels: Dice coefficient of the smoothed solid with the label " << report.dice;
    warnings.push_back(text.str());
  }
  return warnings;
}

ConditioningOptions
simplified(Simplification simplification, const ConditioningReport & first, double volume, int nodesPerSide)
{
  const double        cellEdge = std::cbrt(volume) / (nodesPerSide - 1);
  const bool          isRounder = simplification == Simplification::Rounder;
  ConditioningOptions options;
  options.nodesPerSide = nodesPerSide;
  options.minimumSigma = std::max(1.5 * first.sigma, (isRounder ? 1.0 : 0.65) * cellEdge);
  options.roundingRadius = isRounder ? 2.25 * cellEdge : 0.0;
  return options;
}

bool
isFaithful(Simplification simplification, const ConditioningReport & simpler, const ConditioningReport & first)
{
  constexpr double largestLoss = 0.02;
  constexpr double smallestDiceOfRounder = 0.95;
  return simplification == Simplification::Rounder ? simpler.dice >= smallestDiceOfRounder
                                                   : simpler.dice >= first.dice - largestLoss;
}

std::string
describeSimplification(const ConditioningReport & simpler, const ConditioningReport & usual)
{
  std::ostringstream text;
  text << "smoothed by " << simpler.sigma << " mm instead of " << usual.sigma;
  if (simpler.rounding > 0.0)
  {
    text << " and rounded by " << simpler.rounding << " mm";
  }
  text << ", as details are narrower than cells; Dice coefficient with the label " << simpler.dice << " instead of "
       << usual.dice;
  return text.str();
}

ConditionedSolid
conditionLabel(const LabelVolume & label, const ConditioningOptions & options, const ProgressCallback & progress)
{
  const Stopwatch stopwatch;
  requireValid(options);
  requireValid(label, options.labelName);
  ConditionedSolid     solid;
  ConditioningReport & report = solid.report;

  report.borders = imageBordersTouched(label);
  solid.label = cropAndPad(label, { { 1, 1, 1 } });
  makeBallInPlace(solid.label, options, report);
  const LabelVolume & ball = solid.label;
  solid.labelVolume = volumeOf(ball);
  reportProgress(progress, 0.1);

  const double spacing = spacingOfGrid(ball, options);
  report.sliceAxis = detail::findSliceAxis(ball.spacing, options.sliceAnisotropy);
  report.sigma = sigmaOfSmoothing(options, ball.spacing, solid.labelVolume, spacing);
  report.rounding = options.roundingRadius;
  LevelSet f = smoothShape(ball, solid.labelVolume, spacing, options, report);
  reportProgress(progress, 0.4);

  report.eulerBefore = surfaceEulerCharacteristic(f);
  const detail::ProtectionResult protection = detail::makeBallInPlace(f);
  report.nodesCut = protection.cut;
  report.nodesFilled = protection.filled;
  report.changedVolumeFraction =
    static_cast<double>(protection.cut + protection.filled) * f.grid.cellVolume() / solid.labelVolume;
  reportProgress(progress, 0.6);

  LevelSet phi = redistance(f, options.threads);
  detail::makeLevelsSphericalInPlace(phi, sphericalBand * spacing);
  reportProgress(progress, 0.8);

  report.volumeError = moveVolumeToZero(phi, solid.labelVolume, options.labelName, report.sigma);
  report.dice = diceWithVoxels(ball, phi, options.threads);
  if (report.dice < options.minimumDice)
  {
    refuseThin(options.labelName,
               "Dice coefficient with its voxels " + std::to_string(report.dice) + ", need " +
                 std::to_string(options.minimumDice),
               report.sigma);
  }
  solid.levelSet = std::move(phi);
  report.seconds = stopwatch.seconds();
  reportProgress(progress, 1.0);
  return solid;
}

} // namespace moserhex
