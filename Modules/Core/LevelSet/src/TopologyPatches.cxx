#include "TopologyPatches.h"

#include "VoxelParts.h"
#include "moserhex/LevelSet/SignedDistance.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace moserhex::detail
{
namespace
{

/** The deepest voxel of the largest component (the first of equals). */
std::size_t
deepestVoxel(const Parts & parts, const std::vector<std::int32_t> & component, const std::vector<double> & distance)
{
  const auto largest =
    static_cast<std::int32_t>(std::max_element(parts.voxels.begin(), parts.voxels.end()) - parts.voxels.begin());
  std::size_t deepest = component.size();
  for (std::size_t voxel = 0; voxel < component.size(); ++voxel)
  {
    if (component[voxel] == largest && (deepest == component.size() || distance[voxel] < distance[deepest]))
    {
      deepest = voxel;
    }
  }
  return deepest;
}

} // namespace

TopologyRound::TopologyRound(LabelVolume & label, PatchThickener & thickener)
  : m_Label(label), m_Neighbourhood(label), m_Component(label.inside.size(), -1), m_Changed(label.inside.size(), 0)
{
  const Parts parts = connectedParts(label, true, Adjacency::Faces);
  for (const Run & run : parts.runs)
  {
    std::fill(m_Component.begin() + static_cast<std::ptrdiff_t>(run.begin),
              m_Component.begin() + static_cast<std::ptrdiff_t>(run.end),
              run.part);
  }
  m_Voxels = parts.voxels;
  for (std::size_t component = 0; component < m_Voxels.size(); ++component)
  {
    m_Parent.push_back(component);
  }
  const std::vector<double> distance = voxelSignedDistance(label, { { true, true, true } });
  const std::size_t         seed = deepestVoxel(parts, m_Component, distance);
  addPatches(thickener, partsOfDifference(m_Neighbourhood, label.inside, ballWithin(label, distance, seed)), false);
  addPatches(thickener, partsOfDifference(m_Neighbourhood, ballAround(label, distance), label.inside), true);
  std::stable_sort(m_Patches.begin(), m_Patches.end(), [](const TopologyPatch & a, const TopologyPatch & b) {
    return a.voxels.size() < b.voxels.size();
  });
}

void
TopologyRound::addPatches(PatchThickener & thickener, std::vector<std::vector<std::size_t>> parts, bool fills)
{
  const std::uint8_t value = fills ? 1 : 0;
  for (std::vector<std::size_t> & part : parts)
  {
    TopologyPatch patch{ fills, std::move(part), 0, 0 };
    patch.components = componentsTaken(patch);
    const long euler = flip(patch.voxels, value);
    patch.handles = euler + patch.components;
    const bool removesOnly = !fills && patch.handles == 0;
    if (patch.makesSimpler() && !removesOnly)
    {
      thickener.thicken(m_Label.inside, patch.voxels, value);
    }
    for (const std::size_t voxel : patch.voxels)
    {
      m_Label.inside[voxel] = fills ? 0 : 1;
    }
    if (patch.makesSimpler())
    {
      m_Patches.push_back(std::move(patch));
    }
  }
}

long
TopologyRound::flip(const std::vector<std::size_t> & voxels, std::uint8_t value)
{
  long change = 0;
  for (const std::size_t voxel : voxels)
  {
    const int added = eulerChangeOfAdding(m_Neighbourhood.inside(m_Label.inside, voxel));
    change += value != 0 ? added : -added;
    m_Label.inside[voxel] = value;
  }
  return change;
}

std::size_t
TopologyRound::rootOf(std::int32_t component) const
{
  auto root = static_cast<std::size_t>(component);
  while (m_Parent[root] != root)
  {
    root = m_Parent[root];
  }
  return root;
}

long
TopologyRound::componentsTaken(const TopologyPatch & patch) const
{
  if (!patch.fills)
  {
    std::map<std::size_t, std::size_t> voxels;
    for (const std::size_t voxel : patch.voxels)
    {
      ++voxels[rootOf(m_Component[voxel])];
    }
    return static_cast<std::size_t>(std::count_if(
      voxels.begin(), voxels.end(), [&](const auto & part) { return part.second == m_Voxels[part.first]; }));
  }
  return std::max(0L, static_cast<long>(touchedComponents(patch).size()) - 1);
}

std::set<std::size_t>
TopologyRound::touchedComponents(const TopologyPatch & patch) const
{
  std::set<std::size_t> touched;
  for (const std::size_t voxel : patch.voxels)
  {
    for (std::uint32_t faces = faceNeighbours(); faces != 0; faces &= faces - 1)
    {
      const auto        face = static_cast<std::size_t>(__builtin_ctz(faces));
      const std::size_t next = voxel + static_cast<std::size_t>(m_Neighbourhood.strides()[face]);
      if (m_Label.inside[next] != 0 && m_Component[next] >= 0)
      {
        touched.insert(rootOf(m_Component[next]));
      }
    }
  }
  return touched;
}

void
TopologyRound::joinTouched(const TopologyPatch & patch)
{
  const std::set<std::size_t> touched = touchedComponents(patch);
  const std::size_t           root = *touched.begin();
  for (const std::size_t other : touched)
  {
    if (other != root)
    {
      m_Parent[other] = root;
      m_Voxels[root] += m_Voxels[other];
    }
  }
}

bool
TopologyRound::mustWait(const TopologyPatch & patch) const
{
  return std::any_of(patch.voxels.begin(), patch.voxels.end(), [&](std::size_t voxel) {
    return m_Changed[voxel] != 0 || m_Neighbourhood.inside(m_Changed, voxel) != 0;
  });
}

bool
TopologyRound::make(TopologyPatch & patch)
{
  const long euler = patch.handles - patch.components;
  patch.components = componentsTaken(patch);
  patch.handles = euler + patch.components;
  if (!patch.makesSimpler())
  {
    return false;
  }
  for (const std::size_t voxel : patch.voxels)
  {
    m_Label.inside[voxel] = patch.fills ? 1 : 0;
    m_Changed[voxel] = 1;
  }
  if (patch.fills)
  {
    joinTouched(patch);
  }
  else
  {
    for (const std::size_t voxel : patch.voxels)
    {
      --m_Voxels[rootOf(m_Component[voxel])];
    }
  }
  return true;
}

} // namespace moserhex::detail
