#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

/** Turns the maps of shells N-1, ..., 1 one after the other so that each agrees with the next larger shell's: vertices
 * of shell k are sent to their closest points on shell k+1, and the rotation that brings the two images together in the
 * least-squares sense is applied to the map of shell k.
 *
 * \param shells  entry k-1 is shell k
 * \param maps    one unit vector per vertex of each shell; entry N-1 is the reference and stays
 * \throws InvalidInput  sizes differ */
void
alignShellFramesInPlace(const std::vector<TriangleMesh> & shells, std::vector<Positions> & maps);

} // namespace moserhex
