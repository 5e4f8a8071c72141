#include "ComparisonFiles.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

double
at(const NamedArray & array, int cells, int i, int j, int k)
{
  return array.values.at(static_cast<std::size_t>(i + cells * (j + cells * k)));
}

} // namespace

TEST(ComparisonFiles, HalvesAreAnArrayForEachAxis)
{
  constexpr int cells = 5; // the plane between the halves goes through the middle ones
  const auto    arrays = regionArrays(chosenRegions({ "halves" }, cells + 1), cells + 1);
  ASSERT_EQ(arrays.size(), 3u);
  EXPECT_EQ(arrays[0].name, "HalvesRightLeft");
  EXPECT_EQ(arrays[1].name, "HalvesAnteriorPosterior");
  EXPECT_EQ(arrays[2].name, "HalvesInferiorSuperior");
  for (int n = 0; n < cells; ++n)
  {
    const double side = n < 2 ? 1.0 : n > 2 ? 2.0 : 0.0;
    EXPECT_EQ(at(arrays[0], cells, n, 1, 4), side);
    EXPECT_EQ(at(arrays[1], cells, 3, n, 2), side == 0.0 ? 0.0 : side + 2.0);
    EXPECT_EQ(at(arrays[2], cells, 0, 2, n), side == 0.0 ? 0.0 : side + 4.0);
  }
}

TEST(ComparisonFiles, OctantsAreOneArrayAndShellsNone)
{
  const auto arrays = regionArrays(chosenRegions({ "shells", "octants" }, 5), 5);
  ASSERT_EQ(arrays.size(), 1u);
  EXPECT_EQ(arrays[0].name, "Octants");
  EXPECT_EQ(arrays[0].values.front(), 1.0);
  EXPECT_EQ(arrays[0].values.back(), 8.0);
}
