#include "moserhex/LevelSet/SignedDistance.h"

#include "LowerEnvelope.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/** One-dimensional squared distance transform of a line in which voxels of two kinds alternate in runs:
 *
 *   f(q) = min over p of f(p) + (s (q - p))^2
 *
 * over the voxels p of q's own run and the two that bound it, which are of the other kind, so 0 away from it. No voxel
 * beyond these can be nearer. */
void
transformLine(LowerEnvelope & envelope, double * f, const std::uint8_t * kind, int length)
{
  for (int begin = 0, end = 0; begin < length; begin = end)
  {
    for (end = begin + 1; end < length && kind[end] == kind[begin];)
    {
      ++end;
    }
    envelope.clear();
    if (begin > 0)
    {
      envelope.add(begin - 1, 0.0);
    }
    for (int q = begin; q < end; ++q)
    {
      envelope.add(q, f[q]);
    }
    if (end < length)
    {
      envelope.add(end, 0.0);
    }
    envelope.evaluate(begin, end, [f](int q, int, double value) { f[q] = value; });
  }
}

/** Applies the transform to all lines along axis 1 or 2, eight neighbouring lines at a time for the sake of the cache.
 */
void
transformAlong(std::vector<double> & f, const LabelVolume & label, std::size_t axis, unsigned int threads)
{
  constexpr std::size_t batch = 8;
  constexpr std::size_t batchesPerBlock = 16;
  const auto            length = static_cast<std::size_t>(label.size[axis]);
  const double          spacing = label.spacing[static_cast<int>(axis)];
  std::size_t           stride = 1;
  for (std::size_t a = 0; a < axis; ++a)
  {
    stride *= static_cast<std::size_t>(label.size[a]);
  }
  const std::size_t batches = (stride + batch - 1) / batch; // of a slab of lines
  const std::size_t slabs = f.size() / (stride * length);
  parallelForBlocks(slabs * batches, batchesPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    LowerEnvelope             envelope(length, spacing);
    std::vector<double>       lines(batch * length);
    std::vector<std::uint8_t> kinds(batch * length);
    for (std::size_t item = begin; item < end; ++item)
    {
      const std::size_t start = item % batches * batch;
      const std::size_t count = std::min(batch, stride - start);
      const std::size_t first = item / batches * stride * length + start;
      for (std::size_t q = 0; q < length; ++q)
      {
        for (std::size_t line = 0; line < count; ++line)
        {
          const std::size_t voxel = first + q * stride + line;
          lines[line * length + q] = f[voxel];
          kinds[line * length + q] = label.inside[voxel] != 0 ? 1 : 0;
        }
      }
      for (std::size_t line = 0; line < count; ++line)
      {
        transformLine(envelope, lines.data() + line * length, kinds.data() + line * length, static_cast<int>(length));
      }
      for (std::size_t q = 0; q < length; ++q)
      {
        for (std::size_t line = 0; line < count; ++line)
        {
          f[first + q * stride + line] = lines[line * length + q];
        }
      }
    }
  });
}

/** Squared distance along axis 0 to the nearest voxel of the other kind: one scan each way. */
void
startAlongRows(const LabelVolume & label, std::vector<double> & squared, unsigned int threads)
{
  constexpr std::size_t rowsPerBlock = 64;
  const auto            length = static_cast<std::size_t>(label.size[0]);
  const double          spacing = label.spacing[0];
  const auto            sameKind = [&](std::size_t voxel, std::size_t other) {
    return (label.inside[voxel] != 0) == (label.inside[other] != 0);
  };
  const auto scanRow = [&](std::size_t first) {
    double distance = infinity;
    for (std::size_t voxel = first + 1; voxel < first + length; ++voxel)
    {
      distance = (sameKind(voxel, voxel - 1) ? distance : 0.0) + spacing;
      squared[voxel] = distance * distance;
    }
    distance = infinity;
    for (std::size_t voxel = first + length - 1; voxel-- > first;)
    {
      distance = (sameKind(voxel, voxel + 1) ? distance : 0.0) + spacing;
      squared[voxel] = std::min(squared[voxel], distance * distance);
    }
  };
  parallelForBlocks(squared.size() / length, rowsPerBlock, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
    {
      scanRow(row * length);
    }
  });
}

/** Squared distance of every voxel centre to the nearest centre of the other kind. */
std::vector<double>
squaredDistanceToOtherKind(const LabelVolume & label, const std::array<bool, 3> & axes, unsigned int threads)
{
  std::vector<double> squared(label.inside.size(), infinity);
  if (axes[0])
  {
    startAlongRows(label, squared, threads);
  }
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    if (axes[axis])
    {
      transformAlong(squared, label, axis, threads);
    }
  }
  return squared;
}

} // namespace

std::vector<double>
voxelSignedDistance(const LabelVolume & label, const std::array<bool, 3> & axes, unsigned int threads)
{
  requireValid(label, "signed distance");
  double smallestSpacing = infinity;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (axes[axis])
    {
      smallestSpacing = std::min(smallestSpacing, label.spacing[static_cast<int>(axis)]);
    }
  }
  if (smallestSpacing == infinity)
  {
    throw InvalidInput("signed distance: no axis chosen");
  }
  std::vector<double> distance = squaredDistanceToOtherKind(label, axes, threads);
  const double        half = 0.5 * smallestSpacing;
  for (std::size_t voxel = 0; voxel < distance.size(); ++voxel)
  {
    const double toFace = std::sqrt(distance[voxel]) - half;
    distance[voxel] = label.inside[voxel] != 0 ? -toFace : toFace;
  }
  return distance;
}

} // namespace moserhex
