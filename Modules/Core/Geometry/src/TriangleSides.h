#pragma once

#include "moserhex/Geometry/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** One side of one triangle, with its edge's vertices in ascending order. */
struct TriangleSide
{
  VertexIndex low;
  VertexIndex high;
  int         triangle;
  int         side;
  bool        ascending; ///< the triangle runs from low to high
};

/** All sides, those of the same edge next to each other, in order of triangle number within an edge. */
std::vector<TriangleSide>
sortedSides(const TriangleMesh & mesh);

/** Calls visit(first, count) for each group of sides that share an edge. */
template <typename TVisitor>
void
forEachEdge(const std::vector<TriangleSide> & sides, TVisitor && visit)
{
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[i].low == sides[j].low && sides[i].high == sides[j].high)
    {
      ++j;
    }
    visit(i, j - i);
    i = j;
  }
}

/** The representative of v in a forest of parents, which is flattened on the way. */
std::size_t
rootOf(std::vector<std::size_t> & parent, std::size_t v);

} // namespace moserhex
