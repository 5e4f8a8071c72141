// Ellipsoids of other proportions than the reference. Exact: what is promised of every mesh; distances are compared.
#include "ReferenceTie.h"

#include "FrameSearch.h"
#include "OrderedEllipsoid.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;

namespace
{

class ReferenceTieTest : public ::testing::Test
{
protected:
  [[nodiscard]] ReferenceTie
  tie() const
  {
    return ReferenceTie(m_Reference.nodes, m_Solid.volume, m_Volumes, equalisationOptions(withShells(4)));
  }

  /** Of boundary nodes from their places [mm]. */
  [[nodiscard]] double
  rmsOf(const HexMesh & mesh) const
  {
    const std::vector<std::size_t> nodes = boundaryNodes(mesh);
    double                         sum = 0.0;
    for (const std::size_t node : nodes)
    {
      sum += (mesh.nodes[node] - m_Reference.nodes[node]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(nodes.size()));
  }

  /** Of a mean cell [mm]. */
  [[nodiscard]] double
  halfAnEdge() const
  {
    return 0.5 * std::cbrt(m_Solid.volume / static_cast<double>(m_Reference.cellCount()));
  }

  static HexMesh
  meshOf(const OrderedSolid & solid)
  {
    return meshSolid(solid.ordering, solid.phi, solid.volume, withShells(4)).mesh;
  }

  OrderedSolid      m_Solid{ ellipsoid(Vector3(18.0, 10.0, 10.0), 0.75) };
  HexMesh           m_Reference{ meshOf(ellipsoid(Vector3(15.0, 12.0, 10.0), 0.75)) }; ///< of the same volume
  CubicInterpolator m_Phi{ m_Solid.phi };
  VolumeMeasure     m_Volumes;
};

} // namespace

TEST_F(ReferenceTieTest, StrongTiesAreTriedFirst)
{
  ReferenceTie             tied = tie();
  const EqualisationResult result = tied.tied(m_Reference, signedDistance(m_Phi), {});
  EXPECT_TRUE(result.exact);
  ASSERT_FALSE(tied.attempts().empty());
  EXPECT_EQ(tied.attempts().front().rfind("weights 10, 40: ", 0), 0u) << tied.attempts().front();
}

TEST_F(ReferenceTieTest, AnExactMeshIsDrawnNearerWhileItStaysExact)
{
  const HexMesh                           own = meshOf(m_Solid);
  ReferenceTie                            tied = tie();
  const std::optional<EqualisationResult> drawn = tied.drawn(own, signedDistance(m_Phi), {});
  ASSERT_TRUE(drawn);
  EXPECT_TRUE(drawn->exact);
  EXPECT_LT(rmsOf(drawn->mesh), rmsOf(own));
  EXPECT_EQ(tied.attempts().front(), "weights 0.1, 0: exact");
}

TEST_F(ReferenceTieTest, StartingFromAnywhereTheBestIsReturnedThoughNotExact)
{
  EqualisationOptions options = equalisationOptions(withShells(4));
  options.surfaceTolerance = 1e-9; // no mesh reaches it
  ReferenceTie             tied(m_Reference.nodes, m_Solid.volume, m_Volumes, options);
  const EqualisationResult result = tied.tied(m_Reference, signedDistance(m_Phi), {});
  EXPECT_FALSE(result.exact);
  EXPECT_FALSE(result.shortcomings.empty());
  EXPECT_EQ(tied.attempts().size(), 7u);
  EXPECT_FALSE(tied.drawn(m_Reference, signedDistance(m_Phi), {}));
}

TEST_F(ReferenceTieTest, ABoundaryThatIsPulledStaysWithinHalfAnEdgeOfTheSurface)
{
  EqualisationOptions options = equalisationOptions(withShells(4));
  options.surfaceTolerance = 5.0;
  const HexMesh            other = meshOf(ellipsoid(Vector3(8.0, 16.0, 14.0), 0.75));
  ReferenceTie             tied(other.nodes, m_Solid.volume, m_Volumes, options);
  const EqualisationResult result = tied.tied(other, signedDistance(m_Phi), {});
  EXPECT_TRUE(result.exact);
  EXPECT_LE(result.largestDistance, halfAnEdge());
  EXPECT_EQ(tied.attempts().front().rfind("weights 10, 40: exact within 1.40", 0), 0u) << tied.attempts().front();
}

TEST_F(ReferenceTieTest, WhereNoMeshComesThatNearTheToleranceOfTheOptionsHolds)
{
  EqualisationOptions options = equalisationOptions(withShells(4));
  options.surfaceTolerance = 100.0;
  options.directStages = { { 0.05, 20.0, 1e-6, 60 } }; // nothing holds the boundary on the surface
  options.repairRounds = 0;
  ReferenceTie                            tied(m_Reference.nodes, m_Solid.volume, m_Volumes, options);
  const std::optional<EqualisationResult> drawn = tied.drawn(meshOf(m_Solid), signedDistance(m_Phi), {});
  ASSERT_TRUE(drawn);
  EXPECT_EQ(tied.attempts()[0].rfind("weights 0.1, 0: not exact within 1.40", 0), 0u) << tied.attempts()[0];
  EXPECT_EQ(tied.attempts()[1], "weights 0.1, 0: exact within 100 mm");
  EXPECT_GT(drawn->largestDistance, halfAnEdge());
}
