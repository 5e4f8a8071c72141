#include "moserhex/HexMeshIO/SurfaceVoxelisation.h"

#include "moserhex/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex
{
namespace
{

/** Point of an edge on the plane z = level, from its lower end, so that both triangles of an edge get the same bits. */
struct PlanePoint
{
  double x;
  double y;
};

PlanePoint
edgeAtLevel(const Vector3 & a, const Vector3 & b, double level)
{
  const bool      aIsLower = a.z() <= level;
  const Vector3 & lower = aIsLower ? a : b;
  const Vector3 & upper = aIsLower ? b : a;
  const double    t = (level - lower.z()) / (upper.z() - lower.z());
  return { lower.x() + t * (upper.x() - lower.x()), lower.y() + t * (upper.y() - lower.y()) };
}

/** First index whose coordinate index * spacing + first is > value, limited to [0, count]. */
int
firstIndexBeyond(double value, double first, double spacing, int count)
{
  int index = static_cast<int>(std::clamp(std::floor((value - first) / spacing), -1.0, static_cast<double>(count)));
  while (index < count && first + std::max(index, 0) * spacing <= value)
  {
    ++index;
  }
  index = std::clamp(index, 0, count);
  while (index > 0 && first + (index - 1) * spacing > value)
  {
    --index;
  }
  return index;
}

LabelVolume
emptyGrid(const TriangleMesh & surface, const SurfaceVoxelisationOptions & options)
{
  if (surface.triangles.empty())
  {
    throw InvalidInput("voxelise: the surface has no triangles");
  }
  if (!(options.spacing >= 0.0) || (options.spacing == 0.0 && !(options.voxelsInBox > 0.0)) || options.margin < 1)
  {
    throw InvalidInput("voxelise: need spacing >= 0, voxelsInBox > 0 and margin >= 1");
  }
  const BoundingBox box = boundingBox(surface.vertices);
  const Vector3     extent = box.upper - box.lower;
  double            spacing = options.spacing;
  if (spacing == 0.0)
  {
    spacing = std::cbrt(extent.prod() / options.voxelsInBox);
  }
  const Vector3 steps = (extent / spacing).array().ceil() + 2.0 * options.margin;
  const double  voxels = (steps.array() + 1.0).prod();
  if (!(voxels <= static_cast<double>(options.maximumVoxels)))
  {
    throw InvalidInput("voxelise: " + std::to_string(voxels) + " voxels of " + std::to_string(spacing) +
                       " mm, need at most " + std::to_string(options.maximumVoxels));
  }
  LabelVolume grid;
  grid.spacing = Vector3::Constant(spacing);
  grid.direction = Matrix3::Identity();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(steps[axis]) + 1;
  }
  grid.origin = 0.5 * (box.lower + box.upper) - 0.5 * spacing * steps;
  return grid;
}

/** Adds the crossings of one triangle with the grid lines along x to `change`, which holds for every voxel the change
 * of the winding number on the way into it. */
class CrossingCounter
{
public:
  CrossingCounter(const LabelVolume & grid, std::vector<int> & change) : m_Grid(grid), m_Change(change)
  {}

  void
  addTriangle(const Vector3 & a, const Vector3 & b, const Vector3 & c)
  {
    const double lowest = std::min({ a.z(), b.z(), c.z() });
    const double highest = std::max({ a.z(), b.z(), c.z() });
    // Half-open: the plane through voxels k meets the triangle when lowest <= z_k < highest.
    for (int k = std::max(0, firstIndex(lowest, 2) - 1); k < m_Grid.size[2]; ++k)
    {
      const double level = coordinate(k, 2);
      if (level >= highest)
      {
        break;
      }
      if (level >= lowest)
      {
        addSegment(k, level, { { a, b, c } });
      }
    }
  }

private:
  /** The triangle cuts the plane in a segment between two of its edges: one going up, one going down. */
  void
  addSegment(int k, double level, const std::array<Vector3, 3> & corners)
  {
    PlanePoint rising{};
    PlanePoint falling{};
    for (std::size_t side = 0; side < 3; ++side)
    {
      const Vector3 & from = corners[side];
      const Vector3 & to = corners[(side + 1) % 3];
      if (from.z() <= level && to.z() > level)
      {
        rising = edgeAtLevel(from, to, level);
      }
      else if (from.z() > level && to.z() <= level)
      {
        falling = edgeAtLevel(from, to, level);
      }
    }
    const bool         risingFirst = rising.y <= falling.y;
    const PlanePoint & first = risingFirst ? rising : falling;
    const PlanePoint & second = risingFirst ? falling : rising;
    for (int j = std::max(0, firstIndex(first.y, 1) - 1); j < m_Grid.size[1]; ++j)
    {
      const double y = coordinate(j, 1);
      if (y >= second.y)
      {
        break;
      }
      if (y >= first.y)
      {
        const double      t = (y - first.y) / (second.y - first.y);
        const double      x = first.x + t * (second.x - first.x);
        const int         i = firstIndex(x, 0);
        const std::size_t line =
          static_cast<std::size_t>(j) + static_cast<std::size_t>(m_Grid.size[1]) * static_cast<std::size_t>(k);
        if (i < m_Grid.size[0])
        {
          m_Change[line * static_cast<std::size_t>(m_Grid.size[0]) + static_cast<std::size_t>(i)] +=
            risingFirst ? 1 : -1;
        }
      }
    }
  }

  [[nodiscard]] double
  coordinate(int index, int axis) const
  {
    return m_Grid.origin[axis] + index * m_Grid.spacing[axis];
  }

  [[nodiscard]] int
  firstIndex(double value, int axis) const
  {
    return firstIndexBeyond(
      value, m_Grid.origin[axis], m_Grid.spacing[axis], m_Grid.size[static_cast<std::size_t>(axis)]);
  }

  const LabelVolume & m_Grid;
  std::vector<int> &  m_Change;
};

} // namespace

LabelVolume
voxelise(const TriangleMesh & surface, const SurfaceVoxelisationOptions & options)
{
  LabelVolume       grid = emptyGrid(surface, options);
  const std::size_t lineLength = static_cast<std::size_t>(grid.size[0]);
  const std::size_t voxels =
    lineLength * static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(grid.size[2]);

  std::vector<int> change(voxels, 0);
  CrossingCounter  counter(grid, change);
  for (const Triangle & triangle : surface.triangles)
  {
    counter.addTriangle(surface.vertices[static_cast<std::size_t>(triangle[0])],
                        surface.vertices[static_cast<std::size_t>(triangle[1])],
                        surface.vertices[static_cast<std::size_t>(triangle[2])]);
  }

  grid.inside.assign(voxels, 0);
  for (std::size_t lineBegin = 0; lineBegin < voxels; lineBegin += lineLength)
  {
    int winding = 0;
    for (std::size_t voxel = lineBegin; voxel < lineBegin + lineLength; ++voxel)
    {
      winding += change[voxel];
      grid.inside[voxel] = winding != 0 ? 1 : 0;
    }
  }
  return grid;
}

} // namespace moserhex
