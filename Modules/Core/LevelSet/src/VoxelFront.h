#pragma once

#include "moserhex/LevelSet/LabelVolume.h"
#include "moserhex/LevelSet/SimpleVoxel.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex::detail
{

/** Empty layers around the box that fronts move in: neighbourhoods of its voxels stay in the grid. */
inline constexpr int frontMargin = 2;

/** A ball inside the label: grown from one voxel by simple voxels of the label, those with the smallest order first
 * (of equals the one that was reached first); a voxel that is not simple waits until it is. Cuts handles and leaves
 * components out. \param label  with an empty margin of frontMargin voxels \param order  one value per voxel \param
 * seed   number of a voxel inside */
[[nodiscard]] std::vector<std::uint8_t>
ballWithin(const LabelVolume & label, const std::vector<double> & order, std::size_t seed);

/** A ball around the label: its bounding box shrunk by simple voxels outside the label, those with the largest order
 * first. Closes tunnels, joins components, fills cavities. */
[[nodiscard]] std::vector<std::uint8_t>
ballAround(const LabelVolume & label, const std::vector<double> & order);

/** The 26-connected parts of the voxels that are in `a` and not in `b`, in voxel order; neither reaches the border of
 * the grid. */
[[nodiscard]] std::vector<std::vector<std::size_t>>
partsOfDifference(const VoxelNeighbourhood &        neighbourhood,
                  const std::vector<std::uint8_t> & a,
                  const std::vector<std::uint8_t> & b);

/** Makes patches of changed voxels thicker by simple voxels, so that the topology stays as it is. */
class PatchThickener
{
public:
  /** \param radius  how far from the patch a voxel's centre may lie to follow it [mm] */
  PatchThickener(const LabelVolume & label, double radius);

  /** The patch has been given the value (1 inside, 0 outside) in the mask already. Voxels around follow it, nearest
   * first, and are added to the patch. Nothing outside the box without the margin changes. */
  void
  thicken(std::vector<std::uint8_t> & mask, std::vector<std::size_t> & patch, std::uint8_t value);

private:
  struct Offset
  {
    std::array<int, 3> step;
    std::ptrdiff_t     stride;
    double             distance;
  };

  [[nodiscard]] std::vector<std::size_t>
  reach(const std::vector<std::uint8_t> & mask, const std::vector<std::size_t> & patch, std::uint8_t value);

  VoxelGrid                 m_Grid;
  VoxelNeighbourhood        m_Neighbourhood;
  std::vector<Offset>       m_Offsets;
  std::vector<double>       m_Distance; ///< of the voxels in reach; infinity elsewhere, and always between two calls
  std::vector<std::uint8_t> m_Queued;   ///< 0 between two calls
};

} // namespace moserhex::detail
