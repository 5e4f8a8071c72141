#pragma once

#include "moserhex/HexMap/VolumeEqualisation.h"

namespace moserhex
{

/** A start for equaliseMeasures with L layers of pillow cells around the lattice (HexMesh), where the lattice itself
 * was.
 *
 * A cube's edges lie on the organ's smooth surface with their right angle opened to 180 degrees, and the scaled
 * Jacobian of the cells there has a low ceiling. Pillow cells have one face each on the surface, so that no such angle
 * is left: along the lattice's edges three cells meet at 120 degrees (Mitchell and Tautges, "Pillowing doublets:
 * refining a mesh to ensure that faces share at most one edge", 1995).
 *
 * The given lattice X maps the cube C onto the organ. The new lattice is X on s_0 C, layer l on the boundary of s_l C,
 * C scaled about its centre, with s_l^3 the part of the (n-1)^3 + 6 (n-1)^2 L cells that lies within: a
 * volume-preserving X gives all cells of the lattice, and each layer as a whole, their right volume. X is trilinear
 * between its nodes.
 *
 * \param lattice  without padding
 * \throws InvalidInput  as requireLattice, or layers < 0 */
[[nodiscard]] HexMesh
padded(const HexMesh & lattice, int layers);

/** How much right angles count. */
enum class PaddingAngles
{
  Strong, ///< in all that is done, and for longer where cells are far from right angles
  Weak    ///< half as much while minimising, not while repairing or polishing: for shapes that need all freedom
};

/** Options for equalising such a start: the scaled Jacobians of the corners count besides the mean ratio, which trades
 * right angles for edges of equal length. The sizes, tolerances and threads are those given. */
[[nodiscard]] EqualisationOptions
paddingOptions(EqualisationOptions options, PaddingAngles angles = PaddingAngles::Strong);

} // namespace moserhex
