#pragma once

#include "LatticeVector.h"
#include "moserhex/Geometry/UnstructuredHexMesh.h"
#include "moserhex/HexMap/SignedDistance.h"

#include <vector>

namespace moserhex
{

/** What holds the lattice's boundary on the organ's surface without holding it in place: a spring along the normal,
 *
 *   E(x) = w_s / 2 sum over boundary nodes and centres of boundary quadrilaterals of w (s(x) - c)^2
 *   s = phi / |grad phi|
 *
 * with phi and c in units of a cell's edge. The length of the gradient, clamped to [0.3, 2], is frozen by freeze(), so
 * that s needs no second derivative. w is 1 unless strengthen() was called. The centres are held too: nodes alone let
 * quadrilaterals cut off the tips.
 *
 * c is the level at which a lattice of flat-ish quadrilaterals encloses the label's volume. */
class SurfaceAttraction
{
public:
  /** \param phi     in units of a cell's edge, of a point in those units */
  SurfaceAttraction(const LatticeLayout & layout, SignedDistance phi, unsigned int threads);

  void
  setLevel(double level)
  {
    m_Level = level;
  }

  [[nodiscard]] double
  level() const
  {
    return m_Level;
  }

  /** Takes the length of grad phi at the present places. */
  void
  freeze(const Eigen::VectorXd & x);

  /** Energy at x, its gradient added. */
  [[nodiscard]] double
  addEnergy(const Eigen::VectorXd & x, double weight, Eigen::VectorXd & gradient) const;

  /** The level at which the boundary, moved from where it stands to it along the normals, encloses the volume:
   * mean of s + (volume - enclosed volume) / area. */
  [[nodiscard]] double
  levelOfVolume(const Eigen::VectorXd & x, double volume, double enclosedVolume) const;

  /** One Newton step or two of every boundary node onto {s = c}. */
  void
  moveNodesToLevel(Eigen::VectorXd & x) const;

  /** Unit normals at the boundary nodes, in the order of nodes(). */
  [[nodiscard]] std::vector<Vector3>
  normals(const Eigen::VectorXd & x) const;

  /** Boundary nodes in increasing number. */
  [[nodiscard]] const std::vector<std::size_t> &
  nodes() const
  {
    return m_Nodes;
  }

  /** Largest distance of the nodes and the centres to {phi = 0}, along the way of Newton steps [unit]. */
  [[nodiscard]] double
  largestDistance(const Eigen::VectorXd & x) const;

  /** Multiplies w of the springs that are farther from {phi = 0} than the tolerance [unit]; returns their number. */
  std::size_t
  strengthen(const Eigen::VectorXd & x, double tolerance, double factor);

private:
  struct Spring
  {
    double  distance{ 0.0 }; ///< s - c
    Vector3 gradient{ Vector3::Zero() };
  };

  [[nodiscard]] std::size_t
  springCount() const
  {
    return m_Nodes.size() + m_Quads.size();
  }

  [[nodiscard]] Vector3
  place(const Eigen::VectorXd & x, std::size_t spring) const;

  /** To {phi = 0}, of every spring. */
  [[nodiscard]] std::vector<double>
  distances(const Eigen::VectorXd & x) const;

  [[nodiscard]] double
  area(const Eigen::VectorXd & x) const;

  LatticeLayout              m_Layout;
  SignedDistance             m_Phi;
  unsigned int               m_Threads;
  std::vector<std::size_t>   m_Nodes;
  std::vector<Quadrilateral> m_Quads;        ///< around each boundary quadrilateral
  std::vector<double>        m_InverseSlope; ///< 1 / |grad phi|, of the nodes, then the centres
  std::vector<double>        m_Weights;      ///< w of the nodes, then the centres
  double                     m_Level{ 0.0 };
};

} // namespace moserhex
