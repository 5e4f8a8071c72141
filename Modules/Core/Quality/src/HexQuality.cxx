#include "moserhex/Quality/HexQuality.h"

#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace moserhex
{
namespace
{
/** The three neighbours of each corner, right-handed: edges to them span the Jacobian at the corner. */
constexpr std::array<std::array<int, 3>, 8> cornerNeighbours{
  { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 }, { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } }
};
constexpr std::array<std::array<int, 2>, 12> edgeNodes{ { { 0, 1 },
                                                          { 1, 2 },
                                                          { 2, 3 },
                                                          { 3, 0 },
                                                          { 4, 5 },
                                                          { 5, 6 },
                                                          { 6, 7 },
                                                          { 7, 4 },
                                                          { 0, 4 },
                                                          { 1, 5 },
                                                          { 2, 6 },
                                                          { 3, 7 } } };

/** Reference coordinates of the corners, -1 or 1, VTK_HEXAHEDRON order. */
constexpr std::array<std::array<int, 3>, 8> reference{
  { { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } }
};

double
determinant(const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  return a.dot(b.cross(c));
}

struct PrincipalAxes
{
  std::array<Vector3, 3> axis;
  std::array<Vector3, 3> cross; // cross[m] belongs to the pair of axes other than m
};

PrincipalAxes
principalAxes(const HexCorners & corners)
{
  PrincipalAxes axes;
  for (std::size_t m = 0; m < 3; ++m)
  {
    const std::size_t a = (m + 1) % 3;
    const std::size_t b = (m + 2) % 3;
    axes.axis[m].setZero();
    axes.cross[m].setZero();
    for (std::size_t c = 0; c < 8; ++c)
    {
      axes.axis[m] += reference[c][m] * corners[c];
      axes.cross[m] += reference[c][a] * reference[c][b] * corners[c];
    }
  }
  return axes;
}

/** det / product of lengths; 0 when an edge has no length, as in Verdict. */
double
scaledDeterminant(double det, const Vector3 & a, const Vector3 & b, const Vector3 & c)
{
  const double lengths = a.norm() * b.norm() * c.norm();
  return lengths > std::numeric_limits<double>::min() ? det / lengths : 0.0;
}

void
evaluateCorners(const HexCorners & corners, HexCellQuality & quality)
{
  quality.shape = 1.0;
  for (std::size_t c = 0; c < 8; ++c)
  {
    const auto &  next = cornerNeighbours[c];
    const Vector3 a = corners[static_cast<std::size_t>(next[0])] - corners[c];
    const Vector3 b = corners[static_cast<std::size_t>(next[1])] - corners[c];
    const Vector3 d = corners[static_cast<std::size_t>(next[2])] - corners[c];
    const double  det = determinant(a, b, d);
    quality.minimumJacobian = std::min(quality.minimumJacobian, det);
    quality.scaledJacobian = std::min(quality.scaledJacobian, scaledDeterminant(det, a, b, d));
    const double squaredNorm = a.squaredNorm() + b.squaredNorm() + d.squaredNorm();
    const double meanRatio = det > 0.0 ? 3.0 * std::cbrt(det * det) / squaredNorm : 0.0;
    quality.shape = std::min(quality.shape, meanRatio);
    quality.concave = quality.concave || !(det > 0.0);
  }
}

void
evaluateAxes(const PrincipalAxes & axes, HexCellQuality & quality)
{
  std::array<double, 3> length{};
  for (std::size_t m = 0; m < 3; ++m)
  {
    length[m] = axes.axis[m].norm();
  }
  for (std::size_t m = 0; m < 3; ++m)
  {
    const std::size_t a = (m + 1) % 3;
    const std::size_t b = (m + 2) % 3;
    const double      shorter = std::min(length[a], length[b]);
    const double      longer = std::max(length[a], length[b]);
    const double      product = length[a] * length[b];
    const double      infinite = std::numeric_limits<double>::max();
    quality.aspectRatio = std::max(quality.aspectRatio, shorter > 0.0 ? longer / shorter : infinite);
    quality.taper = std::max(quality.taper, shorter > 0.0 ? axes.cross[m].norm() / shorter : infinite);
    quality.skew = std::max(quality.skew, product > 0.0 ? std::abs(axes.axis[a].dot(axes.axis[b])) / product : 0.0);
  }
}

double
longestOverShortestEdge(const HexCorners & corners)
{
  double shortest = std::numeric_limits<double>::max();
  double longest = 0.0;
  for (const auto & edge : edgeNodes)
  {
    const double length =
      (corners[static_cast<std::size_t>(edge[0])] - corners[static_cast<std::size_t>(edge[1])]).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return shortest > 0.0 ? longest / shortest : std::numeric_limits<double>::max();
}

/** Order statistics asked for in ascending order: each orders no more of the values than it needs. */
class OrderStatistics
{
public:
  explicit OrderStatistics(std::vector<double> & values) : m_Values(values)
  {}

  /** Value at `fraction` of the sorted values, linear between neighbours. */
  double
  percentile(double fraction)
  {
    const double position = fraction * static_cast<double>(m_Values.size() - 1);
    const auto   below = static_cast<std::size_t>(position);
    const double weight = position - static_cast<double>(below);
    const double valueBelow = at(below);
    const double valueAbove = at(std::min(below + 1, m_Values.size() - 1));
    return (1.0 - weight) * valueBelow + weight * valueAbove;
  }

private:
  double
  at(std::size_t rank)
  {
    if (rank >= m_Ordered)
    {
      const auto begin = m_Values.begin();
      std::nth_element(
        begin + static_cast<std::ptrdiff_t>(m_Ordered), begin + static_cast<std::ptrdiff_t>(rank), m_Values.end());
      m_Ordered = rank + 1;
    }
    return m_Values[rank];
  }

  std::vector<double> & m_Values;
  std::size_t           m_Ordered{ 0 }; ///< nothing behind is smaller than what lies before this rank
};

/** How many of the cube's faces a cell touches: 0 to 3. A lattice of one cell touches all, counted as a corner. */
int
facesTouched(const HexMesh & mesh, std::size_t cell)
{
  const auto m = static_cast<std::size_t>(mesh.nodesPerSide - 1);
  int        count = 0;
  for (const std::size_t index : { cell % m, cell / m % m, cell / m / m })
  {
    count += index == 0 || index == m - 1 ? 1 : 0;
  }
  return count;
}

/** Collects the cells of one class and summarises them. */
class ClassCollector
{
public:
  void
  add(const HexCellQuality & quality, double ratio)
  {
    m_Result.cells += 1;
    m_Result.concaveCells += quality.concave ? 1 : 0;
    m_SumOfSquares += (ratio - 1.0) * (ratio - 1.0);
    m_ScaledJacobians.push_back(quality.scaledJacobian);
  }

  [[nodiscard]] HexClassQuality
  result() const
  {
    HexClassQuality result = m_Result;
    if (result.cells > 0)
    {
      const Distribution scaledJacobian = distributionOf(m_ScaledJacobians);
      result.volumeVariance = m_SumOfSquares / static_cast<double>(result.cells);
      result.scaledJacobianMin = scaledJacobian.minimum;
      result.scaledJacobianMedian = scaledJacobian.median;
    }
    return result;
  }

private:
  HexClassQuality     m_Result;
  double              m_SumOfSquares{ 0.0 };
  std::vector<double> m_ScaledJacobians;
};

double
varianceAboutMean(const std::vector<double> & volumes, double mean)
{
  double sum = 0.0;
  for (const double volume : volumes)
  {
    const double deviation = volume / mean - 1.0;
    sum += deviation * deviation;
  }
  return sum / static_cast<double>(volumes.size());
}

template <typename TMesh>
std::vector<HexCellQuality>
cellQualities(const TMesh & mesh, unsigned int threads)
{
  std::vector<HexCellQuality> qualities(mesh.cellCount());
  parallelForBlocks(qualities.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
    {
      qualities[cell] = hexCellQuality(cellCorners(mesh, cell));
    }
  });
  return qualities;
}

/** One number of every cell. */
template <typename TNumber>
std::vector<double>
collect(const std::vector<HexCellQuality> & cells, TNumber number)
{
  std::vector<double> values(cells.size());
  std::transform(cells.begin(), cells.end(), values.begin(), number);
  return values;
}

/** NaN where the volumes are rounding, or cancel to it, against the cubes of the cells' longest diagonals: a ratio to
 * that says nothing. */
template <typename TMesh>
double
meanVolume(const TMesh & mesh, const std::vector<HexCellQuality> & cells)
{
  constexpr double rounding = 1e-13;
  double           volume = 0.0;
  double           size = 0.0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    const HexCorners corners = cellCorners(mesh, cell);
    const double     diagonal = std::max({ (corners[6] - corners[0]).norm(),
                                           (corners[7] - corners[1]).norm(),
                                           (corners[4] - corners[2]).norm(),
                                           (corners[5] - corners[3]).norm() });
    volume += cells[cell].volume;
    size += diagonal * diagonal * diagonal;
  }
  return std::abs(volume) > rounding * size ? volume / static_cast<double>(cells.size())
                                            : std::numeric_limits<double>::quiet_NaN();
}

/** All that does not depend on how the cells are connected; the certificate is left out. */
HexQualitySummary
summaryOf(const std::vector<HexCellQuality> & cells, double mean)
{
  const std::vector<double> volumes = collect(cells, [](const HexCellQuality & cell) { return cell.volume; });
  HexQualitySummary         summary;
  summary.cells = cells.size();
  summary.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  summary.volumeVariance = varianceAboutMean(volumes, mean);
  const auto extremes = std::minmax_element(volumes.begin(), volumes.end());
  summary.ratioMin = std::min(*extremes.first / mean, *extremes.second / mean);
  summary.ratioMax = std::max(*extremes.first / mean, *extremes.second / mean);
  summary.concaveCells = static_cast<std::size_t>(
    std::count_if(cells.begin(), cells.end(), [](const HexCellQuality & cell) { return cell.concave; }));
  summary.concavePercent = 100.0 * static_cast<double>(summary.concaveCells) / static_cast<double>(summary.cells);

  const auto distribution = [&cells](auto number) { return distributionOf(collect(cells, number)); };
  summary.scaledJacobian = distribution([](const HexCellQuality & cell) { return cell.scaledJacobian; });
  summary.minimumJacobian = distribution([mean](const HexCellQuality & cell) { return cell.minimumJacobian / mean; });
  summary.aspectRatio = distribution([](const HexCellQuality & cell) { return cell.aspectRatio; });
  summary.taper = distribution([](const HexCellQuality & cell) { return cell.taper; });
  summary.skew = distribution([](const HexCellQuality & cell) { return cell.skew; });
  return summary;
}
} // namespace

HexCellQuality
hexCellQuality(const HexCorners & corners)
{
  const PrincipalAxes axes = principalAxes(corners);
  const double        centreDeterminant = determinant(axes.axis[0], axes.axis[1], axes.axis[2]);

  HexCellQuality quality;
  quality.volume = hexVolume(corners);
  quality.minimumJacobian = centreDeterminant / 64.0;
  quality.scaledJacobian = scaledDeterminant(centreDeterminant, axes.axis[0], axes.axis[1], axes.axis[2]);
  evaluateCorners(corners, quality);
  evaluateAxes(axes, quality);
  quality.edgeRatio = longestOverShortestEdge(corners);
  return quality;
}

Distribution
distributionOf(std::vector<double> values)
{
  if (values.empty())
  {
    throw InvalidInput("distribution of no values");
  }
  Distribution distribution;
  distribution.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  OrderStatistics statistics(values);
  distribution.minimum = statistics.percentile(0.0);
  distribution.p01 = statistics.percentile(0.01);
  distribution.p05 = statistics.percentile(0.05);
  distribution.median = statistics.percentile(0.5);
  distribution.p95 = statistics.percentile(0.95);
  distribution.p99 = statistics.percentile(0.99);
  distribution.maximum = statistics.percentile(1.0);
  return distribution;
}

HexQualitySummary
summarizeQuality(const HexMesh & mesh, unsigned int threads)
{
  requireValid(mesh);
  const std::vector<HexCellQuality> cells = cellQualities(mesh, threads);
  const double                      mean = meanVolume(mesh, cells);
  HexQualitySummary                 summary = summaryOf(cells, mean);
  summary.certified = certifyCells(mesh, {}, threads);
  summary.paddingLayers = mesh.paddingLayers;
  if (mesh.paddingLayers > 0)
  {
    return summary;
  }
  summary.isLattice = true;
  std::array<ClassCollector, 3> classes; // by the number of faces touched: up to one, two, three
  for (std::size_t cell = 0; cell < summary.cells; ++cell)
  {
    const auto number = static_cast<std::size_t>(std::max(facesTouched(mesh, cell) - 1, 0));
    classes[number].add(cells[cell], cells[cell].volume / mean);
  }
  summary.rest = classes[0].result();
  summary.edges = classes[1].result();
  summary.corners = classes[2].result();
  return summary;
}

HexQualitySummary
summarizeQuality(const UnstructuredHexMesh & mesh, unsigned int threads)
{
  requireValid(mesh);
  if (const auto lattice = asLattice(mesh))
  {
    return summarizeQuality(*lattice, threads);
  }
  const std::vector<HexCellQuality> cells = cellQualities(mesh, threads);
  HexQualitySummary                 summary = summaryOf(cells, meanVolume(mesh, cells));
  summary.certified = certifyCells(mesh, {}, threads);
  return summary;
}

VolumeQuality
volumeQuality(const HexMesh & mesh)
{
  const std::vector<double> volumes = cellVolumes(mesh);
  VolumeQuality             quality;
  quality.volumeVariance = varianceAboutMean(
    volumes, std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(volumes.size()));
  for (std::size_t cell = 0; cell < volumes.size(); ++cell)
  {
    const auto jacobians = cornerJacobians(cellCorners(mesh, cell));
    const bool convex = std::all_of(jacobians.begin(), jacobians.end(), [](double det) { return det > 0.0; });
    quality.concaveCells += convex ? 0 : 1;
  }
  quality.concavePercent = 100.0 * static_cast<double>(quality.concaveCells) / static_cast<double>(volumes.size());
  return quality;
}

} // namespace moserhex
