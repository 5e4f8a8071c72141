// Exact: nodes are copied, and moved by a translation of whole numbers.
#include "moserhex/Correspondence/BoundaryLandmarks.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Common/Errors.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

Vector3
moved(const Vector3 & p)
{
  return p + Vector3(1.0, 2.0, -3.0);
}

} // namespace

TEST(BoundaryLandmarks, AreDifferentBoundaryNodesAndWhereTheyGo)
{
  const HexMesh baseline = cubeLattice(5, 1.0);
  const auto    landmarks = boundaryLandmarks(baseline, moved, 40);
  ASSERT_EQ(landmarks.size(), 40u);
  std::set<std::size_t>          found;
  const std::vector<std::size_t> nodes = boundaryNodes(baseline);
  for (const CorrespondingPoints & landmark : landmarks)
  {
    EXPECT_EQ(landmark.onSolid, moved(landmark.onTemplate));
    const auto node =
      std::find_if(nodes.begin(), nodes.end(), [&](std::size_t b) { return baseline.nodes[b] == landmark.onTemplate; });
    ASSERT_NE(node, nodes.end());
    found.insert(*node);
  }
  EXPECT_EQ(found.size(), 40u);
}

TEST(BoundaryLandmarks, OfAllNodesAreAllInTheirOrder)
{
  const HexMesh                  baseline = cubeLattice(3, 1.0);
  const std::vector<std::size_t> nodes = boundaryNodes(baseline);
  const auto                     landmarks = boundaryLandmarks(baseline, moved, nodes.size());
  for (std::size_t l = 0; l < nodes.size(); ++l)
  {
    EXPECT_EQ(landmarks[l].onTemplate, baseline.nodes[nodes[l]]);
  }
}

TEST(BoundaryLandmarks, RefusesNoneAndMoreThanThereAre)
{
  EXPECT_THROW((void)boundaryLandmarks(cubeLattice(3, 1.0), moved, 0), InvalidInput);
  EXPECT_THROW((void)boundaryLandmarks(cubeLattice(3, 1.0), moved, 27), InvalidInput);
}
