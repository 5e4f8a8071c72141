#include "moserhex/HexMap/MassMeasure.h"

#include "CellLoop.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Numerics/GaussLegendre.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moserhex
{
namespace
{

constexpr std::size_t cellsPerBlock = 32;
constexpr int         fewestPoints = 2;
constexpr int         mostPoints = 48;
constexpr int         mostPointsToRefine = 32;
constexpr int         mostChosenPoints = 9; ///< chooseMassQuadrature: finer rules cost a second a step

/** The next rule of the sequence 2, 3, 4, 6, 9, 13, 19, 28, 42. */
int
nextFiner(int pointsPerAxis)
{
  return std::max(pointsPerAxis + 1, pointsPerAxis + pointsPerAxis / 2);
}

/** Largest |m - m'| over the cells, over the mean m'. */
double
largestDifference(const std::vector<double> & masses, const std::vector<double> & finerMasses)
{
  const double mean = measureEquality(finerMasses).total / static_cast<double>(finerMasses.size());
  double       largest = 0.0;
  for (std::size_t cell = 0; cell < masses.size(); ++cell)
  {
    largest = std::max(largest, std::abs(masses[cell] - finerMasses[cell]));
  }
  return largest / mean;
}

/** Corners of the faces xi = 0 and xi = 1 at (eta, zeta) = (0,0), (1,0), (1,1), (0,1). */
constexpr std::size_t endCorners[2][4] = { { 0, 3, 7, 4 }, { 1, 2, 6, 5 } };

using EndCorners = Eigen::Matrix<double, 3, 4>; ///< of one of the two faces, one per column

/** x, dx/deta, dx/dzeta at one end of a line along xi; or the derivatives of the mass with respect to them. */
using EndFrame = Matrix3;

} // namespace

MassMeasure::MassMeasure(const Density & density, const MassMeasureOptions & options)
  : m_Density(density), m_Options(options)
{
  if (options.pointsPerAxis < fewestPoints || options.pointsPerAxis > mostPoints)
  {
    throw InvalidInput("mass quadrature: " + std::to_string(options.pointsPerAxis) + " points per axis, need " +
                       std::to_string(fewestPoints) + " to " + std::to_string(mostPoints));
  }
  const GaussRule rule = gaussLegendre(options.pointsPerAxis);
  m_Abscissae = rule.abscissae;
  m_Weights = rule.weights;
  for (std::size_t c = 0; c < rule.weights.size(); ++c)
  {
    for (std::size_t b = 0; b < rule.weights.size(); ++b)
    {
      const double eta = rule.abscissae[b];
      const double zeta = rule.abscissae[c];
      Line         line;
      line.weight = rule.weights[b] * rule.weights[c];
      line.basis.col(0) << (1 - eta) * (1 - zeta), eta * (1 - zeta), eta * zeta, (1 - eta) * zeta;
      line.basis.col(1) << zeta - 1, 1 - zeta, zeta, -zeta;
      line.basis.col(2) << eta - 1, -eta, eta, 1 - eta;
      m_Lines.push_back(line);
    }
  }
}

double
MassMeasure::massOfCell(const HexCorners & corners, Eigen::Matrix<double, 3, 8> * gradient) const
{
  EndCorners ends[2];
  EndCorners endGradients[2] = { EndCorners::Zero(), EndCorners::Zero() };
  for (std::size_t end = 0; end < 2; ++end)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      ends[end].col(static_cast<Eigen::Index>(corner)) = corners[endCorners[end][corner]];
    }
  }
  double mass = 0.0;
  for (const Line & line : m_Lines)
  {
    const EndFrame first = ends[0] * line.basis;
    const EndFrame step = ends[1] * line.basis - first;
    const Vector3  xXi = step.col(0);
    EndFrame       sum = EndFrame::Zero();    // of the derivatives with respect to x, dx/deta, dx/dzeta ...
    EndFrame       moment = EndFrame::Zero(); // ... and of xi times them
    Vector3        sumXi = Vector3::Zero();   // with respect to dx/dxi
    for (std::size_t a = 0; a < m_Abscissae.size(); ++a)
    {
      const double  xi = m_Abscissae[a];
      const double  weight = line.weight * m_Weights[a];
      const Vector3 x = first.col(0) + xi * step.col(0);
      const Vector3 xEta = first.col(1) + xi * step.col(1);
      const Vector3 xZeta = first.col(2) + xi * step.col(2);
      const Vector3 etaCrossZeta = xEta.cross(xZeta);
      const double  jacobian = xXi.dot(etaCrossZeta);
      if (gradient == nullptr)
      {
        mass += weight * m_Density.value(x) * jacobian;
        continue;
      }
      const ValueAndGradient density = m_Density.at(x);
      const double           weightedDensity = weight * density.value;
      mass += weightedDensity * jacobian;
      sumXi += weightedDensity * etaCrossZeta;
      EndFrame derivative;
      derivative.col(0) = (weight * jacobian) * density.gradient;
      derivative.col(1) = weightedDensity * xZeta.cross(xXi);
      derivative.col(2) = weightedDensity * xXi.cross(xEta);
      sum += derivative;
      moment += xi * derivative;
    }
    if (gradient != nullptr)
    {
      sum -= moment;
      sum.col(0) -= sumXi;
      moment.col(0) += sumXi;
      endGradients[0] += sum * line.basis.transpose();
      endGradients[1] += moment * line.basis.transpose();
    }
  }
  if (gradient != nullptr)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      for (std::size_t corner = 0; corner < 4; ++corner)
      {
        gradient->col(static_cast<Eigen::Index>(endCorners[end][corner])) =
          endGradients[end].col(static_cast<Eigen::Index>(corner));
      }
    }
  }
  return mass;
}

void
MassMeasure::evaluate(const HexMesh &       mesh,
                      unsigned int          threads,
                      std::vector<double> & measures,
                      CellGradients *       gradients) const
{
  evaluateCells(
    mesh, cellsPerBlock, threads, measures, gradients, [this](const HexCorners & corners, CornerGradient * gradient) {
      return massOfCell(corners, gradient);
    });
}

double
MassMeasure::estimateError(const HexMesh & mesh, unsigned int threads) const
{
  const int points = m_Options.pointsPerAxis;
  if (points > mostPointsToRefine)
  {
    throw InvalidInput("mass quadrature: estimate of the error with " + std::to_string(points) +
                       " points per axis, need " + std::to_string(fewestPoints) + " to " +
                       std::to_string(mostPointsToRefine));
  }
  requireValid(mesh);
  const MassMeasure   finer(m_Density, { nextFiner(points) });
  std::vector<double> masses;
  std::vector<double> finerMasses;
  evaluate(mesh, threads, masses);
  finer.evaluate(mesh, threads, finerMasses);
  return largestDifference(masses, finerMasses);
}

MassQuadrature
chooseMassQuadrature(const HexMesh & mesh, const Density & density, double relativeAccuracy, unsigned int threads)
{
  if (!(relativeAccuracy > 0.0))
  {
    throw InvalidInput("mass quadrature: relative accuracy " + std::to_string(relativeAccuracy) + ", need positive");
  }
  requireValid(mesh);
  MassQuadrature      quadrature{ { fewestPoints }, 0.0, false };
  std::vector<double> masses;
  MassMeasure(density, quadrature.options).evaluate(mesh, threads, masses);
  for (;;)
  {
    const MassMeasureOptions finer{ nextFiner(quadrature.options.pointsPerAxis) };
    std::vector<double>      finerMasses;
    MassMeasure(density, finer).evaluate(mesh, threads, finerMasses);
    quadrature.relativeError = largestDifference(masses, finerMasses);
    quadrature.reached = quadrature.relativeError <= relativeAccuracy;
    if (quadrature.reached || finer.pointsPerAxis > mostChosenPoints)
    {
      return quadrature;
    }
    quadrature.options = finer;
    masses = std::move(finerMasses);
  }
}

} // namespace moserhex
