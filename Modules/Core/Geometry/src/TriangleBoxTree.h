#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace moserhex
{

/** Binary tree of axis-aligned boxes over the triangles of a surface, split at the median of the centroids along the
 * longest side. Private to this module: shared by the closest-point and the intersection queries. */
class TriangleBoxTree
{
public:
  struct Box
  {
    Vector3 lower{ Vector3::Constant(1e300) };
    Vector3 upper{ Vector3::Constant(-1e300) };

    void
    include(const Vector3 & p)
    {
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    [[nodiscard]] bool
    overlaps(const Box & other) const
    {
      return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
    }
    [[nodiscard]] double
    squaredDistance(const Vector3 & p) const
    {
      return (lower - p).cwiseMax(p - upper).cwiseMax(0.0).squaredNorm();
    }
  };

  struct Node
  {
    Box box;
    int first{ 0 }; ///< leaf: first entry of order(); inner node: number of the left child (the right one follows)
    int count{ 0 }; ///< leaf: number of triangles; inner node: 0
    [[nodiscard]] bool
    isLeaf() const
    {
      return count > 0;
    }
  };

  explicit TriangleBoxTree(const TriangleMesh & surface)
    : m_Corners(surface.triangles.size()), m_Order(surface.triangles.size())
  {
    Positions centroids(surface.triangles.size());
    for (std::size_t t = 0; t < m_Corners.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        m_Corners[t][k] = surface.vertices[surface.triangles[t][k]];
      }
      centroids[t] = (m_Corners[t][0] + m_Corners[t][1] + m_Corners[t][2]) / 3;
    }
    std::iota(m_Order.begin(), m_Order.end(), 0);
    m_Nodes.reserve(m_Order.size());
    m_Nodes.emplace_back();
    build(0, 0, static_cast<int>(m_Order.size()), centroids);
  }

  [[nodiscard]] const std::vector<Node> &
  nodes() const
  {
    return m_Nodes;
  }
  [[nodiscard]] const std::vector<int> &
  order() const
  {
    return m_Order;
  }
  [[nodiscard]] const std::array<Vector3, 3> &
  corners(int triangle) const
  {
    return m_Corners[triangle];
  }

private:
  static constexpr int trianglesPerLeaf = 4;

  void
  build(int node, int begin, int end, const Positions & centroids)
  {
    Box box;
    Box spread;
    for (int i = begin; i < end; ++i)
    {
      for (const Vector3 & p : m_Corners[m_Order[i]])
      {
        box.include(p);
      }
      spread.include(centroids[m_Order[i]]);
    }
    m_Nodes[node].box = box;
    if (end - begin <= trianglesPerLeaf)
    {
      m_Nodes[node].first = begin;
      m_Nodes[node].count = end - begin;
      return;
    }
    int axis = 0;
    (spread.upper - spread.lower).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(m_Order.begin() + begin, m_Order.begin() + middle, m_Order.begin() + end, [&](int s, int t) {
      const double a = centroids[s][axis];
      const double b = centroids[t][axis];
      return a != b ? a < b : s < t;
    });
    const int left = static_cast<int>(m_Nodes.size());
    m_Nodes.resize(m_Nodes.size() + 2);
    m_Nodes[node].first = left;
    build(left, begin, middle, centroids);
    build(left + 1, middle, end, centroids);
  }

  std::vector<std::array<Vector3, 3>> m_Corners;
  std::vector<int>                    m_Order;
  std::vector<Node>                   m_Nodes;
};

} // namespace moserhex
