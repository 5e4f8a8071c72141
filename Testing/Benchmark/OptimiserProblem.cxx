#include "OptimiserProblem.h"

#include "moserhex/Geometry/HexMeshNumbering.h"

#include <Eigen/LU>

#include <cmath>

namespace moserhex::optimisers
{
namespace
{
constexpr unsigned int threads = 1;
constexpr double       laplacianShift = 0.3;

Vector3
centroid(const Positions & nodes)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3 & node : nodes)
  {
    sum += node;
  }
  return sum / static_cast<double>(nodes.size());
}

SignedDistance
scaled(const CubicInterpolator & phi, const Vector3 & origin, double unit)
{
  return [&phi, origin, unit](const Vector3 & p, Vector3 & gradient) {
    const ValueAndGradient at = phi.at(origin + unit * p);
    gradient = at.gradient;
    return at.value / unit;
  };
}
} // namespace

Problem::Problem(const Case & organ, const HexMesh & lattice)
  : m_Phi(*organ.phi)
  , m_Origin(centroid(lattice.nodes))
  , m_Unit(std::cbrt(organ.volume / static_cast<double>(lattice.cellCount())))
  , m_Optimiser(LatticeLayout(lattice.nodesPerSide),
                scaled(m_Phi, m_Origin, m_Unit),
                {},
                static_cast<double>(lattice.cellCount()),
                threads)
  , m_Layout(lattice.nodesPerSide)
  , m_InverseLaplacian(functionOfLaplacian(lattice.nodesPerSide,
                                           CubeTransform::Basis::Cosine,
                                           [](double eigenvalue) { return 1.0 / (eigenvalue + laplacianShift); }))
  , m_Targets(unitTargetVolumes(m_Layout))
  , m_Quads(boundaryQuads(lattice))
  , m_Start(latticeVector(m_Layout, lattice.nodes, m_Origin, m_Unit))
{
  m_Optimiser.attraction().freeze(m_Start);
  m_Optimiser.updateLevel(m_Start);
  linearise(m_Start);
}

double
Problem::energy(const Eigen::VectorXd & x, const EqualisationStage & stage, Eigen::VectorXd & gradient)
{
  ++m_Evaluations;
  return m_Optimiser.energy(x, stage, gradient);
}

void
Problem::linearise(const Eigen::VectorXd & x)
{
  m_NodeNormals = m_Optimiser.attraction().normals(x);
  m_QuadNormals.clear();
  for (const auto & quad : m_Quads)
  {
    const Vector3 centre =
      0.25 * (m_Layout.at(x, quad[0]) + m_Layout.at(x, quad[1]) + m_Layout.at(x, quad[2]) + m_Layout.at(x, quad[3]));
    m_QuadNormals.push_back(m_Phi.at(m_Origin + m_Unit * centre).gradient.normalized());
  }
}

Eigen::VectorXd
Problem::hessianProduct(const Eigen::VectorXd & x, const EqualisationStage & stage, const Eigen::VectorXd & direction)
{
  ++m_HessianProducts;
  Eigen::VectorXd          product = Eigen::VectorXd::Zero(m_Layout.size());
  const ShapeEnergyWeights weights{ stage.regularisation, stage.volumeWeight, stage.power };
  addShapeHessianProduct(m_Layout, x, direction, m_Targets, weights, HessianForm::GaussNewton, threads, product);
  const std::vector<std::size_t> & nodes = m_Optimiser.attraction().nodes();
  for (std::size_t s = 0; s < nodes.size(); ++s)
  {
    const Vector3 & normal = m_NodeNormals[s];
    m_Layout.add(product, nodes[s], stage.surfaceWeight * normal.dot(m_Layout.at(direction, nodes[s])) * normal);
  }
  for (std::size_t s = 0; s < m_Quads.size(); ++s)
  {
    const Vector3 & normal = m_QuadNormals[s];
    double          change = 0.0;
    for (const std::size_t node : m_Quads[s])
    {
      change += 0.25 * normal.dot(m_Layout.at(direction, node));
    }
    for (const std::size_t node : m_Quads[s])
    {
      m_Layout.add(product, node, 0.25 * stage.surfaceWeight * change * normal);
    }
  }
  return product;
}

void
Problem::solveLaplacian(Eigen::VectorXd & v) const
{
  m_InverseLaplacian.applyToColumnsInPlace(Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>(
                                             v.data(),
                                             static_cast<Eigen::Index>(m_Layout.nodes),
                                             3,
                                             Eigen::OuterStride<>(static_cast<Eigen::Index>(m_Layout.stride))),
                                           threads);
}

PreconditionerInPlace
Problem::blockJacobi(const Eigen::VectorXd & x, const EqualisationStage & stage)
{
  // Nodes are coupled when they share a cell: nodes two apart in every direction are not, so that one product gives a
  // column of all of their blocks at once.
  std::vector<Matrix3> blocks(m_Layout.nodes, Matrix3::Zero());
  const int            n = m_Layout.nodesPerSide;
  for (int colour = 0; colour < 8; ++colour)
  {
    std::vector<std::size_t> nodes;
    for (int k = colour >> 2; k < n; k += 2)
    {
      for (int j = colour >> 1 & 1; j < n; j += 2)
      {
        for (int i = colour & 1; i < n; i += 2)
        {
          nodes.push_back(m_Layout.node(i, j, k));
        }
      }
    }
    for (int component = 0; component < 3; ++component)
    {
      Eigen::VectorXd probe = Eigen::VectorXd::Zero(m_Layout.size());
      for (const std::size_t node : nodes)
      {
        m_Layout.add(probe, node, Vector3::Unit(component));
      }
      const Eigen::VectorXd product = hessianProduct(x, stage, probe);
      for (const std::size_t node : nodes)
      {
        blocks[node].col(component) = m_Layout.at(product, node);
      }
    }
  }
  for (Matrix3 & block : blocks)
  {
    block = block.inverse().eval();
  }
  return [blocks = std::move(blocks), layout = m_Layout](Eigen::VectorXd & v) {
    for (std::size_t node = 0; node < layout.nodes; ++node)
    {
      const Vector3 value = layout.at(v, node);
      layout.add(v, node, blocks[node] * value - value);
    }
  };
}

HexMesh
Problem::mesh(const Eigen::VectorXd & x) const
{
  return { m_Layout.nodesPerSide, latticePositions(m_Layout, x, m_Origin, m_Unit) };
}

} // namespace moserhex::optimisers
