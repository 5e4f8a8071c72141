#include "moserhex/HexMap/CellMeasure.h"

#include "CellLoop.h"
#include "moserhex/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moserhex
{
namespace
{

constexpr std::size_t cellsPerBlock = 256;

/** Corners of the six faces, counter-clockwise seen from outside. */
constexpr std::size_t faceCorners[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
                                            { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

/** 12 dV/dx of every corner. */
CornerGradient
twelveVolumeGradients(const HexCorners & x)
{
  CornerGradient gradient = CornerGradient::Zero();
  for (const auto & corner : faceCorners)
  {
    const Vector3 & a = x[corner[0]];
    const Vector3 & b = x[corner[1]];
    const Vector3 & c = x[corner[2]];
    const Vector3 & d = x[corner[3]];
    const Vector3   ab = a.cross(b);
    const Vector3   bc = b.cross(c);
    const Vector3   cd = c.cross(d);
    const Vector3   da = d.cross(a);
    const Vector3   ac = a.cross(c);
    const Vector3   bd = b.cross(d);
    gradient.col(static_cast<Eigen::Index>(corner[0])) += bc + cd + bd;
    gradient.col(static_cast<Eigen::Index>(corner[1])) += cd + da - ac;
    gradient.col(static_cast<Eigen::Index>(corner[2])) += da + ab - bd;
    gradient.col(static_cast<Eigen::Index>(corner[3])) += ab + bc + ac;
  }
  return gradient;
}

double
volumeOfCell(HexCorners corners, CornerGradient * gradient)
{
  const Vector3 origin = corners[0]; // the volume does not change, the round-off does
  for (Vector3 & corner : corners)
  {
    corner -= origin;
  }
  const CornerGradient twelveGradients = twelveVolumeGradients(corners);
  double               sum = 0.0;
  for (std::size_t a = 1; a < 8; ++a)
  {
    sum += corners[a].dot(twelveGradients.col(static_cast<Eigen::Index>(a)));
  }
  if (gradient != nullptr)
  {
    *gradient = twelveGradients / 12.0;
  }
  return sum / 36.0;
}

} // namespace

void
VolumeMeasure::evaluate(const HexMesh &       mesh,
                        unsigned int          threads,
                        std::vector<double> & measures,
                        CellGradients *       gradients) const
{
  evaluateCells(mesh, cellsPerBlock, threads, measures, gradients, volumeOfCell);
}

SharedVolumeMeasure::SharedVolumeMeasure(std::vector<double> shares) : m_Shares(std::move(shares))
{
  double sum = 0.0;
  for (const double share : m_Shares)
  {
    if (!(share > 0.0) || !std::isfinite(share))
    {
      throw InvalidInput("cell measures: a share of " + std::to_string(share) + ", need positive and finite");
    }
    sum += share;
  }
  if (m_Shares.empty())
  {
    throw InvalidInput("cell measures: no shares");
  }
  for (double & share : m_Shares)
  {
    share *= static_cast<double>(m_Shares.size()) / sum;
  }
}

void
SharedVolumeMeasure::evaluate(const HexMesh &       mesh,
                              unsigned int          threads,
                              std::vector<double> & measures,
                              CellGradients *       gradients) const
{
  VolumeMeasure().evaluate(mesh, threads, measures, gradients);
  for (std::size_t cell = 0; cell < measures.size(); ++cell)
  {
    measures[cell] /= m_Shares[cell];
    if (gradients != nullptr)
    {
      gradients->col(static_cast<Eigen::Index>(cell)) /= m_Shares[cell];
    }
  }
}

MeasureEquality
measureEquality(const std::vector<double> & measures)
{
  if (measures.empty())
  {
    throw InvalidInput("cell measures: none, need at least one");
  }
  const auto      count = static_cast<double>(measures.size());
  MeasureEquality equality;
  for (const double measure : measures)
  {
    equality.total += measure;
  }
  const double mean = equality.total / count;
  if (!(mean > 0.0) || !std::isfinite(mean))
  {
    throw InvalidInput("cell measures: mean " + std::to_string(mean) + ", need positive and finite");
  }
  for (const double measure : measures)
  {
    equality.variance += std::pow(measure / mean - 1.0, 2) / count;
  }
  const auto extremes = std::minmax_element(measures.begin(), measures.end());
  equality.ratioMin = *extremes.first / mean;
  equality.ratioMax = *extremes.second / mean;
  return equality;
}

MeasureEquality
measureEquality(const HexMesh & mesh, const CellMeasure & measure, unsigned int threads)
{
  requireValid(mesh);
  std::vector<double> measures;
  measure.evaluate(mesh, threads, measures);
  return measureEquality(measures);
}

} // namespace moserhex
