#include "moserhex/LevelSet/SignedDistance.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/** One-dimensional squared distance transform: f(q) = min over p of f(p) + (s (q - p))^2, in place. */
class LowerEnvelope
{
public:
  explicit LowerEnvelope(int length)
    : m_Parabola(static_cast<std::size_t>(length))
    , m_From(static_cast<std::size_t>(length))
    , m_Value(static_cast<std::size_t>(length))
  {}

  void
  apply(double * f, double spacing)
  {
    const int    length = static_cast<int>(m_Parabola.size());
    const double s2 = spacing * spacing;
    int          last = -1; // the envelope's last parabola
    for (int q = 0; q < length; ++q)
    {
      if (f[q] == infinity)
      {
        continue;
      }
      double from = -infinity; // the new parabola is the lowest from here on
      for (; last >= 0; --last)
      {
        const int    p = m_Parabola[static_cast<std::size_t>(last)];
        const double value = m_Value[static_cast<std::size_t>(last)];
        from = 0.5 * (p + q) + (f[q] - value) / (2.0 * s2 * (q - p));
        if (from > m_From[static_cast<std::size_t>(last)])
        {
          break;
        }
      }
      ++last;
      m_Parabola[static_cast<std::size_t>(last)] = q;
      m_Value[static_cast<std::size_t>(last)] = f[q];
      m_From[static_cast<std::size_t>(last)] = last == 0 ? -infinity : from;
    }
    if (last < 0)
    {
      return;
    }
    int current = 0;
    for (int q = 0; q < length; ++q)
    {
      while (current < last && m_From[static_cast<std::size_t>(current) + 1] < q)
      {
        ++current;
      }
      const double distance = spacing * (q - m_Parabola[static_cast<std::size_t>(current)]);
      f[q] = distance * distance + m_Value[static_cast<std::size_t>(current)];
    }
  }

private:
  std::vector<int>    m_Parabola; ///< its apex
  std::vector<double> m_From;     ///< where it becomes the lowest
  std::vector<double> m_Value;    ///< at its apex
};

/** Applies the transform to all lines along axis 1 or 2, eight neighbouring lines at a time for the sake of the cache.
 */
void
transformAlong(std::vector<double> & f, const std::array<int, 3> & size, std::size_t axis, double spacing)
{
  constexpr std::size_t batch = 8;
  const auto            length = static_cast<std::size_t>(size[axis]);
  std::size_t           stride = 1;
  for (std::size_t a = 0; a < axis; ++a)
  {
    stride *= static_cast<std::size_t>(size[a]);
  }
  LowerEnvelope       envelope(size[axis]);
  std::vector<double> lines(batch * length);
  for (std::size_t block = 0; block < f.size(); block += stride * length)
  {
    for (std::size_t start = 0; start < stride; start += batch)
    {
      const std::size_t count = std::min(batch, stride - start);
      double *          first = f.data() + block + start;
      for (std::size_t q = 0; q < length; ++q)
      {
        for (std::size_t line = 0; line < count; ++line)
        {
          lines[line * length + q] = first[q * stride + line];
        }
      }
      for (std::size_t line = 0; line < count; ++line)
      {
        envelope.apply(lines.data() + line * length, spacing);
      }
      for (std::size_t q = 0; q < length; ++q)
      {
        for (std::size_t line = 0; line < count; ++line)
        {
          first[q * stride + line] = lines[line * length + q];
        }
      }
    }
  }
}

/** Squared distance along axis 0 to the nearest voxel of the kind asked for: one scan each way. */
void
startAlongRows(const LabelVolume & label, bool inside, std::vector<double> & squared)
{
  const auto   length = static_cast<std::size_t>(label.size[0]);
  const double spacing = label.spacing[0];
  for (std::size_t first = 0; first < squared.size(); first += length)
  {
    double distance = infinity;
    for (std::size_t voxel = first; voxel < first + length; ++voxel)
    {
      distance = (label.inside[voxel] != 0) == inside ? 0.0 : distance + spacing;
      squared[voxel] = distance * distance;
    }
    distance = infinity;
    for (std::size_t voxel = first + length; voxel-- > first;)
    {
      distance = (label.inside[voxel] != 0) == inside ? 0.0 : distance + spacing;
      squared[voxel] = std::min(squared[voxel], distance * distance);
    }
  }
}

/** Squared distance of every voxel centre to the nearest centre of the kind asked for. */
std::vector<double>
squaredDistanceTo(const LabelVolume & label, bool inside, const std::array<bool, 3> & axes)
{
  std::vector<double> squared(label.inside.size());
  if (axes[0])
  {
    startAlongRows(label, inside, squared);
  }
  else
  {
    std::transform(label.inside.begin(), label.inside.end(), squared.begin(), [&](std::uint8_t value) {
      return (value != 0) == inside ? 0.0 : infinity;
    });
  }
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    if (axes[axis])
    {
      transformAlong(squared, label.size, axis, label.spacing[static_cast<int>(axis)]);
    }
  }
  return squared;
}

} // namespace

std::vector<double>
voxelSignedDistance(const LabelVolume & label, const std::array<bool, 3> & axes)
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
  std::vector<double>       distance = squaredDistanceTo(label, true, axes);
  const std::vector<double> toOutside = squaredDistanceTo(label, false, axes);
  const double              half = 0.5 * smallestSpacing;
  for (std::size_t voxel = 0; voxel < distance.size(); ++voxel)
  {
    distance[voxel] = label.inside[voxel] != 0 ? half - std::sqrt(toOutside[voxel]) : std::sqrt(distance[voxel]) - half;
  }
  return distance;
}

} // namespace moserhex
