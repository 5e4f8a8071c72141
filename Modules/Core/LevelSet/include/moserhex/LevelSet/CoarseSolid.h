#pragma once

#include "moserhex/LevelSet/LevelSet.h"

#include <string>

namespace moserhex
{

/** Options of coarseSolid. */
struct CoarseSolidOptions
{
  double nodesPerSide{ 24.0 };         ///< spacings in V^(1/3) [1]
  double nodesAcrossThickness{ 4.0 };  ///< spacings in the mean thickness 2 V / A, for thin solids [1]
  double refinement{ 0.7 };            ///< of the spacing while the solid changes on the coarse grid, in (0,1) [1]
  double acceptedVolumeChange{ 0.02 }; ///< of the solid on the coarse grid [1]
};

/** What coarseSolid made. */
struct CoarseSolid
{
  LevelSet levelSet;         ///< phi on the coarse grid [mm]
  int      refinements{ 0 }; ///< times the spacing was too large for the solid
};

/** The same solid on a grid that knows nothing of the lattice: for a few shells that only start an optimisation.
 *
 *   H = min(V^(1/3) / 24, V / (2 A))          A = area of the faces between nodes inside and outside, as a voxel's
 *
 * Values are those of the Catmull-Rom interpolant; three coarse nodes around the solid, where beyond the grid of phi
 * the way to it is added. H shrinks by 0.7 until {phi < 0} is a ball of volume V within 2 %; where it would come close
 * to the spacing of phi, phi itself is returned.
 *
 * Guarantees: {phi < c} is a ball and the level set c one sphere for |c| < H/2, as after conditionLabel().
 *
 * \param phi     signed distance of a ball, as conditionLabel() makes it  [mm]
 * \param volume  of the solid                                             [mm^3]
 * \throws InvalidInput  invalid level set or one without a node inside; volume not positive and finite; an option out
 * of range or not finite \note O(nodes of phi) once, to find its extent; the rest does not depend on the spacing of
 * phi. Deterministic. */
[[nodiscard]] CoarseSolid
coarseSolid(const LevelSet & phi, double volume, const CoarseSolidOptions & options = {});

/** "31 x 29 x 30 nodes", and how often the spacing had to shrink. */
[[nodiscard]] std::string
describe(const CoarseSolid & solid);

} // namespace moserhex
