#include "moserhex/LevelSet/LabelDensity.h"

#include "DensityText.h"
#include "NearestVoxel.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

constexpr int    mostPartsOfAVoxel = 4;    ///< along an axis
constexpr double coverageTolerance = 0.05; ///< by which the image may be short, in density voxels: headers are rounded
constexpr double smallestPartOfMean = 1e-300; ///< what smoothing by the spline keeps positive

using Index = std::array<int, 3>;

/** Side i of the matrix: the half widths, in voxels of `density`, of one voxel of the label. */
Matrix3
labelAxesInVoxels(const VoxelGrid & label, const VoxelGrid & density)
{
  return (density.spacing.cwiseInverse().asDiagonal() * density.direction.transpose() * label.direction *
          label.spacing.asDiagonal())
    .cwiseAbs();
}

/** The Gauss points of one voxel of the label, relative to its centre [mm]. All have the same weight. */
std::vector<Vector3>
samplesOfAVoxel(const VoxelGrid & label, const VoxelGrid & density)
{
  const Matrix3                      axes = labelAxesInVoxels(label, density);
  std::array<std::vector<double>, 3> fractions; // along each axis, of the voxel's side, from its centre
  for (int axis = 0; axis < 3; ++axis)
  {
    const double widest = axes.col(axis).maxCoeff();
    const int    parts =
      widest > mostPartsOfAVoxel ? mostPartsOfAVoxel : std::max(1, static_cast<int>(std::ceil(widest - 1e-6)));
    constexpr double      gauss = 0.28867513459481288225; // 1 / sqrt(12)
    std::vector<double> & along = fractions[static_cast<std::size_t>(axis)];
    for (int part = 0; part < parts; ++part)
    {
      along.push_back((part + 0.5 - gauss) / parts - 0.5);
      along.push_back((part + 0.5 + gauss) / parts - 0.5);
    }
  }
  std::vector<Vector3> samples;
  for (const double c : fractions[2])
  {
    for (const double b : fractions[1])
    {
      for (const double a : fractions[0])
      {
        samples.emplace_back(label.direction * label.spacing.cwiseProduct(Vector3(a, b, c)));
      }
    }
  }
  return samples;
}

/** Calls body(centre) for every inside voxel of slice k, in the order of the voxel numbers. */
template <typename TBody>
void
forEachInside(const LabelVolume & label, int k, TBody body)
{
  for (int j = 0; j < label.size[1]; ++j)
  {
    const std::uint8_t * inside = label.inside.data() + label.voxelNumber(0, j, k);
    for (int i = 0; i < label.size[0]; ++i)
    {
      if (inside[i] != 0)
      {
        body(label.point(i, j, k));
      }
    }
  }
}

/** "Left" for a direction that points mostly there. */
std::string
patientSide(const Vector3 & direction)
{
  constexpr const char * sides[3][2] = { { "Right", "Left" }, { "Anterior", "Posterior" }, { "Inferior", "Superior" } };
  Eigen::Index           axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return sides[axis][direction[axis] > 0.0 ? 1 : 0];
}

/** Continuous indices of the box of the image's axes that holds all voxels of the label. */
struct IndexBox
{
  Vector3 lower;
  Vector3 upper;
};

IndexBox
boxOfLabel(const LabelVolume & label, const VoxelGrid & image)
{
  IndexBox box{ Vector3::Constant(HUGE_VAL), Vector3::Constant(-HUGE_VAL) };
  for (int k = 0; k < label.size[2]; ++k)
  {
    forEachInside(label, k, [&](const Vector3 & centre) {
      const Vector3 index = image.continuousIndex(centre);
      box.lower = box.lower.cwiseMin(index);
      box.upper = box.upper.cwiseMax(index);
    });
  }
  const Vector3 halfVoxel = 0.5 * labelAxesInVoxels(label, image).rowwise().sum();
  return { box.lower - halfVoxel, box.upper + halfVoxel };
}

void
requireCovered(const IndexBox & box, const VoxelGrid & image)
{
  double      worst = coverageTolerance;
  std::string side;
  double      missing = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double  size = image.size[static_cast<std::size_t>(axis)];
    const Vector3 outwards = image.direction.col(axis);
    const double  shortBelow = -0.5 - box.lower[axis];
    const double  shortAbove = box.upper[axis] - (size - 0.5);
    for (const bool above : { false, true })
    {
      const double shortBy = above ? shortAbove : shortBelow;
      if (shortBy > worst)
      {
        worst = shortBy;
        missing = shortBy * image.spacing[axis];
        side = patientSide(above ? outwards : Vector3(-outwards)) + " side (" + (above ? "end" : "start") +
               " of image axis " + std::to_string(axis + 1) + ")";
      }
    }
  }
  if (!side.empty())
  {
    throw InvalidInput(ErrorCode::Density,
                       "density image: does not cover the label, " + describeNumber(missing) +
                         " mm are missing on its " + side);
  }
}

/** A part of an image: `first` is the image's index of the part's voxel (0,0,0). */
struct ImagePart
{
  ScalarVolume volume;
  Index        first{ { 0, 0, 0 } };
};

/** The voxels that the label's box touches and, as the mesh's surface is not the voxels', some more. */
ImagePart
partAround(const ScalarVolume & image, const IndexBox & box, const LabelVolume & label)
{
  const Vector3 margin = labelAxesInVoxels(label, image).rowwise().sum() + Vector3::Constant(3.0);
  ImagePart     part;
  part.volume.spacing = image.spacing;
  part.volume.direction = image.direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto   a = static_cast<std::size_t>(axis);
    const double last = image.size[a] - 1.0;
    part.first[a] = static_cast<int>(std::min(std::max(std::floor(box.lower[axis] - margin[axis]), 0.0), last));
    part.volume.size[a] =
      static_cast<int>(std::min(std::max(std::ceil(box.upper[axis] + margin[axis]), 0.0), last)) - part.first[a] + 1;
  }
  part.volume.origin = image.point(part.first[0], part.first[1], part.first[2]);
  part.volume.values.reserve(part.volume.gridVoxels());
  for (int k = 0; k < part.volume.size[2]; ++k)
  {
    for (int j = 0; j < part.volume.size[1]; ++j)
    {
      const auto row = image.values.begin() + static_cast<std::ptrdiff_t>(
                                                image.voxelNumber(part.first[0], part.first[1] + j, part.first[2] + k));
      part.volume.values.insert(part.volume.values.end(), row, row + part.volume.size[0]);
    }
  }
  return part;
}

/** The voxel of the grid that holds a continuous index, moved into the grid. */
std::size_t
nearestVoxel(const VoxelGrid & grid, const Vector3 & index)
{
  Index nearest;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double rounded = std::floor(index[static_cast<int>(axis)] + 0.5);
    nearest[axis] = static_cast<int>(std::min(std::max(rounded, 0.0), grid.size[axis] - 1.0));
  }
  return grid.voxelNumber(nearest[0], nearest[1], nearest[2]);
}

bool
holds(const LabelVolume & label, const Vector3 & point)
{
  const Vector3 index = label.continuousIndex(point);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(index[axis] >= -0.5 && index[axis] < label.size[static_cast<std::size_t>(axis)] - 0.5))
    {
      return false;
    }
  }
  return label.inside[nearestVoxel(label, index)] != 0;
}

/** 1 for the voxels of the grid that overlap the label (step 3). */
std::vector<std::uint8_t>
overlappingVoxels(const LabelVolume & label, const VoxelGrid & grid)
{
  std::vector<std::uint8_t>  overlaps(grid.gridVoxels(), 0);
  const std::vector<Vector3> samples = samplesOfAVoxel(label, grid);
  for (int k = 0; k < label.size[2]; ++k)
  {
    forEachInside(label, k, [&](const Vector3 & centre) {
      for (const Vector3 & sample : samples)
      {
        overlaps[nearestVoxel(grid, grid.continuousIndex(centre + sample))] = 1;
      }
    });
  }
  std::size_t voxel = 0;
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (int i = 0; i < grid.size[0]; ++i, ++voxel)
      {
        if (overlaps[voxel] == 0 && holds(label, grid.point(i, j, k)))
        {
          overlaps[voxel] = 1;
        }
      }
    }
  }
  return overlaps;
}

Index
indexOf(const VoxelGrid & grid, std::size_t voxel)
{
  const auto nx = static_cast<std::size_t>(grid.size[0]);
  const auto ny = static_cast<std::size_t>(grid.size[1]);
  return { { static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny), static_cast<int>(voxel / (nx * ny)) } };
}

/** describeVoxel of the image for a voxel of a part of it. */
std::string
describeInImage(const ScalarVolume & image, const ImagePart & part, std::size_t voxel)
{
  const Index       at = indexOf(part.volume, voxel);
  const std::size_t inImage = image.voxelNumber(at[0] + part.first[0], at[1] + part.first[1], at[2] + part.first[2]);
  return describeVoxel(image, inImage, image.values[inImage]);
}

void
requirePositive(const ScalarVolume & image, const ImagePart & part, const std::vector<std::uint8_t> & overlaps)
{
  for (std::size_t voxel = 0; voxel < overlaps.size(); ++voxel)
  {
    if (overlaps[voxel] != 0 && !isDensity(part.volume.values[voxel]))
    {
      throw InvalidInput(ErrorCode::Density,
                         "density image: " + describeInImage(image, part, voxel) +
                           " in the label, need positive and finite");
    }
  }
}

/** Step 4. */
void
continueOutwardsInPlace(ScalarVolume & image, const std::vector<std::uint8_t> & overlaps, unsigned int threads)
{
  const std::vector<std::size_t> nearest = nearestMarkedVoxel(image, overlaps, threads);
  const std::vector<double>      values = image.values;
  for (std::size_t voxel = 0; voxel < nearest.size(); ++voxel)
  {
    image.values[voxel] = values[nearest[voxel]];
  }
}

} // namespace

double
meanDensity(const LabelVolume & label, const Density & density, const VoxelGrid & densityGrid, unsigned int threads)
{
  requireValid(label, "mean density");
  requireValid(densityGrid, "density image");
  const std::vector<Vector3> samples = samplesOfAVoxel(label, densityGrid);
  std::vector<double>        sliceSums(static_cast<std::size_t>(label.size[2]), 0.0);
  parallelFor(sliceSums.size(), threads, [&](std::size_t k) {
    double sum = 0.0;
    forEachInside(label, static_cast<int>(k), [&](const Vector3 & centre) {
      for (const Vector3 & sample : samples)
      {
        sum += density.value(centre + sample);
      }
    });
    sliceSums[k] = sum;
  });
  double sum = 0.0;
  for (const double slice : sliceSums)
  {
    sum += slice;
  }
  return sum / (static_cast<double>(samples.size()) * static_cast<double>(voxelCount(label)));
}

LabelDensity
densityOnLabel(const ScalarVolume & image, const LabelVolume & label, unsigned int threads)
{
  requireValid(image, "density image");
  LabelVolume solid = cropAndPad(label, { { 0, 0, 0 } });
  keepLargestComponentInPlace(solid);
  fillCavitiesInPlace(solid);

  const IndexBox box = boxOfLabel(solid, image);
  requireCovered(box, image);
  ImagePart                       part = partAround(image, box, solid);
  const std::vector<std::uint8_t> overlaps = overlappingVoxels(solid, part.volume);
  requirePositive(image, part, overlaps);
  continueOutwardsInPlace(part.volume, overlaps, threads);

  const double mean = meanDensity(solid, DensityImage(part.volume), part.volume, threads);
  if (!isDensity(mean) || !isDensity(1.0 / mean))
  {
    throw InvalidInput(ErrorCode::Density,
                       "density image: its mean over the label is " + describeNumber(mean) +
                         ", too small or too large to divide by");
  }
  double smallest = HUGE_VAL;
  double largest = 0.0;
  for (std::size_t voxel = 0; voxel < overlaps.size(); ++voxel)
  {
    part.volume.values[voxel] /= mean;
    if (overlaps[voxel] != 0)
    {
      if (part.volume.values[voxel] < smallestPartOfMean)
      {
        throw InvalidInput(ErrorCode::Density,
                           "density image: " + describeInImage(image, part, voxel) +
                             ", too little beside its mean over the label, " + describeNumber(mean));
      }
      smallest = std::min(smallest, part.volume.values[voxel]);
      largest = std::max(largest, part.volume.values[voxel]);
    }
  }
  const double volume = static_cast<double>(voxelCount(solid)) * solid.voxelVolume();
  return { DensityImage(part.volume), mean, mean * volume, smallest, largest };
}

} // namespace moserhex
