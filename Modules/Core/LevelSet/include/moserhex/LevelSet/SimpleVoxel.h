#pragma once

#include "moserhex/LevelSet/VoxelGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** The 26 voxels around one: neighbour a is a step of neighbourSteps[a] voxels along the image axes, bit a of a mask.
 */
inline constexpr std::size_t voxelNeighbours = 26;

/** Step a leads to neighbour a [voxels]. */
[[nodiscard]] const std::array<std::array<int, 3>, voxelNeighbours> &
neighbourSteps();

/** Whether a voxel whose inside neighbours are the set bits is simple with inside voxels joined by faces and outside
 * voxels also by edges and corners (VoxelTopology.h): flipping it changes neither components, nor cavities, nor
 * handles.
 *
 * Its inside neighbours among the 18 that share a face or an edge with it have exactly one 6-connected part that
 * touches it by a face, and its outside neighbours are one 26-connected part [bertrand1994]. Does not depend on the
 * voxel itself.
 */
[[nodiscard]] bool
isSimpleVoxel(std::uint32_t insideNeighbours);

/** What putting the voxel inside adds to the Euler characteristic of the inside, VoxelTopology::eulerCharacteristic. */
[[nodiscard]] int
eulerChangeOfAdding(std::uint32_t insideNeighbours);

/** Neighbourhoods in one mask. Voxels asked about must not lie in the outermost layer of the grid. */
class VoxelNeighbourhood
{
public:
  /** \param grid  of the masks; its sizes alone count */
  explicit VoxelNeighbourhood(const VoxelGrid & grid);

  /** Differences of voxel numbers to the neighbours. */
  [[nodiscard]] const std::array<std::ptrdiff_t, voxelNeighbours> &
  strides() const
  {
    return m_Strides;
  }

  /** Bit a is set where neighbour a of the voxel is inside: for isSimpleVoxel and eulerChangeOfAdding. */
  [[nodiscard]] std::uint32_t
  inside(const std::vector<std::uint8_t> & mask, std::size_t voxel) const
  {
    std::uint32_t        bits = 0;
    const std::uint8_t * centre = mask.data() + voxel;
    for (std::size_t a = 0; a < voxelNeighbours; ++a)
    {
      bits |= static_cast<std::uint32_t>(centre[m_Strides[a]] != 0) << a;
    }
    return bits;
  }

private:
  std::array<std::ptrdiff_t, voxelNeighbours> m_Strides{};
};

/** The neighbours that share a face with the voxel. */
[[nodiscard]] std::uint32_t
faceNeighbours();

} // namespace moserhex
