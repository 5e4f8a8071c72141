#pragma once

#include "moserhex/Geometry/TriangleTopology.h"

#include <Eigen/SparseCore>

namespace moserhex
{

/** Discrete exterior calculus on closed triangulated surfaces: 0-forms on vertices, 1-forms on edges, 2-forms on
 * triangles. Edges are those of TriangleTopology, directed from the smaller to the larger vertex number.
 *
 *   d0: (d0 f)(i,j) = f_j - f_i        d1: sum around a triangle        d1 d0 = 0
 *   L = d0^T star1 d0                  positive SEMIDEFINITE: L ~ -Laplacian times area, L 1 = 0
 *
 * L is positive semidefinite for any triangles, obtuse ones too, since f^T L f is the Dirichlet energy of the
 * piecewise linear function f; single weights may be negative. */
using SparseMatrix = Eigen::SparseMatrix<double>;

/** nE x nV, entries -1 at the smaller and +1 at the larger vertex of an edge. */
[[nodiscard]] SparseMatrix
d0(const TriangleTopology & topology, std::size_t vertexCount);

/** nF x nE, entry +1 where the triangle runs along its edge, -1 where against. */
[[nodiscard]] SparseMatrix
d1(const TriangleMesh & mesh, const TriangleTopology & topology);

/** (cot a + cot b) / 2 for the two angles opposite each edge, nE [1]. The diagonal of the Hodge star on 1-forms.
 * Angles of degenerate triangles are taken as 1e-6 rad from the limit, so that every weight is finite.
 * \throws InvalidInput when a position is not finite */
[[nodiscard]] std::vector<double>
cotanWeights(const TriangleMesh & mesh, const TriangleTopology & topology);

/** Cotangent weights forced into [smallest, largest], nE [1]. Positive weights make L an M-matrix: harmonic maps of it
 * obey the maximum principle. 0 < smallest <= largest. */
[[nodiscard]] std::vector<double>
clampedCotanWeights(const TriangleMesh & mesh, const TriangleTopology & topology, double smallest, double largest);

/** A third of the area of the incident triangles, nV [mm^2]. Sums to the area of the surface. */
[[nodiscard]] std::vector<double>
lumpedMass(const TriangleMesh & mesh);

/** Diagonal Hodge star on 0-forms: lumpedMass, nV x nV [mm^2]. */
[[nodiscard]] SparseMatrix
star0(const TriangleMesh & mesh);

/** Diagonal Hodge star on 1-forms: cotanWeights, nE x nE [1]. */
[[nodiscard]] SparseMatrix
star1(const TriangleMesh & mesh, const TriangleTopology & topology);

/** L_ij = -w_ij, L_ii = sum_j w_ij, nV x nV: the whole symmetric matrix, assembled edge by edge. O(nE). */
[[nodiscard]] SparseMatrix
weightedLaplacian(const TriangleTopology & topology, const std::vector<double> & edgeWeights, std::size_t vertexCount);

/** weightedLaplacian with cotanWeights [1]. (star0^-1 L) f is minus the Laplace-Beltrami of f, order 2 in the mesh
 * size in the weak sense. */
[[nodiscard]] SparseMatrix
cotanLaplacian(const TriangleMesh & mesh);

} // namespace moserhex
