// Exact: which placements are doubted. The ball of the volume has a radius of 20 mm.
#include "TemplateWarnings.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

const double volume = 4.0 / 3.0 * pi * 8000.0;

std::vector<std::string>
warningsOn(const TemplateFit & fit, bool isAligned = false)
{
  RunReport::Template tied;
  if (isAligned)
  {
    tied.aligned = RunReport::Alignment{};
  }
  return templateWarnings(fit, tied, volume);
}

} // namespace

TEST(TemplateWarnings, AGoodPlacementHasNone)
{
  EXPECT_TRUE(warningsOn({ 0.6, 6.0, 4.9, {} }).empty());
  EXPECT_TRUE(warningsOn({ 1.9, 1.0, 0.9, 0.1 }).empty());
  EXPECT_TRUE(warningsOn({ 1.0, 3.0, 2.0, 1.1 }).empty());
}

TEST(TemplateWarnings, ATemplateThatIsFarAwayIsDoubted)
{
  const std::vector<std::string> asItLies = warningsOn({ 1.0, 6.0, 5.1, {} });
  ASSERT_EQ(asItLies.size(), 1u);
  EXPECT_NE(asItLies[0].find("5.1 mm"), std::string::npos) << asItLies[0];
  EXPECT_NE(asItLies[0].find("--align rigid"), std::string::npos) << asItLies[0];
  const std::vector<std::string> aligned = warningsOn({ 1.0, 6.0, 5.1, {} }, true);
  ASSERT_EQ(aligned.size(), 1u);
  EXPECT_EQ(aligned[0].find("--align rigid"), std::string::npos) << aligned[0];
}

TEST(TemplateWarnings, ATransformTheWrongWayRoundIsNamed)
{
  for (const double median : { 1.5, 9.0 })
  {
    const std::vector<std::string> warnings = warningsOn({ 1.0, 2.0, median, 0.4 });
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("the inverse of the transform"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("--align"), std::string::npos) << warnings[0];
  }
}

TEST(TemplateWarnings, ATemplateInAnotherUnitIsDoubted)
{
  for (const double scale : { 0.1, 0.49, 2.1, 10.0 })
  {
    const std::vector<std::string> warnings = warningsOn({ scale, 1.0, 0.5, {} });
    ASSERT_EQ(warnings.size(), 1u) << scale;
    EXPECT_NE(warnings[0].find("--template in millimetres"), std::string::npos) << warnings[0];
  }
}
