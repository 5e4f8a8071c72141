#include "moserhex/SphericalMap/MoebiusCentring.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Stopwatch.h"
#include "moserhex/DiscreteCalculus/TriangleOperators.h"

#include <Eigen/Cholesky>

#include <sstream>

namespace moserhex
{
namespace
{

/** Longest boost of one step: Newton's model of the centroid holds for small boosts only. */
constexpr double longestStep = 0.5;

struct CentroidModel
{
  Vector3 centroid{ Vector3::Zero() };
  Matrix3 spread{ Matrix3::Zero() }; ///< sum m_i (I - s_i s_i^T): half the derivative of the centroid by the boost
};

CentroidModel
centroidModel(const Positions & sphere, const std::vector<double> & mass, double totalMass)
{
  CentroidModel model;
  for (std::size_t v = 0; v < sphere.size(); ++v)
  {
    model.centroid += mass[v] / totalMass * sphere[v];
    model.spread += mass[v] / totalMass * (Matrix3::Identity() - sphere[v] * sphere[v].transpose());
  }
  return model;
}

} // namespace

Vector3
moebiusBoost(const Vector3 & s, const Vector3 & c)
{
  const double cc = c.squaredNorm();
  const double cs = c.dot(s);
  return ((1.0 - cc) * s + 2.0 * (1.0 + cs) * c) / (1.0 + 2.0 * cs + cc);
}

MoebiusCentringResult
moebiusCentring(const TriangleMesh & surface, const Positions & sphere, const MoebiusCentringOptions & options)
{
  if (surface.vertices.size() != sphere.size())
  {
    std::ostringstream message;
    message << sphere.size() << " positions on the sphere for " << surface.vertices.size() << " vertices";
    throw InvalidInput(message.str());
  }
  const std::vector<double> mass = lumpedMass(surface);
  double                    totalMass = 0.0;
  for (const double m : mass)
  {
    totalMass += m;
  }
  if (!(totalMass > 0.0))
  {
    throw InvalidInput("the surface has no area, need positive");
  }

  const Stopwatch       watch;
  MoebiusCentringResult result;
  result.positions = sphere;
  for (;; ++result.report.steps)
  {
    const CentroidModel model = centroidModel(result.positions, mass, totalMass);
    result.report.residual = model.centroid.norm();
    result.report.converged = result.report.residual <= options.tolerance;
    if (result.report.converged || result.report.steps == options.maximumSteps)
    {
      break;
    }
    Vector3      boost = -0.5 * model.spread.ldlt().solve(model.centroid);
    const double length = boost.norm();
    if (!(length <= longestStep))
    {
      boost *= longestStep / length;
    }
    for (Vector3 & s : result.positions)
    {
      s = moebiusBoost(s, boost).normalized();
    }
  }
  result.report.seconds = watch.seconds();
  result.report.note = "centring";
  if (!result.report.converged)
  {
    std::ostringstream message;
    message << "Moebius centring: area centroid at " << result.report.residual << " of the radius after "
            << result.report.steps << " steps, need " << options.tolerance;
    throw NotConverged(message.str(), result.report);
  }
  return result;
}

} // namespace moserhex
