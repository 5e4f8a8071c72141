// Exact: which run is judged how, and by which reason.
#include "Assessment.h"
#include "MethodsText.h"
#include "ReportTest.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

/** The text of the worst reason. */
std::string
firstReason(const RunReport & report)
{
  return assess(report).reasons.at(0).text;
}

} // namespace

TEST(Assessment, OfARunThatReachedAllIsTrust)
{
  const Assessment assessment = assess(goodReport());
  EXPECT_EQ(assessment.trust, Trust::Trust);
  EXPECT_EQ(assessment.reasons.size(), 6u);
  EXPECT_STREQ(nameOf(assessment.trust), "Trust");
}

TEST(Assessment, OfAFailureIsDoNotUseWithItsMessage)
{
  RunReport report = goodReport();
  report.failure = RunReport::Failure{ ErrorCode::Topology, "organ.nrrd: two handles" };
  EXPECT_EQ(assess(report).trust, Trust::DoNotUse);
  EXPECT_EQ(firstReason(report), "There is no mesh: organ.nrrd: two handles [E_TOPOLOGY]");
}

TEST(Assessment, OfUncertifiedCellsIsDoNotUse)
{
  RunReport report = goodReport();
  report.exact->certified = false;
  report.exact->uncertifiedCells = 3;
  EXPECT_EQ(assess(report).trust, Trust::DoNotUse);
  EXPECT_NE(firstReason(report).find("3 cells are not certified"), std::string::npos);
}

TEST(Assessment, OfUnequalVolumesIsLookAtIt)
{
  RunReport report = goodReport();
  report.exact->reached = false;
  report.exact->shortcomings = { "variance 1e-5" };
  EXPECT_EQ(assess(report).trust, Trust::LookAtIt);
  EXPECT_EQ(firstReason(report), "Not exact: variance 1e-5.");
}

TEST(Assessment, OfAnEarlierStageDependsOnConcaveCells)
{
  RunReport report = goodReport();
  report.parameters.stage = "moser";
  report.exact.reset();
  EXPECT_EQ(assess(report).trust, Trust::LookAtIt);
  report.stages.back().quality->concavePercent = 0.1;
  EXPECT_EQ(assess(report).trust, Trust::DoNotUse);
  EXPECT_NE(firstReason(report).find("0.1 % of them are concave"), std::string::npos);
}

TEST(Assessment, LooksAtLargeRepairsOnly)
{
  RunReport report = goodReport();
  report.conditioning->changes = { TopologyChange{ TopologyChangeKind::HandleCut, 0, 1, 5, Vector3::Zero() } };
  report.conditioning->changedPercent = 0.9;
  EXPECT_EQ(assess(report).trust, Trust::Trust);
  report.conditioning->changedPercent = 1.1;
  EXPECT_EQ(assess(report).trust, Trust::LookAtIt);
  EXPECT_NE(firstReason(report).find("1.1 %"), std::string::npos);
}

TEST(Assessment, LooksAtDiceVolumeAndDistance)
{
  RunReport report = goodReport();
  report.conditioning->dice = 0.979;
  EXPECT_NE(firstReason(report).find("0.9790, less than 0.98"), std::string::npos);
  report = goodReport();
  report.mesh.volume = 1011.0;
  EXPECT_NE(firstReason(report).find("1.1 % off"), std::string::npos);
  report.conditioning->voxelsAdded = 11; // of a repair that the mesh follows
  EXPECT_EQ(assess(report).trust, Trust::Trust);
  report = goodReport();
  report.surface->maximum = 1.01;
  EXPECT_NE(firstReason(report).find("more than the longest side of a voxel"), std::string::npos);
}

TEST(Assessment, LooksAtEveryWarning)
{
  RunReport report = goodReport();
  report.warnings = { "turned", "touches the border" };
  EXPECT_EQ(assess(report).trust, Trust::LookAtIt);
  EXPECT_EQ(firstReason(report), "Warning: turned");
  EXPECT_EQ(assess(report).reasons.size(), 8u);
}

TEST(MethodsText, CitesInTheOrderOfItsNumbers)
{
  const MethodsText text = methodsText(goodReport());
  EXPECT_EQ(text.references.size(), 5u);
  EXPECT_EQ(text.references[0].substr(0, 8), "Sandhu R");
  for (std::size_t number = 1; number <= text.references.size(); ++number)
  {
    EXPECT_NE(text.paragraph.find("[" + std::to_string(number) + "]"), std::string::npos) << number;
  }
  EXPECT_EQ(text.paragraph.find("[6]"), std::string::npos);
  EXPECT_NE(text.paragraph.find("MoserHex 1.2.3"), std::string::npos);
}

TEST(MethodsText, SaysOfAnUnreachedGoalNothing)
{
  RunReport report = goodReport();
  report.exact->reached = false;
  EXPECT_EQ(methodsText(report).paragraph.find("same volume"), std::string::npos);
}

TEST(MethodsText, SaysHowATemplateWasUsed)
{
  RunReport report = goodReport();
  report.templateMesh = tieToTemplate();
  const MethodsText text = methodsText(report);
  EXPECT_NE(
    text.paragraph.find("by an affine map and scaled to its volume (surfaces 3.5 mm apart before and 0.25 mm after"),
    std::string::npos)
    << text.paragraph;
  EXPECT_NE(text.paragraph.find("bent to fill it"), std::string::npos);
  EXPECT_NE(text.paragraph.find("landmarks drew it from 2.8 to 0.38 mm"), std::string::npos);
  EXPECT_NE(text.paragraph.find("difference of 1.2 to 0.5 standard deviations"), std::string::npos);
  EXPECT_EQ(text.paragraph.find("conformally"), std::string::npos);
}

TEST(MethodsText, DoesNotSayOfATemplateThatLayThereThatBothAreOfOneScan)
{
  RunReport report = goodReport();
  report.templateMesh = tieToTemplate();
  report.templateMesh->alignment = "none";
  report.templateMesh->aligned.reset();
  const std::string text = methodsText(report).paragraph;
  EXPECT_NE(text.find("taken as it lay, in one space with the label, and scaled to its volume (surfaces 0.25 mm apart"),
            std::string::npos)
    << text;
  EXPECT_EQ(text.find("scan"), std::string::npos) << text;
}

TEST(MethodsText, SaysWhenTheLabelsOwnMeshWasDrawnToTheTemplate)
{
  RunReport report = goodReport();
  report.templateMesh = tieToTemplate();
  report.templateMesh->start = "own";
  const MethodsText text = methodsText(report);
  EXPECT_EQ(text.paragraph.find("bent to fill"), std::string::npos) << text.paragraph;
  EXPECT_NE(text.paragraph.find("Its nodes were then drawn towards those of a template mesh"), std::string::npos)
    << text.paragraph;
  EXPECT_NE(text.paragraph.find("conformally"), std::string::npos);
  EXPECT_NE(text.paragraph.find("landmarks drew it from 2.8 to 0.38 mm"), std::string::npos);
}
