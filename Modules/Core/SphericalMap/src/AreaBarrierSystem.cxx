#include "AreaBarrierSystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace moserhex
{
namespace
{

using Matrix2 = Eigen::Matrix2d;
using Vector2 = Eigen::Vector2d;

AreaBarrierSystem::Basis
tangentBasis(const Vector3 & s)
{
  const Vector3            helper = std::abs(s[0]) < 0.6 ? Vector3::UnitX() : Vector3::UnitY();
  AreaBarrierSystem::Basis basis;
  basis.col(0) = s.cross(helper).normalized();
  basis.col(1) = s.cross(basis.col(0));
  return basis;
}

/** N = a.(b x c), D = 1 + a.b + b.c + c.a and Omega = 2 atan2(N, D) of a spherical triangle with the derivatives that
 * the energy needs, in tangent coordinates. */
struct TriangleTerms
{
  double                 solidAngle;
  double                 dOmegadN;
  double                 dOmegadD;
  double                 d2OmegadNN; ///< = - d2Omega/dDD
  double                 d2OmegadND;
  std::array<Vector2, 3> dN;
  std::array<Vector2, 3> dD;
  std::array<Vector2, 3> dOmega;
  std::array<double, 3>  radial; ///< derivative of Omega along the corner itself

  TriangleTerms(const std::array<Vector3, 3> & s, const std::array<AreaBarrierSystem::Basis, 3> & basis)
  {
    const std::array<Vector3, 3> gradientN{ s[1].cross(s[2]), s[2].cross(s[0]), s[0].cross(s[1]) };
    const std::array<Vector3, 3> gradientD{ s[1] + s[2], s[2] + s[0], s[0] + s[1] };
    const double                 N = s[0].dot(gradientN[0]);
    const double                 D = 1.0 + s[0].dot(s[1]) + s[1].dot(s[2]) + s[2].dot(s[0]);
    const double                 squares = N * N + D * D;
    solidAngle = 2.0 * std::atan2(N, D);
    dOmegadN = 2.0 * D / squares;
    dOmegadD = -2.0 * N / squares;
    d2OmegadNN = -4.0 * N * D / (squares * squares);
    d2OmegadND = 2.0 * (N * N - D * D) / (squares * squares);
    for (int k = 0; k < 3; ++k)
    {
      dN[k] = basis[k].transpose() * gradientN[k];
      dD[k] = basis[k].transpose() * gradientD[k];
      dOmega[k] = dOmegadN * dN[k] + dOmegadD * dD[k];
      radial[k] = dOmegadN * N + dOmegadD * s[k].dot(gradientD[k]);
    }
  }

  /** Part of the second derivative that comes from first derivatives of N and D, corners k and l. */
  [[nodiscard]] Matrix2
  outerPart(int k, int l) const
  {
    return d2OmegadNN * (dN[k] * dN[l].transpose() - dD[k] * dD[l].transpose()) +
           d2OmegadND * (dN[k] * dD[l].transpose() + dD[k] * dN[l].transpose());
  }
};

/** N is linear in each corner, x . (y x c) between corner x and the next one y; D gives x . y. */
Matrix3
mixedDerivative(const TriangleTerms & terms, const Vector3 & c)
{
  Matrix3 mixed;
  mixed << 0.0, c[2], -c[1], -c[2], 0.0, c[0], c[1], -c[0], 0.0;
  mixed *= terms.dOmegadN;
  mixed.diagonal().array() += terms.dOmegadD;
  return mixed;
}

} // namespace

AreaBarrierSystem::AreaBarrierSystem(const std::vector<Triangle> & triangles,
                                     const TriangleTopology &      topology,
                                     const std::vector<double> &   targets,
                                     const std::vector<double> &   edgeWeights)
  : m_Triangles(triangles)
  , m_Edges(topology.edges)
  , m_TriangleEdges(topology.triangleEdges)
  , m_Targets(targets)
  , m_Weights(edgeWeights)
  , m_Bases(topology.vertexTriangle.size())
  , m_Diagonal(topology.vertexTriangle.size())
  , m_Coupling(topology.edges.size())
{
  m_Cholesky.analyzePattern(m_Diagonal.size(), m_Edges);
}

AreaBarrierSystem::Energy
AreaBarrierSystem::energy(const Positions & sphere, double shapeWeight) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double           areaTerm = 0.0;
  double           squares = 0.0;
  for (std::size_t f = 0; f < m_Triangles.size(); ++f)
  {
    const Vector3 & a = sphere[m_Triangles[f][0]];
    const Vector3 & b = sphere[m_Triangles[f][1]];
    const Vector3 & c = sphere[m_Triangles[f][2]];
    const double    N = a.dot(b.cross(c));
    if (!(N > 0.0))
    {
      return { infinity, infinity };
    }
    const double ratio = 2.0 * std::atan2(N, 1.0 + a.dot(b) + b.dot(c) + c.dot(a)) / m_Targets[f];
    const double square = (ratio - 1.0) * (ratio - 1.0);
    areaTerm += 0.5 * m_Targets[f] * square / ratio; // r + 1/r - 2 = (r-1)^2 / r
    squares += m_Targets[f] * square;
  }
  double shapeTerm = 0.0;
  for (std::size_t e = 0; e < m_Edges.size(); ++e)
  {
    const double squaredChord = (sphere[m_Edges[e][0]] - sphere[m_Edges[e][1]]).squaredNorm();
    shapeTerm += m_Weights[e] * squaredChord / (2.0 - 0.5 * squaredChord);
  }
  return { areaTerm + shapeWeight * shapeTerm, std::sqrt(squares / (4.0 * pi)) };
}

void
AreaBarrierSystem::assemble(const Positions & sphere, double shapeWeight, Hessian kind, double damping)
{
  std::transform(sphere.begin(), sphere.end(), m_Bases.begin(), tangentBasis);
  m_Gradient.setZero(static_cast<Eigen::Index>(2 * sphere.size()));
  std::fill(m_Diagonal.begin(), m_Diagonal.end(), Matrix2::Zero());
  assembleShape(sphere, shapeWeight, kind, damping);
  assembleAreas(sphere, kind);
  // A smaller shift where the step must be exact: see addShift.
  addShift(kind == Hessian::Exact ? 1e-10 : 1e-9);
}

/** Shape energy q(c) = 2 (1 - c) / (1 + c) = 2 tan^2(angle / 2) of every edge, c = s_i . s_j. Its second derivative
 * along the tangent at i has the part -q'(c) c; Gauss-Newton takes -q'(c) instead, which keeps the matrix positive. */
void
AreaBarrierSystem::assembleShape(const Positions & sphere, double shapeWeight, Hessian kind, double damping)
{
  const bool exact = kind == Hessian::Exact;
  for (std::size_t e = 0; e < m_Edges.size(); ++e)
  {
    const VertexIndex i = m_Edges[e][0];
    const VertexIndex j = m_Edges[e][1];
    const Vector3     chord = sphere[i] - sphere[j];
    const double      cosinePlusOne = 2.0 - 0.5 * chord.squaredNorm();
    const double      stiffness = 4.0 * shapeWeight * m_Weights[e] / (cosinePlusOne * cosinePlusOne); // -q'
    const double      growth = 2.0 * stiffness / cosinePlusOne;                                       // q''
    const double      extra = damping * m_Weights[e];
    const Vector2     towardsJ = -m_Bases[i].transpose() * chord;
    const Vector2     towardsI = m_Bases[j].transpose() * chord;
    m_Gradient.segment<2>(2 * i) -= stiffness * towardsJ;
    m_Gradient.segment<2>(2 * j) -= stiffness * towardsI;

    const double diagonal = (exact ? stiffness * (cosinePlusOne - 1.0) : stiffness) + extra;
    m_Diagonal[i] += growth * towardsJ * towardsJ.transpose() + diagonal * Matrix2::Identity();
    m_Diagonal[j] += growth * towardsI * towardsI.transpose() + diagonal * Matrix2::Identity();
    m_Coupling[e] =
      growth * towardsJ * towardsI.transpose() - (stiffness + extra) * (m_Bases[i].transpose() * m_Bases[j]);
  }
}

/** Barrier phi(r) = (r + 1/r - 2) / 2 of every triangle. The Gauss-Newton weight is phi'(r) / (r - 1) and not phi''(r):
 * then a full step aims at r = 1, and large distortions take a third of the steps. */
void
AreaBarrierSystem::assembleAreas(const Positions & sphere, Hessian kind)
{
  const bool exact = kind == Hessian::Exact;
  for (std::size_t f = 0; f < m_Triangles.size(); ++f)
  {
    const Triangle &             t = m_Triangles[f];
    const std::array<Vector3, 3> s{ sphere[t[0]], sphere[t[1]], sphere[t[2]] };
    const std::array<Basis, 3>   basis{ m_Bases[t[0]], m_Bases[t[1]], m_Bases[t[2]] };
    const TriangleTerms          terms(s, basis);
    const double                 ratio = terms.solidAngle / m_Targets[f];
    const double                 slope = 0.5 * (1.0 - 1.0 / (ratio * ratio));
    const double curvature = exact ? 1.0 / (ratio * ratio * ratio) : 0.5 * (1.0 + ratio) / (ratio * ratio);
    const double weight = curvature / m_Targets[f];
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      m_Gradient.segment<2>(2 * t[k]) += slope * terms.dOmega[k];
      Matrix2 diagonal = weight * terms.dOmega[k] * terms.dOmega[k].transpose();
      Matrix2 coupling = weight * terms.dOmega[k] * terms.dOmega[l].transpose();
      if (exact)
      {
        // Moving along the tangent and scaling back to length 1 lowers s by |x|^2 / 2: the radial term.
        diagonal += slope * (terms.outerPart(k, k) - terms.radial[k] * Matrix2::Identity());
        coupling += slope * (terms.outerPart(k, l) + basis[k].transpose() * mixedDerivative(terms, s[m]) * basis[l]);
      }
      m_Diagonal[t[k]] += diagonal;
      const int  edge = m_TriangleEdges[f][k];
      const bool along = t[k] == m_Edges[edge][0];
      m_Coupling[edge] += along ? coupling : Matrix2(coupling.transpose());
    }
  }
}

/** A multiple of the mean diagonal on the diagonal: rotations of the whole sphere change nothing, so without it the
 * Hessian is singular. The gradient has no part along rotations, so the step feels the shift only by its size relative
 * to the softest other direction. */
void
AreaBarrierSystem::addShift(double relativeShift)
{
  double trace = 0.0;
  for (const Matrix2 & block : m_Diagonal)
  {
    trace += block.trace();
  }
  const double shift = relativeShift * trace / static_cast<double>(2 * m_Diagonal.size());
  for (Matrix2 & block : m_Diagonal)
  {
    block.diagonal().array() += shift;
  }
}

Eigen::VectorXd
AreaBarrierSystem::newtonStep()
{
  m_Cholesky.factorize(m_Diagonal, m_Coupling);
  return m_Cholesky.solve(-m_Gradient);
}

Eigen::VectorXd
AreaBarrierSystem::hessianTimes(const Eigen::VectorXd & x) const
{
  Eigen::VectorXd y(x.size());
  for (std::size_t v = 0; v < m_Diagonal.size(); ++v)
  {
    const auto at = static_cast<Eigen::Index>(2 * v);
    y.segment<2>(at) = m_Diagonal[v] * x.segment<2>(at);
  }
  for (std::size_t e = 0; e < m_Edges.size(); ++e)
  {
    const Eigen::Index i = 2 * m_Edges[e][0];
    const Eigen::Index j = 2 * m_Edges[e][1];
    y.segment<2>(i) += m_Coupling[e] * x.segment<2>(j);
    y.segment<2>(j) += m_Coupling[e].transpose() * x.segment<2>(i);
  }
  return y;
}

Positions
AreaBarrierSystem::moved(const Positions & sphere, const Eigen::VectorXd & step, double length) const
{
  Positions result(sphere.size());
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    const Vector3 move = m_Bases[v] * step.segment<2>(static_cast<Eigen::Index>(2 * v));
    result[v] = (sphere[v] + length * move).normalized();
  }
  return result;
}

} // namespace moserhex
