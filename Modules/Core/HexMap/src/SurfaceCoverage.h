#pragma once

#include "LatticeVector.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <array>
#include <vector>

namespace moserhex
{

/** What keeps the lattice from draining out of the organ's tips. SurfaceAttraction sees how far the lattice is from the
 * surface; this sees how far the surface is from the lattice,
 *
 *   E(x) = w / 2 sum over surface points p of k_p max(0, |p - b(x)| - d)^2
 *
 * k_p = 1 until it is strengthened, or less where there are more points than 2000, b(x) being the point of the
 * lattice's boundary that was nearest to p when associate() was called. The boundary is taken as four triangles around
 * the centre of every quadrilateral; d is half a cell's edge, so that a lattice that covers the surface is free. All
 * lengths in units of a cell's edge. */
class SurfaceCoverage
{
public:
  SurfaceCoverage(const LatticeLayout & layout, Positions surfacePoints, unsigned int threads);

  /** Looks for the nearest boundary points. */
  void
  associate(const Eigen::VectorXd & x);

  /** Distance of the farthest surface point when associate() was called [unit]. */
  [[nodiscard]] double
  largestDistance() const;

  /** True when a spring of addEnergy would pull, or nearly so: the surface may drain. */
  [[nodiscard]] bool
  isInDoubt() const;

  /** Multiplies k of the points that were farther away than the tolerance [unit] when associate() was called; returns
   * how many. */
  std::size_t
  strengthen(double tolerance, double factor);

  [[nodiscard]] double
  addEnergy(const Eigen::VectorXd & x, double weight, Eigen::VectorXd & gradient) const;

private:
  /** b(x) = weights[0] x(nodes[0]) + weights[1] x(nodes[1]) + weights[2] times the mean of the quadrilateral's nodes */
  struct Spring
  {
    std::size_t           surfacePoint;
    std::size_t           quad;
    std::size_t           side;
    std::array<double, 3> weights;
  };

  [[nodiscard]] Vector3
  boundaryPoint(const Eigen::VectorXd & x, const Spring & spring) const;

  LatticeLayout              m_Layout;
  Positions                  m_SurfacePoints;
  unsigned int               m_Threads;
  std::vector<Quadrilateral> m_Quads;
  std::vector<double>        m_Distances;
  std::vector<int>           m_Nearest;   ///< triangle of the boundary, by surface point; -1: not yet known
  std::vector<double>        m_Stiffness; ///< k
  std::vector<Spring>        m_Springs;   ///< of points farther away than half of d
};

} // namespace moserhex
