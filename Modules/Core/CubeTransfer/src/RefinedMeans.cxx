#include "moserhex/CubeTransfer/RefinedMeans.h"

#include "BoxIntegrator.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Common/Parallel.h"
#include "moserhex/CubeTransfer/CubeImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>

namespace moserhex
{
namespace
{

constexpr std::size_t boxesPerBlock = 4;
constexpr double      infinity = std::numeric_limits<double>::infinity();

/** The integrals of every box by its last rule, and what that changed. */
class RefinedBoxes
{
public:
  RefinedBoxes(const HexMesh &           mesh,
               const CubeFunction &      f,
               CubeMeans                 first,
               int                       points,
               const RefinementOptions & options)
    : m_Options(options)
    , m_Means(std::move(first))
    , m_Components(static_cast<std::size_t>(m_Means.image.components))
    , m_Integrator(mesh, f, m_Means.image.components, m_Means.image.size[0])
    , m_Points(m_Means.volumes.size(), points)
    , m_Changes(m_Means.image.values.size(), 0.0)
    , m_Judged(m_Components)
  {}

  /** Points that a finer rule would take in these boxes. */
  [[nodiscard]] double
  costOf(const std::vector<std::size_t> & boxes) const
  {
    return std::accumulate(boxes.begin(), boxes.end(), 0.0, [this](double sum, std::size_t box) {
      return sum + m_Integrator.pointCount(box, finer(m_Points[box]));
    });
  }

  void
  refine(const std::vector<std::size_t> & boxes)
  {
    std::map<int, GaussRule> rules;
    for (const std::size_t box : boxes)
    {
      m_Points[box] = finer(m_Points[box]);
      if (rules.count(m_Points[box]) == 0)
      {
        rules.emplace(m_Points[box], gaussLegendre(m_Points[box]));
      }
    }
    parallelForBlocks(boxes.size(), boxesPerBlock, m_Options.threads, [&](std::size_t begin, std::size_t end) {
      std::vector<double> sums(m_Components);
      for (std::size_t n = begin; n < end; ++n)
      {
        const std::size_t box = boxes[n];
        std::fill(sums.begin(), sums.end(), 0.0);
        const double volume = m_Integrator.addIntegral(box, rules.at(m_Points[box]), sums.data());
        for (std::size_t c = 0; c < m_Components; ++c)
        {
          double & mean = m_Means.image.at(box)[c];
          m_Changes[box * m_Components + c] = sums[c] - mean * m_Means.volumes[box];
          mean = sums[c] / volume;
        }
      }
    });
    for (std::size_t c = 0; c < m_Components; ++c)
    {
      m_Judged[c] = judged(c);
    }
  }

  /** The boxes whose changes keep the error of a component above the tolerance. */
  [[nodiscard]] std::vector<std::size_t>
  boxesToRefine() const
  {
    const auto               boxes = static_cast<double>(m_Points.size());
    std::vector<std::size_t> chosen;
    // The first share is enough where the errors' signs are by chance, the second where they are one sign, the last
    // where the error is what an earlier round leaves of it.
    for (const double share : { 0.5 / std::sqrt(boxes), 0.5 / boxes, 0.0 })
    {
      chosen = chosen.empty() ? boxesAbove(share) : chosen;
    }
    return chosen;
  }

  [[nodiscard]] RefinedMeans
  take()
  {
    RefinedMeans result;
    for (std::size_t c = 0; c < m_Components; ++c)
    {
      const Component & component = m_Judged[c];
      result.integrals.push_back(component.integral);
      result.errors.push_back(component.error);
      const double error = component.relativeError();
      result.relativeError = std::max(result.relativeError, std::isnan(error) ? infinity : error);
    }
    result.means = std::move(m_Means);
    return result;
  }

private:
  struct Component
  {
    double integral{ 0.0 };
    double magnitude{ 0.0 }; ///< sum of the boxes' |integral|
    double error{ 0.0 };

    [[nodiscard]] double
    relativeError() const
    {
      return error == 0.0 ? 0.0 : error / magnitude;
    }
  };

  [[nodiscard]] static int
  finer(int points)
  {
    return points + (points + 1) / 2;
  }

  [[nodiscard]] Component
  judged(std::size_t c) const
  {
    Component component;
    double    change = 0.0;
    double    squares = 0.0;
    for (std::size_t box = 0; box < m_Points.size(); ++box)
    {
      const double integral = m_Means.image.at(box)[c] * m_Means.volumes[box];
      const double ofBox = m_Changes[box * m_Components + c];
      component.integral += integral;
      component.magnitude += std::abs(integral);
      change += ofBox;
      squares += ofBox * ofBox;
    }
    constexpr double leastLeft = 0.4; // of an error by a finer rule: more than of a kink, less than of a step
    component.error = std::max({ std::abs(change), 2.0 * std::sqrt(squares), leastLeft * m_Judged[c].error });
    return component;
  }

  /** Those that change by more than a share of the tolerance in a component that is not within it. */
  [[nodiscard]] std::vector<std::size_t>
  boxesAbove(double share) const
  {
    std::vector<double> limits;
    for (std::size_t c = 0; c < m_Components; ++c)
    {
      const Component & component = m_Judged[c];
      const bool        isWithin = component.relativeError() <= m_Options.tolerance;
      limits.push_back(isWithin ? component.error : share * m_Options.tolerance * component.magnitude);
    }
    std::vector<std::size_t> boxes;
    for (std::size_t box = 0; box < m_Points.size(); ++box)
    {
      const double * const changes = m_Changes.data() + box * m_Components;
      if (!std::equal(limits.begin(), limits.end(), changes, [](double limit, double change) {
            return !(std::abs(change) > limit); // also where it is not a number: no rule helps
          }))
      {
        boxes.push_back(box);
      }
    }
    return boxes;
  }

  const RefinementOptions & m_Options;
  CubeMeans                 m_Means;
  std::size_t               m_Components;
  BoxIntegrator             m_Integrator;
  std::vector<int>          m_Points; ///< of each box, along each axis
  std::vector<double>       m_Changes;
  std::vector<Component>    m_Judged; ///< after the last round
};

void
requireUsable(const HexMesh & mesh, const CubeMeans & first, int pointsPerAxis, const RefinementOptions & options)
{
  requireLattice(mesh);
  requireValid(first.image, "means");
  if (cubeSamplingOf(first.image) != CubeSampling::Cells || first.volumes.size() != first.image.gridVoxels())
  {
    throw InvalidInput("means: not those of a cube's boxes and their volumes");
  }
  if (pointsPerAxis < 1 || !(options.tolerance > 0.0))
  {
    throw InvalidInput("means: " + std::to_string(pointsPerAxis) + " points per axis, a tolerance of " +
                       std::to_string(options.tolerance) + ", need positive ones");
  }
}

} // namespace

RefinedMeans
refinedMeans(const HexMesh &           mesh,
             const CubeFunction &      f,
             CubeMeans                 first,
             int                       pointsPerAxis,
             const RefinementOptions & options)
{
  requireUsable(mesh, first, pointsPerAxis, options);
  std::vector<std::size_t> boxes(first.volumes.size());
  std::iota(boxes.begin(), boxes.end(), std::size_t{ 0 });
  RefinedBoxes refined(mesh, f, std::move(first), pointsPerAxis, options);
  double       spent = 0.0;
  do
  {
    spent += refined.costOf(boxes);
    refined.refine(boxes);
    boxes = refined.boxesToRefine();
  } while (!boxes.empty() && spent + refined.costOf(boxes) <= options.mostPoints);
  return refined.take();
}

} // namespace moserhex
