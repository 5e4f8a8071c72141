#pragma once

#include "moserhex/Common/Random.h"
#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <array>

namespace moserhex::test
{

/** Grid of n^3 nodes on the cube [-1, 1]^3. */
inline RegularGrid
unitGrid(int n)
{
  RegularGrid grid;
  grid.size = { { n, n, n } };
  grid.spacing = 2.0 / (n - 1);
  grid.origin = Vector3(-1.0, -1.0, -1.0);
  return grid;
}

template <typename TFunction>
LevelSet
sample(const RegularGrid & grid, const TFunction & function)
{
  LevelSet levelSet{ grid, std::vector<double>(grid.nodeCount()) };
  for (std::size_t node = 0; node < levelSet.values.size(); ++node)
  {
    levelSet.values[node] = function(grid.point(node));
  }
  return levelSet;
}

/** Independent uniform values inside, 2 on the border. */
inline LevelSet
randomField(const std::array<int, 3> & size, std::uint64_t seed)
{
  LevelSet levelSet;
  levelSet.grid.size = size;
  Random random(seed);
  for (std::size_t node = 0; node < levelSet.grid.nodeCount(); ++node)
  {
    levelSet.values.push_back(levelSet.grid.isBorder(node) ? 2.0 : random.uniform());
  }
  return levelSet;
}

/** Mask of a function of the voxel's position relative to the middle of the image [mm]: inside where it is negative. */
template <typename TFunction>
LabelVolume
labelOf(const std::array<int, 3> & size, const Vector3 & spacing, const TFunction & function)
{
  LabelVolume label;
  label.size = size;
  label.spacing = spacing;
  label.origin = -0.5 * spacing.cwiseProduct(Vector3(size[0] - 1, size[1] - 1, size[2] - 1));
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        label.inside.push_back(function(label.point(i, j, k)) < 0.0 ? 1 : 0);
      }
    }
  }
  return label;
}

inline LabelVolume
randomLabel(const std::array<int, 3> & size, double density, std::uint64_t seed)
{
  Random      random(seed);
  LabelVolume label;
  label.size = size;
  label.inside.resize(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (auto & voxel : label.inside)
  {
    voxel = random.uniform() < density ? 1 : 0;
  }
  return label;
}

} // namespace moserhex::test
