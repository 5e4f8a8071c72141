#include "Arrangements.h"

#include "moserhex/Common/Random.h"

#include <algorithm>
#include <numeric>

namespace moserhex
{
namespace
{
using Order = std::vector<std::uint16_t>;

Order
ownOrder(std::size_t count)
{
  Order order(count);
  std::iota(order.begin(), order.end(), std::uint16_t{ 0 });
  return order;
}

/** For every subject the first one with the same row. */
Order
representatives(const Eigen::MatrixXd & design)
{
  Order      sorted = ownOrder(static_cast<std::size_t>(design.rows()));
  const auto isLess = [&](std::uint16_t a, std::uint16_t b) {
    for (Eigen::Index column = 0; column < design.cols(); ++column)
    {
      if (design(a, column) != design(b, column))
      {
        return design(a, column) < design(b, column);
      }
    }
    return false;
  };
  std::stable_sort(sorted.begin(), sorted.end(), isLess);
  Order result(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    const bool isSame = i > 0 && !isLess(sorted[i - 1], sorted[i]);
    result[sorted[i]] = isSame ? result[sorted[i - 1]] : sorted[i];
  }
  return result;
}

/** Whether N! / prod c! <= limit, c the sizes of the classes of equal subjects. Infinite where it overflows. */
bool
isCountAtMost(const Order & classes, std::size_t limit)
{
  std::vector<std::size_t> sizes(classes.size(), 0);
  double                   count = 1.0;
  for (std::size_t placed = 0; placed < classes.size(); ++placed)
  {
    count *= static_cast<double>(placed + 1) / static_cast<double>(++sizes[classes[placed]]);
  }
  return count <= static_cast<double>(limit) + 0.5;
}

std::vector<Order>
allOrders(const Order & classes)
{
  std::vector<Order> orders{ classes };
  Order              order = classes;
  std::sort(order.begin(), order.end());
  do
  {
    if (order != classes)
    {
      orders.push_back(order);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return orders;
}

/** Fisher and Yates. */
Order
shuffled(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  Order  order = ownOrder(count);
  for (std::size_t i = count; i-- > 1;)
  {
    std::swap(order[i], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i + 1))]);
  }
  return order;
}

} // namespace

Arrangements
arrangementsOf(const Eigen::MatrixXd & design, std::size_t count, std::uint64_t seed)
{
  const Order classes = representatives(design);
  if (isCountAtMost(classes, count + 1))
  {
    return { allOrders(classes), true };
  }
  const std::size_t subjects = classes.size();
  Arrangements      result{ { ownOrder(subjects) }, false };
  for (std::size_t k = 0; k < count; ++k)
  {
    result.orders.push_back(shuffled(subjects, Random(seed).next() + k));
  }
  return result;
}

} // namespace moserhex
