#pragma once

#include "LaneVector.h"
#include "LatticeVector.h"

namespace moserhex
{

static_assert(laneCount <= latticePadding, "kernels reach past the last node by up to a lane");

/** The pieces that kernels over eight consecutive cells are made of. Corner a of a cell: bit 0 = i, bit 1 = j,
 * bit 2 = k. */

/** Corners of the lattice's cells p, ..., p + 7, relative to their first. */
MOSERHEX_INLINE void
loadCorners(const LatticeLayout & layout, const double * x, std::size_t p, LaneVector * corners)
{
  const std::size_t stride = layout.stride;
  const LaneVector  first{ loadLanes(x + p), loadLanes(x + stride + p), loadLanes(x + 2 * stride + p) };
  for (std::size_t a = 0; a < 8; ++a)
  {
    const double * q = x + p + layout.corner[a];
    corners[a] = LaneVector{ loadLanes(q), loadLanes(q + stride), loadLanes(q + 2 * stride) } - first;
  }
}

MOSERHEX_INLINE void
addToCorners(const LatticeLayout & layout, double * x, std::size_t p, const LaneVector * values)
{
  const std::size_t stride = layout.stride;
  for (std::size_t a = 0; a < 8; ++a)
  {
    double * q = x + p + layout.corner[a];
    addLanes(q, values[a].x);
    addLanes(q + stride, values[a].y);
    addLanes(q + 2 * stride, values[a].z);
  }
}

/** Corners of the pillow cells first, ..., first + 7, relative to their first; the last cell fills what is left. */
MOSERHEX_INLINE void
gatherCorners(const LatticeLayout & layout, const double * x, std::size_t first, LaneVector * corners)
{
  const std::size_t stride = layout.stride;
  const std::size_t last = layout.pillowCells.size() - 1;
  for (std::size_t a = 0; a < 8; ++a)
  {
    for (std::size_t lane = 0; lane < laneCount; ++lane)
    {
      const std::size_t cell = first + lane < last ? first + lane : last;
      const double *    q = x + layout.pillowCells[cell][a];
      corners[a].x[lane] = q[0];
      corners[a].y[lane] = q[stride];
      corners[a].z[lane] = q[2 * stride];
    }
  }
  for (std::size_t a = 8; a-- > 0;)
  {
    corners[a] = corners[a] - corners[0];
  }
}

/** Adds to the corners of the pillow cells first, ..., first + 7 that there are. */
MOSERHEX_INLINE void
scatterToCorners(const LatticeLayout & layout, double * x, std::size_t first, const LaneVector * values)
{
  const std::size_t stride = layout.stride;
  for (std::size_t lane = 0; lane < laneCount && first + lane < layout.pillowCells.size(); ++lane)
  {
    for (std::size_t a = 0; a < 8; ++a)
    {
      double * q = x + layout.pillowCells[first + lane][a];
      q[0] += values[a].x[lane];
      q[stride] += values[a].y[lane];
      q[2 * stride] += values[a].z[lane];
    }
  }
}

/** Cells p, ..., p + 7 that exist and begin before `end`. */
MOSERHEX_INLINE LaneMask
existing(const double * targetVolumes, std::size_t p, std::size_t end)
{
  LaneMask mask = loadLanes(targetVolumes + p) > Lanes{};
  for (std::size_t lane = end > p ? end - p : 0; lane < laneCount; ++lane)
  {
    mask[lane] = 0;
  }
  return mask;
}

/** chi and r of ShapeEnergy.h. For d <= 0 chi is written without the difference of two nearly equal numbers. */
struct RegularisedDeterminant
{
  Lanes chi;
  Lanes r;
};

MOSERHEX_INLINE RegularisedDeterminant
regularised(Lanes determinant, double epsilon)
{
  const double squared = epsilon * epsilon;
  const Lanes  r = squareRoot(squared + determinant * determinant);
  const Lanes  positive = 0.5 * (determinant + r);
  const Lanes  negative = 0.5 * squared / (r - determinant);
  return { select(determinant > Lanes{}, positive, negative), r };
}

/** Sums over the faces a b c d (outward) of a product P of two corners, antisymmetric in them:
 *   at a: P(b,c) + P(c,d) + P(b,d),  and cyclically. */
template <typename TProduct>
MOSERHEX_INLINE void
faceProducts(const TProduct & product, LaneVector * sums)
{
  constexpr std::size_t faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
                                        { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  for (std::size_t a = 0; a < 8; ++a)
  {
    sums[a] = { Lanes{}, Lanes{}, Lanes{} };
  }
  for (const auto & face : faces)
  {
    const LaneVector ab = product(face[0], face[1]);
    const LaneVector bc = product(face[1], face[2]);
    const LaneVector cd = product(face[2], face[3]);
    const LaneVector da = product(face[3], face[0]);
    const LaneVector ac = product(face[0], face[2]);
    const LaneVector bd = product(face[1], face[3]);
    sums[face[0]] += bc + cd + bd;
    sums[face[1]] += cd + da - ac;
    sums[face[2]] += ab + da - bd;
    sums[face[3]] += ab + bc + ac;
  }
}

/** a x b of the corners. */
struct CrossProduct
{
  const LaneVector * corners;

  MOSERHEX_INLINE LaneVector
  operator()(std::size_t a, std::size_t b) const
  {
    return cross(corners[a], corners[b]);
  }
};

/** The derivative of a x b along a motion of the corners. */
struct CrossProductAlong
{
  const LaneVector * corners;
  const LaneVector * motion;

  MOSERHEX_INLINE LaneVector
  operator()(std::size_t a, std::size_t b) const
  {
    return cross(motion[a], corners[b]) + cross(corners[a], motion[b]);
  }
};

/** Twelve times the gradient of the exact volume of the trilinear hexahedron with respect to its corners.
 *
 * A bilinear face a b c d (outward) encloses with the origin the mean of its two triangulations, which gives
 *   12 dV/da = b x c + c x d + b x d,  and cyclically,
 * and, V being cubic and homogeneous, 3 V = sum of corner . gradient. */
MOSERHEX_INLINE void
volumeGradients(const LaneVector * corners, LaneVector * gradients)
{
  faceProducts(CrossProduct{ corners }, gradients);
}

/** Their derivative along a motion of the corners: twelve times the volume's second derivative times the motion. */
MOSERHEX_INLINE void
volumeGradientsAlong(const LaneVector * corners, const LaneVector * motion, LaneVector * derivatives)
{
  faceProducts(CrossProductAlong{ corners, motion }, derivatives);
}

/** Volumes from the corners relative to the first and their volumeGradients. */
MOSERHEX_INLINE Lanes
volumesOf(const LaneVector * corners, const LaneVector * gradients)
{
  Lanes sum{};
  for (std::size_t a = 1; a < 8; ++a)
  {
    sum += dot(corners[a], gradients[a]);
  }
  return sum * (1.0 / 36.0);
}

/** The four edges of each direction; edge e of direction i runs at (j,k) = (e & 1, e >> 1), of j at (i,k), of k at
 * (i,j). */
struct CellEdges
{
  LaneVector i[4];
  LaneVector j[4];
  LaneVector k[4];
};

MOSERHEX_INLINE void
edgesOf(const LaneVector * corners, CellEdges & edges)
{
  for (std::size_t e = 0; e < 4; ++e)
  {
    const std::size_t low = e & 1;
    const std::size_t high = e >> 1;
    edges.i[e] = corners[1 + 2 * low + 4 * high] - corners[2 * low + 4 * high];
    edges.j[e] = corners[low + 2 + 4 * high] - corners[low + 4 * high];
    edges.k[e] = corners[low + 2 * high + 4] - corners[low + 2 * high];
  }
}

/** Numbers in CellEdges of the three edges at a corner. */
struct CornerEdges
{
  std::size_t i;
  std::size_t j;
  std::size_t k;
};

MOSERHEX_INLINE CornerEdges
edgesAt(std::size_t corner)
{
  const std::size_t i = corner & 1;
  const std::size_t j = corner >> 1 & 1;
  const std::size_t k = corner >> 2;
  return { j + 2 * k, i + 2 * k, i + 2 * j };
}

/** The Jacobian matrix at a corner of the cells: its columns a b c, the edges, and the columns of its cofactors. */
struct CornerFrame
{
  MOSERHEX_INLINE
  CornerFrame(const CellEdges & edges, const CornerEdges & at)
    : a(edges.i[at.i]), b(edges.j[at.j]), c(edges.k[at.k]), bc(cross(b, c)), ca(cross(c, a)), ab(cross(a, b))
  {}

  const LaneVector & a;
  const LaneVector & b;
  const LaneVector & c;
  LaneVector         bc;
  LaneVector         ca;
  LaneVector         ab;
};

/** The transpose of edgesOf: gradients with respect to edges become gradients with respect to corners, added. */
MOSERHEX_INLINE void
addEdgeGradients(const CellEdges & edges, LaneVector * corners)
{
  for (std::size_t e = 0; e < 4; ++e)
  {
    const std::size_t low = e & 1;
    const std::size_t high = e >> 1;
    corners[1 + 2 * low + 4 * high] += edges.i[e];
    corners[2 * low + 4 * high] -= edges.i[e];
    corners[low + 2 + 4 * high] += edges.j[e];
    corners[low + 4 * high] -= edges.j[e];
    corners[low + 2 * high + 4] += edges.k[e];
    corners[low + 2 * high] -= edges.k[e];
  }
}

} // namespace moserhex
