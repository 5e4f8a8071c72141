#include "moserhex/DiscreteCalculus/CubeLatticeOperators.h"

#include "moserhex/Common/Errors.h"

#include <cmath>
#include <string>
#include <vector>

namespace moserhex
{
namespace
{
using Triplet = Eigen::Triplet<double>;
using Index3 = std::array<int, 3>;

Index3
boxSize(int n, const std::array<bool, 3> & shortened)
{
  return { n - (shortened[0] ? 1 : 0), n - (shortened[1] ? 1 : 0), n - (shortened[2] ? 1 : 0) };
}

std::size_t
boxCount(const Index3 & size)
{
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
}

std::size_t
boxNumber(const Index3 & size, const Index3 & at)
{
  return static_cast<std::size_t>(at[0]) +
         static_cast<std::size_t>(size[0]) *
           (static_cast<std::size_t>(at[1]) + static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(at[2]));
}

/** Edges along `axis` fill a box that is one shorter along that axis. */
Index3
edgeBox(int n, int axis)
{
  return boxSize(n, { axis == 0, axis == 1, axis == 2 });
}

/** Faces with normal `axis` fill a box that is one shorter along the two other axes. */
Index3
faceBox(int n, int axis)
{
  return boxSize(n, { axis != 0, axis != 1, axis != 2 });
}

Index3
shifted(Index3 at, int axis)
{
  ++at[static_cast<std::size_t>(axis)];
  return at;
}

/** Runs body(at) over a box, first index fastest. */
template <typename TBody>
void
forEach(const Index3 & size, TBody body)
{
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        body(Index3{ i, j, k });
      }
    }
  }
}

CubeLatticeOperators::SparseMatrix
sparse(std::size_t rows, std::size_t columns, const std::vector<Triplet> & triplets)
{
  CubeLatticeOperators::SparseMatrix matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Triplet
entry(std::size_t row, std::size_t column, double value)
{
  return { static_cast<int>(row), static_cast<int>(column), value };
}
} // namespace

CubeLatticeOperators::CubeLatticeOperators(int nodesPerSide, double spacing) : m_N(nodesPerSide), m_Spacing(spacing)
{
  if (nodesPerSide < 2)
  {
    throw InvalidInput("nodes per side " + std::to_string(nodesPerSide) + ", must be at least 2");
  }
  if (!(spacing > 0.0) || !std::isfinite(spacing))
  {
    throw InvalidInput("lattice spacing " + std::to_string(spacing) + ", must be positive and finite");
  }
}

std::size_t
CubeLatticeOperators::nodeCount() const
{
  return boxCount({ m_N, m_N, m_N });
}

std::size_t
CubeLatticeOperators::edgeCount() const
{
  return 3 * boxCount(edgeBox(m_N, 0));
}

std::size_t
CubeLatticeOperators::faceCount() const
{
  return 3 * boxCount(faceBox(m_N, 0));
}

std::size_t
CubeLatticeOperators::cellCount() const
{
  return boxCount({ m_N - 1, m_N - 1, m_N - 1 });
}

std::size_t
CubeLatticeOperators::nodeNumber(int i, int j, int k) const
{
  return boxNumber({ m_N, m_N, m_N }, { i, j, k });
}

std::size_t
CubeLatticeOperators::edgeNumber(int axis, int i, int j, int k) const
{
  const Index3 box = edgeBox(m_N, axis);
  return static_cast<std::size_t>(axis) * boxCount(box) + boxNumber(box, { i, j, k });
}

std::size_t
CubeLatticeOperators::faceNumber(int axis, int i, int j, int k) const
{
  const Index3 box = faceBox(m_N, axis);
  return static_cast<std::size_t>(axis) * boxCount(box) + boxNumber(box, { i, j, k });
}

std::size_t
CubeLatticeOperators::cellNumber(int i, int j, int k) const
{
  return boxNumber({ m_N - 1, m_N - 1, m_N - 1 }, { i, j, k });
}

CubeLatticeOperators::SparseMatrix
CubeLatticeOperators::d0() const
{
  std::vector<Triplet> triplets;
  triplets.reserve(2 * edgeCount());
  for (int axis = 0; axis < 3; ++axis)
  {
    forEach(edgeBox(m_N, axis), [&](const Index3 & at) {
      const std::size_t edge = edgeNumber(axis, at[0], at[1], at[2]);
      const Index3      end = shifted(at, axis);
      triplets.push_back(entry(edge, nodeNumber(at[0], at[1], at[2]), -1.0));
      triplets.push_back(entry(edge, nodeNumber(end[0], end[1], end[2]), 1.0));
    });
  }
  return sparse(edgeCount(), nodeCount(), triplets);
}

CubeLatticeOperators::SparseMatrix
CubeLatticeOperators::d1() const
{
  std::vector<Triplet> triplets;
  triplets.reserve(4 * faceCount());
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    forEach(faceBox(m_N, axis), [&](const Index3 & at) {
      const std::size_t face = faceNumber(axis, at[0], at[1], at[2]);
      const Index3      right = shifted(at, first);
      const Index3      up = shifted(at, second);
      triplets.push_back(entry(face, edgeNumber(first, at[0], at[1], at[2]), 1.0));
      triplets.push_back(entry(face, edgeNumber(second, right[0], right[1], right[2]), 1.0));
      triplets.push_back(entry(face, edgeNumber(first, up[0], up[1], up[2]), -1.0));
      triplets.push_back(entry(face, edgeNumber(second, at[0], at[1], at[2]), -1.0));
    });
  }
  return sparse(faceCount(), edgeCount(), triplets);
}

CubeLatticeOperators::SparseMatrix
CubeLatticeOperators::d2() const
{
  std::vector<Triplet> triplets;
  triplets.reserve(6 * cellCount());
  forEach({ m_N - 1, m_N - 1, m_N - 1 }, [&](const Index3 & at) {
    const std::size_t cell = cellNumber(at[0], at[1], at[2]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Index3 far = shifted(at, axis);
      triplets.push_back(entry(cell, faceNumber(axis, at[0], at[1], at[2]), -1.0));
      triplets.push_back(entry(cell, faceNumber(axis, far[0], far[1], far[2]), 1.0));
    }
  });
  return sparse(cellCount(), faceCount(), triplets);
}

namespace
{
/** Length of the dual of a lattice position along one axis: half a spacing at either end. */
double
dualLength(int n, int index)
{
  return index == 0 || index == n - 1 ? 0.5 : 1.0;
}
} // namespace

Eigen::VectorXd
CubeLatticeOperators::star0() const
{
  Eigen::VectorXd star(static_cast<Eigen::Index>(nodeCount()));
  Eigen::Index    node = 0;
  forEach({ m_N, m_N, m_N }, [&](const Index3 & at) {
    star[node++] = dualLength(m_N, at[0]) * dualLength(m_N, at[1]) * dualLength(m_N, at[2]);
  });
  return star * (m_Spacing * m_Spacing * m_Spacing);
}

Eigen::VectorXd
CubeLatticeOperators::star1() const
{
  Eigen::VectorXd star(static_cast<Eigen::Index>(edgeCount()));
  Eigen::Index    edge = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    forEach(edgeBox(m_N, axis), [&](const Index3 & at) {
      star[edge++] = dualLength(m_N, at[static_cast<std::size_t>((axis + 1) % 3)]) *
                     dualLength(m_N, at[static_cast<std::size_t>((axis + 2) % 3)]);
    });
  }
  return star * m_Spacing;
}

Eigen::VectorXd
CubeLatticeOperators::star2() const
{
  Eigen::VectorXd star(static_cast<Eigen::Index>(faceCount()));
  Eigen::Index    face = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    forEach(faceBox(m_N, axis),
            [&](const Index3 & at) { star[face++] = dualLength(m_N, at[static_cast<std::size_t>(axis)]); });
  }
  return star / m_Spacing;
}

Eigen::VectorXd
CubeLatticeOperators::star3() const
{
  return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(cellCount()), 1.0 / (m_Spacing * m_Spacing * m_Spacing));
}

Eigen::VectorXd
CubeLatticeOperators::interiorFaces() const
{
  Eigen::VectorXd mask(static_cast<Eigen::Index>(faceCount()));
  Eigen::Index    face = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    forEach(faceBox(m_N, axis), [&](const Index3 & at) {
      const int index = at[static_cast<std::size_t>(axis)];
      mask[face++] = index > 0 && index < m_N - 1 ? 1.0 : 0.0;
    });
  }
  return mask;
}

CubeLatticeOperators::SparseMatrix
CubeLatticeOperators::fluxFromPotential() const
{
  const Eigen::VectorXd inverseStar2 = interiorFaces().cwiseQuotient(star2());
  const SparseMatrix    transposedD2 = d2().transpose();
  SparseMatrix          flux = inverseStar2.asDiagonal() * transposedD2;
  flux.prune(0.0);
  return flux;
}

} // namespace moserhex
