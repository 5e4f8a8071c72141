// Round trips: bit for bit where the unit is a power of two; numbering: exact.
#include "LatticeVector.h"

#include "TestEnergies.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::testing;

TEST(LatticeLayout, CornersOfACellAreThoseOfTheMesh)
{
  constexpr std::size_t vtkCorner[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  for (const int n : { 2, 3, 7 })
  {
    const HexMesh       mesh = regularLattice(n);
    const LatticeLayout layout(n);
    for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
    {
      for (std::size_t a = 0; a < 8; ++a)
      {
        EXPECT_EQ(layout.firstNode(cell) + layout.corner[a], mesh.cellNodes(cell)[vtkCorner[a]]) << n << " " << cell;
      }
    }
    EXPECT_EQ(layout.cellStarts, layout.firstNode(mesh.cellCount() - 1) + 1);
  }
}

TEST(LatticeVector, PositionsComeBack)
{
  const HexMesh         mesh = unitCells(5, 0.4, 1);
  const LatticeLayout   layout(5);
  const Vector3         origin(1.0, -2.0, 0.5);
  const Eigen::VectorXd x = latticeVector(layout, mesh.nodes, origin, 4.0);
  const Positions       back = latticePositions(layout, x, origin, 4.0);
  for (std::size_t node = 0; node < back.size(); ++node)
  {
    EXPECT_LT((back[node] - mesh.nodes[node]).norm(), 1e-15 * 10.0);
    EXPECT_EQ(layout.at(x, node), (mesh.nodes[node] - origin) / 4.0);
  }
}

TEST(LatticeVector, PaddingIsZeroAndCanBeCleared)
{
  const LatticeLayout   layout(3);
  const Eigen::VectorXd x = vectorOf(unitCells(3, 0.3, 2));
  Eigen::VectorXd       spoilt = x;
  for (std::size_t component = 0; component < 3; ++component)
  {
    for (std::size_t entry = layout.nodes; entry < layout.stride; ++entry)
    {
      EXPECT_EQ(x[static_cast<Eigen::Index>(component * layout.stride + entry)], 0.0);
      spoilt[static_cast<Eigen::Index>(component * layout.stride + entry)] = 7.0;
    }
  }
  layout.clearPadding(spoilt);
  EXPECT_EQ(spoilt, x);
}

TEST(LatticeSlabs, EveryCellStartIsVisitedOnce)
{
  for (const int n : { 2, 3, 8, 14, 17 })
  {
    const LatticeLayout layout(n);
    std::vector<int>    visits(layout.cellStarts, 0);
    std::vector<int>    slabs(slabCount(layout), 0);
    forEachSlab(layout, 3, [&](std::size_t slab, std::size_t begin, std::size_t end) {
      ++slabs[slab];
      for (std::size_t p = begin; p < end; ++p)
      {
        ++visits[p];
      }
    });
    EXPECT_EQ(visits, std::vector<int>(layout.cellStarts, 1)) << n;
    EXPECT_EQ(slabs, std::vector<int>(slabCount(layout), 1)) << n;
  }
}

TEST(LatticeSlabs, SlabsOfOneColourShareNoNodeEvenByMaskedLanes)
{
  for (const int n : { 14, 17, 64 }) // from 14 on slabs run side by side
  {
    const LatticeLayout                              layout(n);
    std::vector<std::pair<std::size_t, std::size_t>> touched(slabCount(layout));
    forEachSlab(layout, 1, [&](std::size_t slab, std::size_t begin, std::size_t end) {
      const std::size_t blocks = (end - begin + latticePadding - 1) / latticePadding;
      touched[slab] = { begin, begin + blocks * latticePadding + layout.corner[7] };
    });
    for (std::size_t slab = 2; slab < touched.size(); ++slab)
    {
      EXPECT_LE(touched[slab - 2].second, touched[slab].first) << n;
    }
    EXPECT_LE(touched.back().second, layout.stride);
  }
}
