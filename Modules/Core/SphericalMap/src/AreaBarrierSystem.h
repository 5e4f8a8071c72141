#pragma once

#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/Numerics/BlockCholesky.h"

#include <Eigen/Core>

namespace moserhex
{

/** Energy, gradient and second derivatives of AreaBarrier in tangent coordinates: two unknowns a vertex, in an
 * orthonormal basis of the tangent plane at its present position; a step x moves s to (s + B x) / |s + B x|. */
class AreaBarrierSystem
{
public:
  using Basis = Eigen::Matrix<double, 3, 2>;

  /** Which second derivative a step is made with. */
  enum class Hessian
  {
    GaussNewton, ///< first derivatives only, positive definite; a full step aims at r = 1
    Exact        ///< all second derivatives: quadratic convergence near the minimiser, may be indefinite away from it
  };

  struct Energy
  {
    double value;        ///< infinity when a triangle is flipped
    double areaRatioRms; ///< over triangles [1]
  };

  AreaBarrierSystem(const std::vector<Triangle> & triangles,
                    const TriangleTopology &      topology,
                    const std::vector<double> &   targets,
                    const std::vector<double> &   edgeWeights);

  [[nodiscard]] Energy
  energy(const Positions & sphere, double shapeWeight) const;

  /** Gradient and Hessian at `sphere`. `damping` adds that multiple of the Dirichlet energy's Hessian: soft directions
   * are shortened, the stiff directions of area are still solved. */
  void
  assemble(const Positions & sphere, double shapeWeight, Hessian kind, double damping);

  /** Minus Hessian^-1 gradient of the last assemble, 2 nV [rad]. \throws NotConverged  Hessian not positive definite */
  [[nodiscard]] Eigen::VectorXd
  newtonStep();

  /** dE/dx of the last assemble, 2 nV. */
  [[nodiscard]] const Eigen::VectorXd &
  gradient() const
  {
    return m_Gradient;
  }

  /** The Hessian of the last assemble times x. */
  [[nodiscard]] Eigen::VectorXd
  hessianTimes(const Eigen::VectorXd & x) const;

  [[nodiscard]] const std::vector<Basis> &
  bases() const
  {
    return m_Bases;
  }

  /** Positions after the step length * step from where assemble was called. */
  [[nodiscard]] Positions
  moved(const Positions & sphere, const Eigen::VectorXd & step, double length) const;

  [[nodiscard]] const std::vector<Triangle> &
  triangles() const
  {
    return m_Triangles;
  }

private:
  void
  assembleShape(const Positions & sphere, double shapeWeight, Hessian kind, double damping);
  void
  assembleAreas(const Positions & sphere, Hessian kind);
  void
  addShift(double relativeShift);

  std::vector<Triangle>           m_Triangles;
  std::vector<Edge>               m_Edges;
  std::vector<std::array<int, 3>> m_TriangleEdges;
  std::vector<double>             m_Targets;
  std::vector<double>             m_Weights;

  std::vector<Basis>         m_Bases;
  Eigen::VectorXd            m_Gradient;
  BlockCholesky::BlockVector m_Diagonal; ///< nV
  BlockCholesky::BlockVector m_Coupling; ///< nE: rows are the edge's first vertex
  BlockCholesky              m_Cholesky;
};

} // namespace moserhex
