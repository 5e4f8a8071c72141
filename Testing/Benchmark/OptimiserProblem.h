#pragma once

#include "LatticeOptimiser.h"
#include "ShapeHessian.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <memory>
#include <string>

namespace moserhex::optimisers
{

/** An organ and the lattice that every method starts from. */
struct Case
{
  std::string               name;
  HexMesh                   start;
  std::shared_ptr<LevelSet> phi; ///< negative inside [mm]
  double                    volume{ 0.0 };
};

/** The energy of stage J on one lattice of a case, its Gauss-Newton Hessian and its preconditioners. The lengths of
 * phi's gradient and the level are frozen where it is made; surface points are not looked for. In units of a mean
 * cell's edge.
 */
class Problem
{
public:
  Problem(const Case & organ, const HexMesh & lattice);
  Problem(const Problem &) = delete; // the energy refers to phi's interpolator
  Problem &
  operator=(const Problem &) = delete;

  [[nodiscard]] const Eigen::VectorXd &
  start() const
  {
    return m_Start;
  }

  /** E and its gradient; counts. */
  [[nodiscard]] double
  energy(const Eigen::VectorXd & x, const EqualisationStage & stage, Eigen::VectorXd & gradient);

  /** The Gauss-Newton Hessian at x times a vector; counts. Springs count with the unit normal, as if phi were a
   * distance, and the normals are those of the last linearise(). */
  [[nodiscard]] Eigen::VectorXd
  hessianProduct(const Eigen::VectorXd & x, const EqualisationStage & stage, const Eigen::VectorXd & direction);

  /** Takes the normals at x. */
  void
  linearise(const Eigen::VectorXd & x);

  /** (L + 0.3)^-1 by cosine transforms, as the product uses. */
  void
  solveLaplacian(Eigen::VectorXd & v) const;

  /** The inverses of the Hessian's 3x3 diagonal blocks at x. */
  [[nodiscard]] PreconditionerInPlace
  blockJacobi(const Eigen::VectorXd & x, const EqualisationStage & stage);

  [[nodiscard]] HexMesh
  mesh(const Eigen::VectorXd & x) const;

  /** Of a mesh of the same size. */
  [[nodiscard]] Eigen::VectorXd
  vectorOf(const HexMesh & mesh) const
  {
    return latticeVector(m_Layout, mesh.nodes, m_Origin, m_Unit);
  }

  /** Boundary nodes onto the level, after a prolongation. */
  void
  moveBoundaryToLevel(Eigen::VectorXd & x) const
  {
    m_Optimiser.attraction().moveNodesToLevel(x);
  }

  [[nodiscard]] int
  evaluations() const
  {
    return m_Evaluations;
  }

  [[nodiscard]] int
  hessianProducts() const
  {
    return m_HessianProducts;
  }

private:
  CubicInterpolator                       m_Phi;
  Vector3                                 m_Origin;
  double                                  m_Unit;
  LatticeOptimiser                        m_Optimiser;
  LatticeLayout                           m_Layout;
  SpectralOperator                        m_InverseLaplacian;
  Eigen::VectorXd                         m_Targets;
  std::vector<std::array<std::size_t, 4>> m_Quads;
  Eigen::VectorXd                         m_Start;
  std::vector<Vector3>                    m_NodeNormals;
  std::vector<Vector3>                    m_QuadNormals;
  int                                     m_Evaluations{ 0 };
  int                                     m_HessianProducts{ 0 };
};

} // namespace moserhex::optimisers
