#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <functional>
#include <vector>

namespace moserhex
{

/** A function of space, in any unit. \param p  LPS [mm] */
using SpaceFunction = std::function<double(const Vector3 & p)>;

/** Options of cellMeans. */
struct CellMeanOptions
{
  int          pointsPerAxis{ 4 }; ///< Gauss points along each axis of a cell, 2 to 48 [1]
  unsigned int threads{ 0 };       ///< 0: all of the machine's
};

/** Mean of a function over every cell, (n-1)^3 in the order of the cells:
 *
 *   (integral over the cell of f) / (volume of the cell)
 *     ~  sum_q w_q f(x(xi_q)) det J(xi_q) / sum_q w_q det J(xi_q)       q^3 Gauss points, q = pointsPerAxis
 *
 * Exact, to round-off, for constant and linear functions in every cell, and in a parallelepiped for polynomials of
 * degree 2 q - 1 along each edge. For a smooth function the error falls with cell size h as h^(2q); for an interpolated
 * image it is limited by the steps (nearest) or kinks (linear) between voxels: take as many points as there are voxels
 * along a cell.
 *
 * The same for any number of threads. A value that is not a number makes its cell's mean one.
 * \param f  called by several threads at once
 * \throws InvalidInput  as requireLattice(mesh), points out of range, a cell without positive volume (names it), or
 * what f throws */
[[nodiscard]] std::vector<double>
cellMeans(const HexMesh & mesh, const SpaceFunction & f, const CellMeanOptions & options = {});

/** The function at every node, n^3 in the order of the nodes.
 * \param f  called by several threads at once \throws InvalidInput  as requireLattice(mesh), or what f throws */
[[nodiscard]] std::vector<double>
nodeSamples(const HexMesh & mesh, const SpaceFunction & f, unsigned int threads = 0);

} // namespace moserhex
