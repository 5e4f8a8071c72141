// Exact: colours as texts.
#include "ColourScale.h"

#include <gtest/gtest.h>

using namespace moserhex::app;

TEST(ColourScale, EndsAndMiddleAreViridis)
{
  EXPECT_EQ(cssColour(sequentialScale().at(0.0)), "#440154");
  EXPECT_EQ(cssColour(sequentialScale().at(0.5)), "#21918c");
  EXPECT_EQ(cssColour(sequentialScale().at(1.0)), "#fde725");
}

TEST(ColourScale, BeyondTheEndsIsTheEnd)
{
  EXPECT_EQ(cssColour(sequentialScale().at(-0.1)), "#440154");
  EXPECT_EQ(cssColour(sequentialScale().at(7.0)), "#fde725");
}

TEST(ColourScale, BetweenStopsIsAStraightLine)
{
  const ColourScale scale({ fromHexadecimal(0x000000), fromHexadecimal(0x6400c8) });
  EXPECT_EQ(cssColour(scale.at(0.25)), "#190032");
}
