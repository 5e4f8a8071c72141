#include "moserhex/HexMap/EqualMeasureProjection.h"

#include "EmbeddedOperator.h"
#include "SurfaceAttraction.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace moserhex
{
namespace
{
using Vector = Eigen::VectorXd;

/** VTK_HEXAHEDRON corner of the corner with bits (i,j,k). */
constexpr std::array<std::size_t, 8> vtkCorner{ 0, 1, 3, 2, 4, 5, 7, 6 };

constexpr int    maximumHalvings = 2;
constexpr double tightestSolverTolerance = 1e-10;
constexpr double loosestSolverTolerance = 1e-2;

/** A step that lowers the mean square by less than this factor below `roundOff` is the end of what doubles can do. */
constexpr double roundOffDeviation = 1e-18;

void
requireArguments(const EqualMeasureOptions & options, double target, const SignedDistance & phi)
{
  const auto require = [](bool holds, const std::string & what) {
    if (!holds)
    {
      throw InvalidInput("equal-measure projection: " + what);
    }
  };
  require(static_cast<bool>(phi), "a surface is needed");
  require(target > 0.0 && std::isfinite(target), "the target must be positive and finite");
  require(options.tolerance > 0.0 && std::isfinite(options.tolerance), "the tolerance must be positive and finite");
  require(options.maximumSteps >= 0 && options.maximumSolverSteps >= 1, "numbers of steps out of range");
  require(options.normalMotion > 0.0 && options.normalMotion <= 1.0, "normal motion must be in (0,1]");
  require(options.shift > 0.0 && std::isfinite(options.shift), "the shift must be positive and finite");
}

/** The inverse of A M A^T on the uniform lattice with unit cells. */
EmbeddedOperator
uniformInverse(const LatticeLayout & layout, double shift)
{
  const int  cells = layout.nodesPerSide - 1 + 2 * layout.paddingLayers;
  const auto difference = laplacianEigenvalues(cells, CubeTransform::Basis::Sine);
  const auto mean = [&](int a) { return 1.0 - 0.25 * difference[a]; };
  const auto symbol = [&](int a, int b, int c) {
    const double sum = difference[a] + difference[b] + difference[c] + shift;
    return sum /
           (difference[a] * mean(b) * mean(c) + mean(a) * difference[b] * mean(c) + mean(a) * mean(b) * difference[c]);
  };
  return { SpectralOperator(CubeTransform(cells, CubeTransform::Basis::Sine), symbol), placesOfCells(layout) };
}

/** A M A^T at one mesh. Displacements in units of a cell's edge, measures relative to the target. */
class NormalEquations
{
public:
  NormalEquations(const LatticeLayout & layout, const EqualMeasureOptions & options)
    : m_Layout(layout)
    , m_Options(options)
    , m_Smoother(inverseNodeLaplacian(layout, options.shift))
    , m_Preconditioner(uniformInverse(layout, options.shift))
  {}

  void
  linearise(CellGradients gradients, const std::vector<std::size_t> & boundaryNodes, std::vector<Vector3> normals)
  {
    m_Gradients = std::move(gradients);
    m_BoundaryNodes = &boundaryNodes;
    m_Normals = std::move(normals);
  }

  /** M A^T y. */
  [[nodiscard]] Vector
  displacement(const Vector & y) const
  {
    Vector x = Vector::Zero(m_Layout.size());
    forEachCell([&](std::size_t cell, const CellNodes & nodes) {
      const double * gradient = m_Gradients.col(static_cast<Eigen::Index>(cell)).data();
      const double   factor = y[static_cast<Eigen::Index>(cell)];
      for (std::size_t a = 0; a < 8; ++a)
      {
        const double * g = gradient + 3 * vtkCorner[a];
        m_Layout.add(x, nodes[a], factor * Vector3(g[0], g[1], g[2]));
      }
    });
    dampNormalMotion(x);
    m_Smoother.applyInPlace(componentsOf(m_Layout, x), m_Options.threads);
    dampNormalMotion(x);
    return x;
  }

  /** A x. */
  [[nodiscard]] Vector
  change(const Vector & x) const
  {
    Vector result(m_Gradients.cols());
    forEachCell([&](std::size_t cell, const CellNodes & nodes) {
      const double * gradient = m_Gradients.col(static_cast<Eigen::Index>(cell)).data();
      double         sum = 0.0;
      for (std::size_t a = 0; a < 8; ++a)
      {
        const double * g = gradient + 3 * vtkCorner[a];
        sum += m_Layout.at(x, nodes[a]).dot(Vector3(g[0], g[1], g[2]));
      }
      result[static_cast<Eigen::Index>(cell)] = sum;
    });
    return result;
  }

  /** y with A M A^T y = r to the relative tolerance; returns the steps made. */
  int
  solve(Vector r, double tolerance, Vector & y) const
  {
    y = Vector::Zero(r.size());
    const double goal = tolerance * r.norm();
    Vector       z = preconditioned(r);
    Vector       direction = z;
    double       rz = r.dot(z);
    int          step = 0;
    while (step < m_Options.maximumSolverSteps)
    {
      ++step;
      const Vector image = change(displacement(direction));
      const double alpha = rz / direction.dot(image);
      y += alpha * direction;
      r -= alpha * image;
      if (!(r.norm() > goal))
      {
        break;
      }
      z = preconditioned(r);
      const double next = r.dot(z);
      direction = z + (next / rz) * direction;
      rz = next;
    }
    return step;
  }

private:
  template <typename TBody>
  void
  forEachCell(TBody body) const
  {
    const auto cells = static_cast<std::size_t>(m_Layout.nodesPerSide - 1);
    forEachSlab(m_Layout, m_Options.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
      const std::size_t layer = (cells + 1) * (cells + 1);
      for (std::size_t k = begin / layer; k * layer < end && k < cells; ++k)
      {
        for (std::size_t cell = cells * cells * k; cell < cells * cells * (k + 1); ++cell)
        {
          body(cell, m_Layout.cellNodes(cell));
        }
      }
    });
    for (std::size_t pillow = 0; pillow < m_Layout.pillowCells.size(); ++pillow)
    {
      body(m_Layout.latticeCellCount() + pillow, m_Layout.pillowCells[pillow]);
    }
  }

  void
  dampNormalMotion(Vector & x) const
  {
    for (std::size_t b = 0; b < m_Normals.size(); ++b)
    {
      const std::size_t node = (*m_BoundaryNodes)[b];
      const double      along = m_Normals[b].dot(m_Layout.at(x, node));
      m_Layout.add(x, node, (m_Options.normalMotion - 1.0) * along * m_Normals[b]);
    }
  }

  [[nodiscard]] Vector
  preconditioned(Vector r) const
  {
    m_Preconditioner.applyInPlace(r, m_Options.threads);
    return r;
  }

  LatticeLayout                    m_Layout;
  EqualMeasureOptions              m_Options;
  EmbeddedOperator                 m_Smoother;
  EmbeddedOperator                 m_Preconditioner;
  CellGradients                    m_Gradients;
  const std::vector<std::size_t> * m_BoundaryNodes{ nullptr };
  std::vector<Vector3>             m_Normals;
};

/** measure / target - 1, negated: what is missing. */
Vector
missing(const std::vector<double> & measures, double target)
{
  Vector r(static_cast<Eigen::Index>(measures.size()));
  for (std::size_t cell = 0; cell < measures.size(); ++cell)
  {
    r[static_cast<Eigen::Index>(cell)] = 1.0 - measures[cell] / target;
  }
  return r;
}

/** Corners of cells with det J <= 0, or not a number. */
std::size_t
nonPositiveCorners(const HexMesh & mesh)
{
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    for (const double jacobian : cornerJacobians(cellCorners(mesh, cell)))
    {
      count += jacobian > 0.0 ? 0 : 1;
    }
  }
  return count;
}

HexMesh
moved(const LatticeLayout & layout, const HexMesh & mesh, const Vector & displacement, double unit)
{
  HexMesh result = mesh;
  for (std::size_t node = 0; node < result.nodes.size(); ++node)
  {
    result.nodes[node] += unit * layout.at(displacement, node);
  }
  return result;
}

/** What is to be said of a mesh that is not equal, or that has more corners turned over than the one given. */
std::string
noteOf(const EqualMeasureResult & result, std::size_t nonPositiveBefore, double tolerance)
{
  std::ostringstream note;
  if (!result.report.converged)
  {
    note << "mean square deviation of the measures " << result.report.residual << " after " << result.report.steps
         << " Newton steps, tolerance " << tolerance;
  }
  if (result.nonPositiveCorners > nonPositiveBefore)
  {
    note << (result.report.converged ? "" : "; ") << "non-positive corners of cells: " << nonPositiveBefore
         << " before, " << result.nonPositiveCorners << " after";
  }
  return note.str();
}

} // namespace

EqualMeasureResult
projectOntoEqualMeasure(const HexMesh &             mesh,
                        const CellMeasure &         measure,
                        double                      target,
                        const SignedDistance &      phi,
                        const EqualMeasureOptions & options,
                        const ProgressCallback &    progress)
{
  requireArguments(options, target, phi);
  requireValid(mesh);
  const Stopwatch     stopwatch;
  const LatticeLayout layout(mesh.nodesPerSide, mesh.paddingLayers);
  SurfaceAttraction   boundary(layout, phi, options.threads);
  NormalEquations     equations(layout, options);

  // Any length will do as unit; the edge of a mean cell makes A M A^T that of the uniform lattice.
  const std::vector<double> volumes = cellVolumes(mesh);
  const double              total = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  const double              unit = std::cbrt(std::abs(total) / static_cast<double>(mesh.cellCount()));

  EqualMeasureResult result;
  HexMesh            present = mesh;
  double             best = 0.0;
  const std::size_t  nonPositiveBefore = nonPositiveCorners(mesh);
  std::size_t        nonPositive = nonPositiveBefore;
  for (int step = 0;; ++step)
  {
    std::vector<double> measures;
    CellGradients       gradients;
    measure.evaluate(present, options.threads, measures, &gradients);
    const Vector residual = missing(measures, target);
    const double deviation = residual.squaredNorm() / static_cast<double>(residual.size());
    const bool   stalled = step > 0 && best < roundOffDeviation && deviation > 0.25 * best;
    if (step == 0 || deviation < best)
    {
      best = deviation;
      result.mesh = present;
      result.nonPositiveCorners = nonPositive;
    }
    result.report.converged = best < options.tolerance || stalled;
    if (result.report.converged || step == options.maximumSteps || !std::isfinite(deviation))
    {
      break;
    }
    reportProgress(progress, static_cast<double>(step) / options.maximumSteps);

    equations.linearise(gradients * (unit / target),
                        boundary.nodes(),
                        boundary.normals(latticeVector(layout, present.nodes, Vector3::Zero(), 1.0)));
    EqualMeasureStep taken;
    taken.deviation = deviation;
    Vector y;
    taken.solverSteps = equations.solve(
      residual, std::max(tightestSolverTolerance, std::min(loosestSolverTolerance, std::sqrt(deviation))), y);
    const Vector displacement = equations.displacement(y);
    HexMesh      trial = moved(layout, present, displacement, unit);
    std::size_t  trialNonPositive = nonPositiveCorners(trial);
    for (int halving = 0; halving < maximumHalvings && trialNonPositive > nonPositive; ++halving)
    {
      taken.fraction *= 0.5;
      trial = moved(layout, present, taken.fraction * displacement, unit);
      trialNonPositive = nonPositiveCorners(trial);
    }
    present = std::move(trial);
    nonPositive = trialNonPositive;
    result.steps.push_back(taken);
  }
  result.report.steps = static_cast<int>(result.steps.size());
  result.report.residual = best;
  result.report.seconds = stopwatch.seconds();
  result.report.note = noteOf(result, nonPositiveBefore, options.tolerance);
  return result;
}

} // namespace moserhex
