#include "VoxelFront.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace moserhex::detail
{
namespace
{

constexpr double notReached = std::numeric_limits<double>::infinity();

constexpr double stepsPerVoxel = 8.0; ///< values are told apart that finely, in the shortest voxel side

/** Voxels in the order of a value, in steps; in one step the one that came first, so that fronts move evenly. */
class Queue
{
public:
  Queue(double smallest, const VoxelGrid & grid) : m_Smallest(smallest), m_Step(grid.spacing.minCoeff() / stepsPerVoxel)
  {}

  void
  push(double order, std::size_t voxel)
  {
    const auto step = static_cast<std::size_t>(std::max(0.0, (order - m_Smallest) / m_Step));
    if (step >= m_Steps.size())
    {
      m_Steps.resize(step + 1);
    }
    m_Steps[step].voxels.push_back(voxel);
    m_First = std::min(m_First, step);
    ++m_Count;
  }

  std::size_t
  pop()
  {
    while (m_Steps[m_First].popped == m_Steps[m_First].voxels.size())
    {
      m_Steps[m_First] = {};
      ++m_First;
    }
    --m_Count;
    Step & step = m_Steps[m_First];
    return step.voxels[step.popped++];
  }

  [[nodiscard]] bool
  empty() const
  {
    return m_Count == 0;
  }

private:
  struct Step
  {
    std::vector<std::size_t> voxels;
    std::size_t              popped{ 0 };
  };

  double            m_Smallest;
  double            m_Step;
  std::vector<Step> m_Steps;
  std::size_t       m_First{ 0 }; ///< none before this one has voxels left
  std::size_t       m_Count{ 0 };
};

/** Flips simple voxels of the queue to `value`, and then what comes into reach: `follows(voxel)` says which voxels may
 * be flipped, `order(voxel)` when, `flipped(voxel)` hears of each. `queued` is all 0 before and after. */
template <typename TFollows, typename TOrder, typename TFlipped>
void
propagate(std::vector<std::uint8_t> & mask,
          std::vector<std::uint8_t> & queued,
          const VoxelNeighbourhood &  neighbourhood,
          std::uint8_t                value,
          Queue                       queue,
          const TFollows &            follows,
          const TOrder &              order,
          const TFlipped &            flipped)
{
  while (!queue.empty())
  {
    const std::size_t voxel = queue.pop();
    queued[voxel] = 0;
    if (mask[voxel] == value || !isSimpleVoxel(neighbourhood.inside(mask, voxel)))
    {
      continue;
    }
    mask[voxel] = value;
    flipped(voxel);
    for (const std::ptrdiff_t stride : neighbourhood.strides())
    {
      const std::size_t next = voxel + static_cast<std::size_t>(stride);
      if (mask[next] != value && queued[next] == 0 && follows(next))
      {
        queued[next] = 1;
        queue.push(order(next), next);
      }
    }
  }
}

const auto ignore = [](std::size_t) {};

/** Calls with the number of each voxel of the box without its margin, in voxel order. */
template <typename TFunction>
void
forBox(const VoxelGrid & grid, const TFunction & function)
{
  for (int k = frontMargin; k < grid.size[2] - frontMargin; ++k)
  {
    for (int j = frontMargin; j < grid.size[1] - frontMargin; ++j)
    {
      const std::size_t row = grid.voxelNumber(0, j, k);
      for (int i = frontMargin; i < grid.size[0] - frontMargin; ++i)
      {
        function(row + static_cast<std::size_t>(i));
      }
    }
  }
}

bool
inBox(const VoxelGrid & grid, const std::array<int, 3> & index)
{
  bool in = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    in = in && index[axis] >= frontMargin && index[axis] < grid.size[axis] - frontMargin;
  }
  return in;
}

std::array<int, 3>
indexOf(const VoxelGrid & grid, std::size_t voxel)
{
  const auto nx = static_cast<std::size_t>(grid.size[0]);
  const auto ny = static_cast<std::size_t>(grid.size[1]);
  return { { static_cast<int>(voxel % nx), static_cast<int>(voxel / nx % ny), static_cast<int>(voxel / (nx * ny)) } };
}

} // namespace

std::vector<std::uint8_t>
ballWithin(const LabelVolume & label, const std::vector<double> & order, std::size_t seed)
{
  const VoxelNeighbourhood  neighbourhood(label);
  std::vector<std::uint8_t> ball(label.inside.size(), 0);
  Queue                     queue(order[seed], label);
  ball[seed] = 1;
  const auto follows = [&](std::size_t voxel) { return label.inside[voxel] != 0; };
  for (const std::ptrdiff_t stride : neighbourhood.strides())
  {
    const std::size_t next = seed + static_cast<std::size_t>(stride);
    if (follows(next))
    {
      queue.push(order[next], next);
    }
  }
  std::vector<std::uint8_t> queued(ball.size(), 0);
  propagate(
    ball, queued, neighbourhood, 1, std::move(queue), follows, [&](std::size_t voxel) { return order[voxel]; }, ignore);
  return ball;
}

std::vector<std::uint8_t>
ballAround(const LabelVolume & label, const std::vector<double> & order)
{
  const VoxelNeighbourhood  neighbourhood(label);
  std::vector<std::uint8_t> ball(label.inside.size(), 0);
  forBox(label, [&](std::size_t voxel) { ball[voxel] = 1; });
  Queue queue(-*std::max_element(order.begin(), order.end()), label);
  forBox(label, [&](std::size_t voxel) {
    const bool atOutside =
      std::any_of(neighbourhood.strides().begin(), neighbourhood.strides().end(), [&](std::ptrdiff_t stride) {
        return ball[voxel + static_cast<std::size_t>(stride)] == 0;
      });
    if (atOutside && label.inside[voxel] == 0)
    {
      queue.push(-order[voxel], voxel);
    }
  });
  std::vector<std::uint8_t> queued(ball.size(), 0);
  propagate(
    ball,
    queued,
    neighbourhood,
    0,
    std::move(queue),
    [&](std::size_t voxel) { return label.inside[voxel] == 0; },
    [&](std::size_t voxel) { return -order[voxel]; },
    ignore);
  return ball;
}

std::vector<std::vector<std::size_t>>
partsOfDifference(const VoxelNeighbourhood &        neighbourhood,
                  const std::vector<std::uint8_t> & a,
                  const std::vector<std::uint8_t> & b)
{
  std::vector<std::vector<std::size_t>> parts;
  std::vector<std::uint8_t>             open(a.size());
  std::transform(a.begin(), a.end(), b.begin(), open.begin(), [](std::uint8_t inA, std::uint8_t inB) {
    return static_cast<std::uint8_t>(inA != 0 && inB == 0);
  });
  for (std::size_t first = 0; first < open.size(); ++first)
  {
    if (open[first] == 0)
    {
      continue;
    }
    std::vector<std::size_t> part{ first };
    open[first] = 0;
    for (std::size_t done = 0; done < part.size(); ++done)
    {
      for (const std::ptrdiff_t stride : neighbourhood.strides())
      {
        const std::size_t next = part[done] + static_cast<std::size_t>(stride);
        if (open[next] != 0)
        {
          open[next] = 0;
          part.push_back(next);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

PatchThickener::PatchThickener(const LabelVolume & label, double radius)
  : m_Grid(label), m_Neighbourhood(label), m_Distance(label.inside.size(), notReached), m_Queued(label.inside.size(), 0)
{
  std::array<int, 3> most{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    most[axis] = std::min(static_cast<int>(radius / label.spacing[static_cast<int>(axis)]), label.size[axis]);
  }
  const std::ptrdiff_t nx = label.size[0];
  const std::ptrdiff_t ny = label.size[1];
  for (int k = -most[2]; k <= most[2]; ++k)
  {
    for (int j = -most[1]; j <= most[1]; ++j)
    {
      for (int i = -most[0]; i <= most[0]; ++i)
      {
        const double distance = label.spacing.cwiseProduct(Vector3(i, j, k)).norm();
        if (distance > 0.0 && distance <= radius)
        {
          m_Offsets.push_back({ { { i, j, k } }, i + nx * (j + ny * k), distance });
        }
      }
    }
  }
}

std::vector<std::size_t>
PatchThickener::reach(const std::vector<std::uint8_t> & mask,
                      const std::vector<std::size_t> &  patch,
                      std::uint8_t                      value)
{
  std::vector<std::size_t> reached;
  for (const std::size_t voxel : patch)
  {
    const std::array<int, 3> index = indexOf(m_Grid, voxel);
    for (const Offset & offset : m_Offsets)
    {
      const std::array<int, 3> at{
        { index[0] + offset.step[0], index[1] + offset.step[1], index[2] + offset.step[2] }
      };
      const std::size_t target = voxel + static_cast<std::size_t>(offset.stride);
      if (!inBox(m_Grid, at) || mask[target] == value)
      {
        continue;
      }
      if (m_Distance[target] == notReached)
      {
        reached.push_back(target);
      }
      m_Distance[target] = std::min(m_Distance[target], offset.distance);
    }
  }
  return reached;
}

void
PatchThickener::thicken(std::vector<std::uint8_t> & mask, std::vector<std::size_t> & patch, std::uint8_t value)
{
  const std::vector<std::size_t> reached = reach(mask, patch, value);
  Queue                          queue(0.0, m_Grid);
  for (const std::size_t voxel : patch)
  {
    for (const std::ptrdiff_t stride : m_Neighbourhood.strides())
    {
      const std::size_t next = voxel + static_cast<std::size_t>(stride);
      if (m_Distance[next] != notReached)
      {
        queue.push(m_Distance[next], next);
      }
    }
  }
  propagate(
    mask,
    m_Queued,
    m_Neighbourhood,
    value,
    std::move(queue),
    [&](std::size_t voxel) { return m_Distance[voxel] != notReached; },
    [&](std::size_t voxel) { return m_Distance[voxel]; },
    [&](std::size_t voxel) { patch.push_back(voxel); });
  for (const std::size_t voxel : reached)
  {
    m_Distance[voxel] = notReached;
  }
}

} // namespace moserhex::detail
