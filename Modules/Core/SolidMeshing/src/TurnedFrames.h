#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <vector>

namespace moserhex
{

/** Rotations on a lattice of rotation vectors, as far from the identity as makes a difference to a cube: none of its 24
 * turns brings them nearer. Nearest first; the first is the identity.
 * \param step  between neighbours, 5 to 60 [degree] */
[[nodiscard]] std::vector<Matrix3>
turnsOfTheCube(double step);

/** The turns of the frame in which the cube's edges lie best on the surface, best first: least mean logarithm of
 * edgeScore on 6 and 10 nodes a side. The identity is not among them.
 * \param sphereMap  of the outermost shell, in the frame that is turned
 * \return at most `count`; the same for any number of threads */
[[nodiscard]] std::vector<Matrix3>
promisingTurns(const TriangleMesh & surface, const Positions & sphereMap, std::size_t count, unsigned int threads);

} // namespace moserhex
