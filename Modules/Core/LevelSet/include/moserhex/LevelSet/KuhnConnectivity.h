#pragma once

#include "moserhex/LevelSet/RegularGrid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace moserhex
{

/** The 14 neighbours of a node when every grid cube is cut into its six Kuhn (Freudenthal) tetrahedra: the non-zero
 * 0/1 vectors m (numbers 0..6, m-1 as bits i, j, k) and their negatives (numbers 7..13).
 *
 * The tetrahedra of a cube are the monotone paths from its corner (0,0,0) to (1,1,1). The complex is the same in every
 * cube, so inside and outside have the SAME connectivity and a piecewise linear level set has no ambiguous case. */
inline constexpr std::array<std::array<int, 3>, 14> kuhnOffsets{ { { { 1, 0, 0 } },
                                                                   { { 0, 1, 0 } },
                                                                   { { 1, 1, 0 } },
                                                                   { { 0, 0, 1 } },
                                                                   { { 1, 0, 1 } },
                                                                   { { 0, 1, 1 } },
                                                                   { { 1, 1, 1 } },
                                                                   { { -1, 0, 0 } },
                                                                   { { 0, -1, 0 } },
                                                                   { { -1, -1, 0 } },
                                                                   { { 0, 0, -1 } },
                                                                   { { -1, 0, -1 } },
                                                                   { { 0, -1, -1 } },
                                                                   { { -1, -1, -1 } } } };

/** Whether a node whose inside neighbours are the set bits of `linkMask` (14 bits, order of kuhnOffsets) is simple:
 * the inside part and the outside part of its link, a triangulated sphere of 14 vertices, are both connected and not
 * empty. Moving a simple node to the other side changes the topology of neither side (nor of the surface between). */
[[nodiscard]] bool
isSimpleLink(unsigned int linkMask);

/** Simple-node test on one grid. `inside` has one entry per node, 0 or 1; the node must not lie on the border. */
class KuhnConnectivity
{
public:
  /** \param grid  its sizes alone count */
  explicit KuhnConnectivity(const RegularGrid & grid);

  /** Differences of node numbers to the 14 neighbours, in the order of kuhnOffsets. */
  [[nodiscard]] const std::array<std::ptrdiff_t, 14> &
  strides() const
  {
    return m_Strides;
  }

  /** Bit a is set where neighbour a, in the order of kuhnOffsets, is inside: for isSimpleLink. */
  [[nodiscard]] unsigned int
  linkMask(const std::vector<std::uint8_t> & inside, std::size_t node) const
  {
    unsigned int         mask = 0;
    const std::uint8_t * centre = inside.data() + node;
    for (unsigned int a = 0; a < 14; ++a)
    {
      mask |= static_cast<unsigned int>(centre[m_Strides[a]] != 0) << a;
    }
    return mask;
  }

  /** Whether the node is simple, as isSimpleLink says of its link; whether the node itself is inside does not
   * matter. */
  [[nodiscard]] bool
  isSimple(const std::vector<std::uint8_t> & inside, std::size_t node) const
  {
    return m_IsSimple[linkMask(inside, node)] != 0;
  }

private:
  std::array<std::ptrdiff_t, 14> m_Strides{};
  const std::uint8_t *           m_IsSimple; ///< immutable table of 2^14 entries that lives as long as the program
};

/** Euler characteristic of the solid: vertices - edges + triangles - tetrahedra of the Kuhn complex whose vertices are
 * all inside. 1 for a ball. The level set between inside and outside has twice this value (2 for a sphere).
 * \throws InvalidInput  invalid grid or wrong number of entries */
[[nodiscard]] long
kuhnEulerCharacteristic(const RegularGrid & grid, const std::vector<std::uint8_t> & inside);

} // namespace moserhex
