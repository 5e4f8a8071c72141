#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/VoxelTopology.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex
{

/** Options of repairTopology. */
struct TopologyRepairOptions
{
  /** Most that may change: voxels added and removed over voxels of the label [1]. */
  double maximumChange{ 0.05 };

  /** Cuts, bridges and plugs reach this far to both sides of the narrowest place, so that a later smoothing does not
   * undo them [mm]; where that changes too much, half of it, and then one voxel. 0: always one voxel. */
  double radius{ 0.0 };

  /** How messages name the label. */
  std::string labelName{ "label" };
};

/** What happened to a patch of voxels. */
enum class TopologyChangeKind
{
  ComponentRemoved, ///< a component other than the largest went outside
  ComponentsJoined, ///< a bridge between components came inside
  CavityFilled,     ///< a closed part of the outside came inside
  HandleCut,        ///< a cut through one or more handles went outside
  TunnelFilled      ///< plugs of one or more tunnels came inside
};

/** What was done, for one and for many: "handle cut", "handles cut". */
[[nodiscard]] std::string
nameOf(TopologyChangeKind kind, std::size_t count = 1);

/** One connected patch of voxels that changed. */
struct TopologyChange
{
  TopologyChangeKind kind{ TopologyChangeKind::ComponentRemoved }; ///< what happened to it
  std::size_t        parts{ 0 };                ///< components removed or joined to another, or cavities filled
  std::size_t        handles{ 0 };              ///< handles cut or tunnels filled
  std::size_t        voxels{ 0 };               ///< added, or removed (component removed, handle cut)
  Vector3            centre{ Vector3::Zero() }; ///< mean of the voxel centres [mm, LPS]

  /** The voxels of the patch came inside; otherwise they went outside. */
  [[nodiscard]] bool
  adds() const
  {
    return kind != TopologyChangeKind::ComponentRemoved && kind != TopologyChangeKind::HandleCut;
  }
};

/** What a repair changed. */
struct TopologyRepairReport
{
  VoxelTopology               before;           ///< topology of the label as it was
  std::vector<TopologyChange> changes;          ///< in the order they were made; empty for a ball
  std::size_t                 voxelsAdded{ 0 }; ///< inside now, not before; of a voxel changed twice no change is left
  std::size_t                 voxelsRemoved{ 0 }; ///< inside before, not now
  std::size_t                 labelVoxels{ 0 };   ///< before
  double                      voxelVolume{ 0.0 }; ///< [mm^3]

  /** (added + removed) / label [1] */
  [[nodiscard]] double
  changedFraction() const;
};

/** One line per kind of change: how many, how much, where the largest is. */
[[nodiscard]] std::vector<std::string>
describe(const TopologyRepairReport & report);

/** What repairTopology made. */
struct TopologyRepairResult
{
  LabelVolume          label;  ///< a ball, on the grid of the input
  TopologyRepairReport report; ///< what was changed
};

/** Makes one solid of genus 0 of a label, with the smaller change of volume at every handle and every component.
 *
 * 1. Cavities are filled.
 * 2. A ball B grows within the label M from the deepest voxel of the largest component, and the bounding box shrinks to
 *    a ball F around M, both by simple voxels (SimpleVoxel.h) in the order of the signed distance [mm]: the fronts meet
 *    where M, or its outside, is narrowest.
 * 3. Every 26-connected patch of M - B cuts handles or holds components, every one of F - M fills tunnels or joins
 *    components; patches of one kind do not depend on each other. They become thicker by simple voxels, and are made
 *    from the smallest to the largest where the topology gets simpler; one that touches a patch made before waits.
 * 4. Again from 1 until M is a ball.
 *
 * A ball is not changed by a voxel. Every change is checked by the Euler characteristic, and the whole with
 * voxelTopology(). The same answer for every origin and direction. Deterministic.
 *
 * \throws InvalidInput  invalid or empty label, options out of range; ErrorCode::Topology where more than maximumChange
 *         would have to change (with what was found until then: no more is computed) */
[[nodiscard]] TopologyRepairResult
repairTopology(const LabelVolume & label, const TopologyRepairOptions & options = {});

/** "2 components, 1 handle, V-E+F = 2": what is not as in a ball, and the number that should be 2. */
[[nodiscard]] std::string
describe(const VoxelTopology & topology);

} // namespace moserhex
