#include "moserhex/Deformation/CellDeformation.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/Deformation/LatticeAlignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t blockSize = 512;

/** Columns dx/dxi, dx/deta, dx/dzeta of a trilinear cell at a place of the reference cube. */
Matrix3
tangents(const HexCorners & x, const Vector3 & at)
{
  const auto blend =
    [](const Vector3 & a, const Vector3 & b, const Vector3 & c, const Vector3 & d, double u, double v) {
      return Vector3((1 - u) * (1 - v) * a + u * (1 - v) * b + (1 - u) * v * c + u * v * d);
    };
  Matrix3 result;
  result.col(0) = blend(x[1] - x[0], x[2] - x[3], x[5] - x[4], x[6] - x[7], at[1], at[2]);
  result.col(1) = blend(x[3] - x[0], x[2] - x[1], x[7] - x[4], x[6] - x[5], at[0], at[2]);
  result.col(2) = blend(x[4] - x[0], x[5] - x[1], x[7] - x[3], x[6] - x[2], at[0], at[1]);
  return result;
}

/** Rows X_eta x X_zeta, X_zeta x X_xi, X_xi x X_eta: inverse times determinant. */
Matrix3
adjugate(const Matrix3 & J)
{
  Matrix3 result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result.row(axis) = J.col((axis + 1) % 3).cross(J.col((axis + 2) % 3)).transpose();
  }
  return result;
}

/** \param volume  of X */
Matrix3
meanGradient(const HexCorners & X, const HexCorners & x, double volume)
{
  constexpr double low = 0.21132486540518711775; // (1 - 1/sqrt(3)) / 2
  constexpr double points[2] = { low, 1.0 - low };
  Matrix3          sum = Matrix3::Zero();
  for (const double zeta : points)
  {
    for (const double eta : points)
    {
      for (const double xi : points)
      {
        const Vector3 at(xi, eta, zeta);
        sum += tangents(x, at) * adjugate(tangents(X, at));
      }
    }
  }
  return sum / (8.0 * volume);
}

std::vector<double>
positiveVolumes(const HexMesh & mesh, const char * name)
{
  std::vector<double> volumes = cellVolumes(mesh);
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    if (!(volumes[cell] > 0.0))
    {
      throw InvalidInput(std::string("cell ") + std::to_string(cell) + " of the " + name + " has the volume " +
                         std::to_string(volumes[cell]) + " mm^3, need > 0");
    }
  }
  return volumes;
}

double
sumOf(const std::vector<double> & values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

/** The vector or its opposite. */
Vector3
withLargestEntryPositive(const Vector3 & v)
{
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  return v[largest] < 0.0 ? Vector3(-v) : v;
}

} // namespace

CellStrain
cellStrain(const Matrix3 & F, double growth)
{
  CellStrain    result;
  const Matrix3 withoutGrowth = F / std::cbrt(growth);
  result.tensor = 0.5 * (withoutGrowth.transpose() * withoutGrowth - Matrix3::Identity());
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(result.tensor); // ascending
  for (int axis = 0; axis < 3; ++axis)
  {
    result.principal[axis] = eigen.eigenvalues()[2 - axis];
    result.directions.col(axis) = withLargestEntryPositive(eigen.eigenvectors().col(2 - axis));
  }
  result.deviatoric = (result.tensor - result.tensor.trace() / 3.0 * Matrix3::Identity()).norm();
  result.largestStretch = std::sqrt(1.0 + 2.0 * result.principal[0]);
  return result;
}

CellDeformation
cellDeformation(const HexMesh & baseline, const HexMesh & followUp, unsigned int threads)
{
  requireComparable(baseline, followUp);
  const std::vector<double> before = positiveVolumes(baseline, "baseline");
  const std::vector<double> after = positiveVolumes(followUp, "follow-up");
  const std::size_t         cells = before.size();
  CellDeformation           result;
  result.growth = sumOf(after) / sumOf(before);
  result.gradient.resize(cells);
  result.volumeRatio.resize(cells);
  result.volumetric.resize(cells);
  result.strain.resize(cells);
  parallelForBlocks(cells, blockSize, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      result.gradient[cell] = meanGradient(cellCorners(baseline, cell), cellCorners(followUp, cell), before[cell]);
      result.volumeRatio[cell] = after[cell] / before[cell];
      result.volumetric[cell] = result.volumeRatio[cell] / result.growth - 1.0;
      result.strain[cell] = cellStrain(result.gradient[cell], result.growth);
    }
  });
  return result;
}

} // namespace moserhex
