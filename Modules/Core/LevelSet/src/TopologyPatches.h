#pragma once

#include "VoxelFront.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace moserhex::detail
{

/** Voxels that may change together, and what that does. */
struct TopologyPatch
{
  bool                     fills{ false };
  std::vector<std::size_t> voxels;
  long                     handles{ 0 };    ///< that it takes away
  long                     components{ 0 }; ///< that it removes or joins to others

  [[nodiscard]] bool
  makesSimpler() const
  {
    return handles >= 0 && handles + components > 0;
  }
};

/** One round of repair: a label without cavities, its patches, and which of them can still be made.
 *
 * What a patch takes away is found from its own voxels: the change of the Euler characteristic, and the components it
 * holds or touches. That is exact while patches that touch each other are not made in the same round: then no patch
 * ever makes a component, a cavity or a handle. */
class TopologyRound
{
public:
  /** \param label     with an empty margin of frontMargin voxels, no cavity, no ball
   *  \param thickener of the same grid */
  TopologyRound(LabelVolume & label, PatchThickener & thickener);

  /** Patches that make the topology simpler, from the smallest to the largest (then: removing before adding, voxel
   * order). */
  [[nodiscard]] std::vector<TopologyPatch> &
  patches()
  {
    return m_Patches;
  }

  /** Whether the patch touches one made before in this round. */
  [[nodiscard]] bool
  mustWait(const TopologyPatch & patch) const;

  /** Changes the label, and says in the patch what that took away. Nothing happens, and the answer is false, where
   * another patch has done its work already. */
  [[nodiscard]] bool
  make(TopologyPatch & patch);

private:
  void
  addPatches(PatchThickener & thickener, std::vector<std::vector<std::size_t>> parts, bool fills);

  /** Flips the voxels one by one. \return change of the Euler characteristic */
  long
  flip(const std::vector<std::size_t> & voxels, std::uint8_t value);

  /** Components that the voxels hold completely (removing) or connect to others (filling). */
  [[nodiscard]] long
  componentsTaken(const TopologyPatch & patch) const;

  [[nodiscard]] std::set<std::size_t>
  touchedComponents(const TopologyPatch & patch) const;

  void
  joinTouched(const TopologyPatch & patch);

  [[nodiscard]] std::size_t
  rootOf(std::int32_t component) const;

  LabelVolume &              m_Label;
  VoxelNeighbourhood         m_Neighbourhood;
  std::vector<std::int32_t>  m_Component; ///< of each voxel at the beginning of the round; -1 outside
  std::vector<std::size_t>   m_Parent;    ///< of each component: components that were joined have one root
  std::vector<std::size_t>   m_Voxels;    ///< of each root
  std::vector<std::uint8_t>  m_Changed;   ///< voxels changed in this round
  std::vector<TopologyPatch> m_Patches;
};

} // namespace moserhex::detail
