#include "moserhex/SphericalMap/MoserAreaFlow.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"
#include "moserhex/Numerics/SparseCholesky.h"
#include "moserhex/SphericalMap/SphereLocator.h"
#include "moserhex/SphericalMap/SphereMapQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace moserhex
{
namespace
{

constexpr int largestStepCount = 512;

Vector3
tangentPart(const Vector3 & v, const Vector3 & s)
{
  return v - v.dot(s) * s;
}

std::vector<double>
solidAngles(const std::vector<Triangle> & triangles, const Positions & sphere)
{
  std::vector<double> result;
  result.reserve(triangles.size());
  for (const Triangle & t : triangles)
  {
    result.push_back(signedSolidAngle(sphere[t[0]], sphere[t[1]], sphere[t[2]]));
  }
  return result;
}

/** A third of each triangle's value for each of its vertices. */
std::vector<double>
vertexShares(const std::vector<Triangle> & triangles, const std::vector<double> & values, std::size_t vertexCount)
{
  std::vector<double> shares(vertexCount, 0.0);
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    for (const VertexIndex v : triangles[f])
    {
      shares[v] += values[f] / 3.0;
    }
  }
  return shares;
}

double
areaRatioRms(const std::vector<Triangle> & triangles, const Positions & sphere, const std::vector<double> & targets)
{
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    const Triangle & t = triangles[f];
    const double     ratio = signedSolidAngle(sphere[t[0]], sphere[t[1]], sphere[t[2]]) / targets[f];
    squares += targets[f] * (ratio - 1.0) * (ratio - 1.0);
    sum += targets[f];
  }
  return std::sqrt(squares / sum);
}

/** The flow on one fixed triangulation; the pattern of the Laplacian is analysed once for all passes. */
class Flow
{
public:
  Flow(const std::vector<Triangle> & triangles, const Positions & sphere)
    : m_Triangles(triangles), m_Topology(triangleTopology({ sphere, triangles }))
  {}

  MoserAreaFlowResult
  pass(const Positions & sphere, std::vector<double> density, int steps, bool localBrake);

private:
  void
  prepareField(const Positions & sphere, std::vector<double> density);
  void
  solvePotential(const Positions & sphere);
  void
  averageGradient(const Positions & sphere);
  [[nodiscard]] Vector3
  velocity(const SphereLocator & locator, const Vector3 & p, double t, int & triangle) const;
  [[nodiscard]] Vector3
  rungeKuttaStep(const SphereLocator & locator, const Vector3 & p, double t, double dt, int & triangle) const;
  [[nodiscard]] bool
  brake(Positions & moved, const Positions & before) const;

  const std::vector<Triangle> & m_Triangles;
  TriangleTopology              m_Topology;
  SparseCholesky                m_Cholesky;
  bool                          m_Analysed{ false };
  std::vector<double>           m_SolidAngle; ///< of vertices, present
  std::vector<double>           m_Density;    ///< mu
  Eigen::VectorXd               m_Potential;  ///< theta
  Positions                     m_Gradient;   ///< grad theta at the vertices
};

void
Flow::solvePotential(const Positions & sphere)
{
  // Weak form with L = -Lap: L theta = integral of (mu - 1) over the vertex' share of the sphere.
  Eigen::MatrixXd rightHandSide(static_cast<Eigen::Index>(sphere.size()), 1);
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    rightHandSide(static_cast<Eigen::Index>(v), 0) = (m_Density[v] - 1.0) * m_SolidAngle[v];
  }
  SparseMatrix laplacian =
    weightedLaplacian(m_Topology, cotanWeights({ sphere, m_Triangles }, m_Topology), sphere.size());
  laplacian.coeffRef(0, 0) += 1.0; // pins the constant
  if (!m_Analysed)
  {
    m_Cholesky.analyzePattern(laplacian);
    m_Analysed = true;
  }
  m_Cholesky.factorize(laplacian);
  m_Potential = m_Cholesky.solve(rightHandSide);
}

void
Flow::averageGradient(const Positions & sphere)
{
  m_Gradient.assign(sphere.size(), Vector3::Zero());
  std::vector<double> weight(sphere.size(), 0.0);
  for (const Triangle & t : m_Triangles)
  {
    const Vector3 & a = sphere[t[0]];
    const Vector3 & b = sphere[t[1]];
    const Vector3 & c = sphere[t[2]];
    const Vector3   normal = (b - a).cross(c - a);
    const double    twiceArea = normal.norm();
    if (!(twiceArea > 0.0))
    {
      continue;
    }
    // Gradient of the linear function times twice the area: the weight of the average is already in it.
    const Vector3 gradient =
      normal.cross(m_Potential[t[0]] * (c - b) + m_Potential[t[1]] * (a - c) + m_Potential[t[2]] * (b - a)) / twiceArea;
    for (const VertexIndex v : t)
    {
      m_Gradient[v] += gradient;
      weight[v] += twiceArea;
    }
  }
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    m_Gradient[v] = weight[v] > 0.0 ? tangentPart(m_Gradient[v] / weight[v], sphere[v]) : Vector3(Vector3::Zero());
  }
}

void
Flow::prepareField(const Positions & sphere, std::vector<double> density)
{
  m_SolidAngle = vertexShares(m_Triangles, solidAngles(m_Triangles, sphere), sphere.size());
  double mass = 0.0;
  double area = 0.0;
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    mass += density[v] * m_SolidAngle[v];
    area += m_SolidAngle[v];
  }
  for (double & mu : density)
  {
    mu *= area / mass;
  }
  m_Density = std::move(density);
  solvePotential(sphere);
  averageGradient(sphere);
}

Vector3
Flow::velocity(const SphereLocator & locator, const Vector3 & p, double t, int & triangle) const
{
  const SphereLocator::Hit hit = locator.locateFrom(p, triangle);
  triangle = hit.triangle;
  Vector3 gradient = Vector3::Zero();
  double  mu = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const VertexIndex v = m_Triangles[triangle][k];
    gradient += hit.barycentric[k] * m_Gradient[v];
    mu += hit.barycentric[k] * m_Density[v];
  }
  return -tangentPart(gradient, p) / ((1.0 - t) * mu + t);
}

Vector3
Flow::rungeKuttaStep(const SphereLocator & locator, const Vector3 & p, double t, double dt, int & triangle) const
{
  const Vector3 k1 = velocity(locator, p, t, triangle);
  const Vector3 k2 = velocity(locator, (p + 0.5 * dt * k1).normalized(), t + 0.5 * dt, triangle);
  const Vector3 k3 = velocity(locator, (p + 0.5 * dt * k2).normalized(), t + 0.5 * dt, triangle);
  const Vector3 k4 = velocity(locator, (p + dt * k3).normalized(), t + dt, triangle);
  return (p + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)).normalized();
}

/** Takes vertices of flipped triangles back towards where they were until no triangle is flipped. */
bool
Flow::brake(Positions & moved, const Positions & before) const
{
  constexpr int     halvings = 20;
  constexpr int     rounds = 60;
  std::vector<char> flippedVertex(moved.size());
  for (int round = 0; round < rounds; ++round)
  {
    std::fill(flippedVertex.begin(), flippedVertex.end(), char{ 0 });
    bool anyFlipped = false;
    for (const Triangle & t : m_Triangles)
    {
      if (!(moved[t[0]].dot(moved[t[1]].cross(moved[t[2]])) > 0.0))
      {
        anyFlipped = true;
        flippedVertex[t[0]] = flippedVertex[t[1]] = flippedVertex[t[2]] = 1;
      }
    }
    if (!anyFlipped)
    {
      return true;
    }
    for (std::size_t v = 0; v < moved.size(); ++v)
    {
      if (flippedVertex[v] != 0)
      {
        moved[v] = round < halvings ? Vector3((0.5 * (moved[v] + before[v])).normalized()) : before[v];
      }
    }
  }
  return false;
}

MoserAreaFlowResult
Flow::pass(const Positions & sphere, std::vector<double> density, int steps, bool localBrake)
{
  const Stopwatch watch;
  prepareField(sphere, std::move(density));
  const SphereLocator locator(m_Triangles, sphere);
  std::vector<int>    holder = m_Topology.vertexTriangle;

  MoserAreaFlowResult result;
  result.positions = sphere;
  const double dt = 1.0 / steps;
  Positions    moved(sphere.size());
  for (result.report.steps = 0; result.report.steps < steps; ++result.report.steps)
  {
    for (std::size_t v = 0; v < sphere.size(); ++v)
    {
      moved[v] = rungeKuttaStep(locator, result.positions[v], result.report.steps * dt, dt, holder[v]);
    }
    if (countFlippedTriangles(m_Triangles, moved) > 0 && (!localBrake || !brake(moved, result.positions)))
    {
      break;
    }
    result.positions = moved;
  }
  result.report.converged = result.report.steps == steps;
  result.report.residual = 1.0 - result.report.steps * dt;
  result.report.seconds = watch.seconds();
  result.report.note = "moser pass";
  return result;
}

void
requireStart(const std::vector<Triangle> & triangles, const Positions & sphere)
{
  const int flipped = countFlippedTriangles(triangles, sphere);
  if (flipped > 0)
  {
    std::ostringstream message;
    message << "Moser flow: the start has " << flipped << " flipped triangles, need 0";
    throw InvalidInput(message.str());
  }
}

void
requireOptions(const MoserAreaFlowOptions & options)
{
  if (options.stepsPerPass < 1 || options.maximumPasses < 0)
  {
    std::ostringstream message;
    message << "Moser flow: " << options.stepsPerPass << " steps per pass and " << options.maximumPasses
            << " passes, need at least 1 and 0";
    throw InvalidInput(message.str());
  }
}

} // namespace

MoserAreaFlowResult
moserAreaFlowPass(const std::vector<Triangle> & triangles,
                  const Positions &             sphere,
                  const std::vector<double> &   density,
                  const MoserAreaFlowOptions &  options)
{
  requireOptions(options);
  if (density.size() != sphere.size())
  {
    std::ostringstream message;
    message << density.size() << " densities for " << sphere.size() << " vertices";
    throw InvalidInput(message.str());
  }
  for (std::size_t v = 0; v < density.size(); ++v)
  {
    if (!(density[v] > 0.0) || !std::isfinite(density[v]))
    {
      std::ostringstream message;
      message << "density of vertex " << v << " = " << density[v] << ", need positive and finite";
      throw InvalidInput(message.str());
    }
  }
  Flow flow(triangles, sphere);
  requireStart(triangles, sphere);
  return flow.pass(sphere, density, options.stepsPerPass, options.localBrake);
}

MoserAreaFlowResult
moserAreaFlow(const TriangleMesh & surface, const Positions & sphere, const MoserAreaFlowOptions & options)
{
  requireOptions(options);
  if (surface.vertices.size() != sphere.size())
  {
    std::ostringstream message;
    message << sphere.size() << " positions on the sphere for " << surface.vertices.size() << " vertices";
    throw InvalidInput(message.str());
  }
  Flow flow(surface.triangles, sphere);
  requireStart(surface.triangles, sphere);

  const Stopwatch           watch;
  const std::vector<double> targets = targetSolidAngles(surface, options.relativeFloor);
  const std::vector<double> vertexTargets = vertexShares(surface.triangles, targets, sphere.size());

  MoserAreaFlowResult result;
  result.positions = sphere;
  result.report.residual = areaRatioRms(surface.triangles, sphere, targets);
  Positions     present = sphere;
  int           steps = options.stepsPerPass;
  int           passesWithoutGain = 0;
  constexpr int patience = 3;
  while (result.report.residual > options.tolerance && result.report.steps < options.maximumPasses &&
         passesWithoutGain < patience)
  {
    std::vector<double> density =
      vertexShares(surface.triangles, solidAngles(surface.triangles, present), sphere.size());
    for (std::size_t v = 0; v < density.size(); ++v)
    {
      density[v] = vertexTargets[v] / density[v];
    }
    const MoserAreaFlowResult pass = flow.pass(present, std::move(density), steps, options.localBrake);
    ++result.report.steps;
    present = pass.positions;
    const double rms = areaRatioRms(surface.triangles, present, targets);
    if (rms < 0.999 * result.report.residual)
    {
      result.report.residual = rms;
      result.positions = present;
      passesWithoutGain = 0;
    }
    else
    {
      ++passesWithoutGain;
    }
    steps = pass.report.converged ? steps : std::min(2 * steps, largestStepCount);
  }
  result.report.converged = result.report.residual <= options.tolerance;
  result.report.seconds = watch.seconds();
  result.report.note = "moser flow";
  return result;
}

} // namespace moserhex
