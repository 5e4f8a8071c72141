#pragma once

#include "moserhex/Common/Types.h"

#include <array>
#include <cstddef>
#include <string>

namespace moserhex
{

/** Isotropic grid of nodes along the axes of an image.
 *
 *   point(i,j,k) = origin + direction * (spacing * (i,j,k))                                             [mm, LPS]
 *
 * Node (i,j,k) has the number i + size[0] (j + size[1] k). The columns of `direction` are the image axes: orthonormal,
 * right- or left-handed. */
struct RegularGrid
{
  using Index = std::array<int, 3>; ///< node numbers along the three axes, from 0

  Index   size{ { 0, 0, 0 } };              ///< nodes along each axis
  double  spacing{ 1.0 };                   ///< distance of neighbouring nodes [mm]
  Vector3 origin{ Vector3::Zero() };        ///< position of node (0,0,0) [mm]
  Matrix3 direction{ Matrix3::Identity() }; ///< orthonormal columns [1]

  /** Product of the sizes. */
  [[nodiscard]] std::size_t
  nodeCount() const
  {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }

  /** i + size[0] (j + size[1] k). */
  [[nodiscard]] std::size_t
  nodeNumber(int i, int j, int k) const
  {
    const auto nx = static_cast<std::size_t>(size[0]);
    const auto ny = static_cast<std::size_t>(size[1]);
    return static_cast<std::size_t>(i) + nx * (static_cast<std::size_t>(j) + ny * static_cast<std::size_t>(k));
  }

  /** Inverse of nodeNumber(). */
  [[nodiscard]] Index
  indexOf(std::size_t node) const
  {
    const auto nx = static_cast<std::size_t>(size[0]);
    const auto ny = static_cast<std::size_t>(size[1]);
    return { { static_cast<int>(node % nx), static_cast<int>(node / nx % ny), static_cast<int>(node / (nx * ny)) } };
  }

  /** Difference of the numbers of two nodes that lie (di,dj,dk) apart. */
  [[nodiscard]] std::ptrdiff_t
  stride(int di, int dj, int dk) const
  {
    const auto nx = static_cast<std::ptrdiff_t>(size[0]);
    const auto ny = static_cast<std::ptrdiff_t>(size[1]);
    return di + nx * (dj + ny * static_cast<std::ptrdiff_t>(dk));
  }

  /** On one of the six faces of the box: not all fourteen Kuhn neighbours exist. */
  [[nodiscard]] bool
  isBorder(int i, int j, int k) const
  {
    return i < 1 || j < 1 || k < 1 || i >= size[0] - 1 || j >= size[1] - 1 || k >= size[2] - 1;
  }

  /** The same for a node by its number. */
  [[nodiscard]] bool
  isBorder(std::size_t node) const
  {
    const Index index = indexOf(node);
    return isBorder(index[0], index[1], index[2]);
  }

  /** Position of node (i,j,k) [mm, LPS]. */
  [[nodiscard]] Vector3
  point(int i, int j, int k) const
  {
    return origin + direction * (spacing * Vector3(i, j, k));
  }

  /** Position of a node by its number [mm, LPS]. */
  [[nodiscard]] Vector3
  point(std::size_t node) const
  {
    const Index index = indexOf(node);
    return point(index[0], index[1], index[2]);
  }

  /** Inverse of point(): grid coordinates of an LPS point [nodes]. */
  [[nodiscard]] Vector3
  continuousIndex(const Vector3 & p) const
  {
    return direction.transpose() * (p - origin) / spacing;
  }

  /** spacing^3 [mm^3]. */
  [[nodiscard]] double
  cellVolume() const
  {
    return spacing * spacing * spacing;
  }
};

/** \throws InvalidInput unless there are at least 4 nodes along each axis and fewer than 2^31 in all, the spacing is
 * positive and finite, and the direction orthonormal within 1e-6. The message begins with `what`. */
void
requireValid(const RegularGrid & grid, const std::string & what);

} // namespace moserhex
