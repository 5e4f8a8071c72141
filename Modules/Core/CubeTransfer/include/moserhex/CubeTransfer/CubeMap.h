#pragma once

#include "moserhex/Geometry/HexMesh.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace moserhex
{

class CellBoxTree;

/** A place in the cube: a cell, and where in it. */
struct CubePlace
{
  std::size_t cell{ 0 };                ///< its number in the lattice
  Vector3     local{ Vector3::Zero() }; ///< (xi, eta, zeta) in [0,1]^3 [1]
};

/** The map from the unit cube to a mesh, trilinear in every cell, and its inverse.
 *
 *   cube coordinates  c = ((i,j,k) + (xi,eta,zeta)) / (n - 1) in [0,1]^3,     (i,j,k) the cell's lattice index
 *   position          x(c) = sum_a N_a(xi,eta,zeta) x_a                                                    [mm]
 *
 * Continuous: neighbours agree on their common face to the last bit. One-to-one where det J > 0 in whole cells
 * (certifyCells) and the surface does not cut itself. Keeps a reference: the mesh must outlive the object. All members
 * may be called by several threads at once. */
class CubeMap
{
public:
  /** \throws InvalidInput  as requireLattice(mesh) \note O(cells) time; a tree of boxes in some 10 bytes a cell */
  explicit CubeMap(const HexMesh & mesh);
  explicit CubeMap(HexMesh &&) = delete;
  ~CubeMap();
  CubeMap(const CubeMap &) = delete;
  CubeMap &
  operator=(const CubeMap &) = delete;

  /** The place of a point, found once: of the cells that hold it, on common faces, edges and nodes, the one with the
   * lowest number. Nothing for points outside the mesh or not finite.
   *
   * Newton's method from the cell's centre; where it does not lead into the cell, from the centres of its halves,
   * quarters and so on, parts that cannot hold the point left out (a part's image lies in the convex hull of its eight
   * corners, taken in the axes of its centre's tangents). A point counts as inside when it is at most 1e-12 of the
   * cell's diagonal and a few units of rounding of the coordinates away, and its place has the image nearest to it.
   * About 1 us a point. \param p  [mm] */
  [[nodiscard]] std::optional<CubePlace>
  find(const Vector3 & p) const;

  /** find() for every point; the same for any number of threads. \param threads  as in parallelFor */
  [[nodiscard]] std::vector<std::optional<CubePlace>>
  find(const Positions & points, unsigned int threads) const;

  /** Cube coordinates of a place [1]. */
  [[nodiscard]] Vector3
  cubeCoordinates(const CubePlace & place) const;

  /** The cell, the one with the lowest number where several meet, and the place in it.
   * \throws InvalidInput  outside [0,1]^3, or not a number */
  [[nodiscard]] CubePlace
  place(const Vector3 & cubeCoordinates) const;

  /** [mm] */
  [[nodiscard]] Vector3
  position(const CubePlace & place) const;

private:
  /** \param candidates  scratch */
  [[nodiscard]] std::optional<CubePlace>
  find(const Vector3 & p, std::vector<std::size_t> & candidates) const;

  const HexMesh &                    m_Mesh;
  double                             m_Rounding; ///< of the nodes' coordinates [mm]
  std::unique_ptr<const CellBoxTree> m_Tree;
};

} // namespace moserhex
