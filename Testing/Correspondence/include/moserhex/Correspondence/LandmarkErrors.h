#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <functional>
#include <vector>

namespace moserhex
{

/** |a_i - b_i| of every pair [mm]. \throws InvalidInput  another number of points, or none */
[[nodiscard]] std::vector<double>
pointDistances(const Positions & a, const Positions & b);

/** Distances of the follow-up's nodes to where a deformation takes the baseline's, of the (n-2)^3 nodes that do not lie
 * on the boundary, over the edge of a cube with a cell's mean volume in the follow-up [1].
 * \throws InvalidInput  as requireLattice of both, another n, or n < 3 */
[[nodiscard]] std::vector<double>
innerLandmarkErrors(const HexMesh &                                   baseline,
                    const HexMesh &                                   followUp,
                    const std::function<Vector3(const Vector3 & p)> & deformation);

/** F of the affine map from some points to others that is best in the sense of least squares,
 *
 *   F = (sum y x^T) (sum x x^T)^-1,     x, y less their means                                                    [1]
 *
 * \throws InvalidInput  another number of points, or the first ones lie in a plane */
[[nodiscard]] Matrix3
affinePart(const Positions & from, const Positions & to);

/** Largest entry of the difference between the affine parts of what a follow-up's nodes do and of what a deformation
 * does with the baseline's [1]. \throws InvalidInput  as affinePart */
[[nodiscard]] double
affinePartError(const HexMesh &                                   baseline,
                const HexMesh &                                   followUp,
                const std::function<Vector3(const Vector3 & p)> & deformation);

} // namespace moserhex
