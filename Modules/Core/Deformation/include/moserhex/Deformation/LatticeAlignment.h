#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Geometry/RigidAlignment.h"

namespace moserhex
{

/** \throws InvalidInput  as requireLattice of both, or they have not the same n */
void
requireComparable(const HexMesh & baseline, const HexMesh & followUp);

/** The motion that brings the nodes of a follow-up nearest to those of the baseline, in the sense of least squares.
 * As cells are equal, nodes lie evenly in the organ, and every part of it counts by its volume. What grows on one side
 * only pulls the answer along: a bulge that moves the mean of the nodes by d appears d smaller, and all else as moved
 * by d the other way. A similarity has the rotation and the mean of the rigid motion, and the scale (V / v)^(1/3) that
 * gives the follow-up the baseline's volume V: the scale of least squares is too small wherever nodes do not fit.
 * \throws InvalidInput  as requireComparable and rigidAlignment */
[[nodiscard]] SimilarityTransform
latticeAlignment(const HexMesh & followUp, const HexMesh & baseline, AlignmentKind kind);

/** The mesh moved. */
[[nodiscard]] HexMesh
transformed(const HexMesh & mesh, const SimilarityTransform & transform);

/** x - X of every node, n^3 x 3 [mm]. \throws InvalidInput  as requireComparable */
[[nodiscard]] Positions
displacements(const HexMesh & baseline, const HexMesh & followUp);

} // namespace moserhex
