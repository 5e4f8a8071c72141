#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <cstddef>

namespace moserhex
{

/** Points spread over the whole closed surface {phi = 0}, however far it reaches beyond the lattice: where the edges of
 * a cubic grid cross it. The grid begins as the lattice's bounding box and grows on every side on which phi is still
 * negative, so that a surface is found that is connected to what lies in the box; parts thinner than the grid's spacing
 * may be missed.
 *
 * \param around   nodes of a lattice of the same solid [mm]
 * \param phi      negative inside, positive far away [mm]
 * \param volume   inside the surface, > 0 [mm^3]
 * \param count    wanted; a ball gets about as many, a less compact solid more
 * \return within 1/4000 of the grid's spacing of the surface; the same for any number of threads [mm]
 * \throws InvalidInput  the surface is not closed around the lattice, or there is none */
[[nodiscard]] Positions
surfacePoints(const Positions &      around,
              const SignedDistance & phi,
              double                 volume,
              std::size_t            count,
              unsigned int           threads);

} // namespace moserhex
