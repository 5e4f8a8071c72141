// Exact: what is in the page of a case. Skipped where the program is built without pages.
#include "CasePage.h"
#include "Histogram.h"
#include "PageName.h"
#include "ReportTest.h"
#include "SliceFigure.h"
#include "moserhex/Common/Errors.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

constexpr const char * hostile = "</script><img src=x onerror='alert(1)'>&\"";

class CasePage : public testing::Test
{
protected:
  void
  SetUp() override
  {
    if (!pagesAreBuilt())
    {
      GTEST_SKIP() << "MoserHex_BUILD_REPORTS is OFF";
    }
    m_Image = labelImageOf(boxLabel());
    m_Mesh = analytic::lattice(
      4, [](const Vector3 & i) { return Vector3(-2.0 + 1.1 * i[0], 13.0 + 1.7 * i[1], 106.0 + 4.5 * i[2]); });
    m_Content.report = goodReport();
    m_Content.image = m_Image;
    m_Content.labels = { { 1, 192, "organ" } };
    m_Content.mesh = &m_Mesh;
  }

  LabelImageType::Pointer m_Image;
  HexMesh                 m_Mesh;
  CaseContent             m_Content;
};

/** The page without its scripts and styles. */
std::string
markupOf(std::string page)
{
  for (const std::string name : { "script", "style" })
  {
    for (std::size_t begin = page.find("<" + name); begin != std::string::npos; begin = page.find("<" + name, begin))
    {
      const std::string end = "</" + name + ">";
      page.erase(begin, page.find(end, begin) + end.size() - begin);
    }
  }
  return page;
}

} // namespace

TEST_F(CasePage, HasAllItsParts)
{
  const std::string page = markupOf(casePage(m_Content));
  for (const char * id : { "trust", "slices", "view", "quality", "stages", "repair", "methods", "provenance" })
  {
    EXPECT_EQ(timesIn(page, std::string("<section id=\"") + id + "\""), 1u) << id;
  }
  EXPECT_EQ(timesIn(page, "<svg class=\"slice\""), 9u);
  EXPECT_EQ(timesIn(page, "<svg class=\"histogram\""), 4u);
  EXPECT_NE(page.find("MIT"), std::string::npos);
}

TEST_F(CasePage, HoldsTheReport)
{
  const std::string page = casePage(m_Content);
  const std::string begin = "<script type=\"application/json\" id=\"report-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  EXPECT_EQ(nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at)),
            nlohmann::json::parse(toJson(m_Content.report)));
}

TEST_F(CasePage, SaysHowItIsTiedToATemplate)
{
  EXPECT_EQ(casePage(m_Content).find("<section id=\"template\""), std::string::npos);
  m_Content.report.templateMesh = tieToTemplate();
  const std::string page = markupOf(casePage(m_Content));
  for (const char * part : { "<strong>base.vtu</strong>",
                             "an affine map of the surfaces: turned by 4.0 degrees and moved by 12.5 mm",
                             "1.02 times as large",
                             "<td>3.5</td><td>0.25</td>",
                             "<td>&ndash;</td><td>0.125</td>",
                             "<td>2.75</td><td>0.375</td>",
                             "<td>1.25</td><td>0.5</td>",
                             "SHA-256 of the landmarks of the template" })
  {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

TEST_F(CasePage, SaysWhatATemplateAloneDoesNotShow)
{
  m_Content.report.templateMesh =
    RunReport::Template{ { { "mesh", "base.vtu", "ff" } }, "none", {}, {}, {}, {}, {}, {} };
  const std::string page = markupOf(casePage(m_Content));
  EXPECT_NE(page.find("taken as it lies, in one space"), std::string::npos);
  EXPECT_EQ(page.find("one scan"), std::string::npos);
  EXPECT_NE(page.find("do not show where tissue went"), std::string::npos);
  m_Content.report.templateMesh->alignment = "file";
  EXPECT_NE(casePage(m_Content).find("by a transform from a file"), std::string::npos);
}

TEST_F(CasePage, SaysWhenTheLabelsOwnMeshWasDrawnToTheTemplate)
{
  m_Content.report.templateMesh = tieToTemplate();
  EXPECT_EQ(casePage(m_Content).find("the label's own mesh was drawn to it"), std::string::npos);
  m_Content.report.templateMesh->start = "own";
  EXPECT_NE(casePage(m_Content).find("the label's own mesh was drawn to it"), std::string::npos);
}

TEST_F(CasePage, SaysThatCellsWereFreeToGrow)
{
  m_Content.report.templateMesh = tieToTemplate();
  EXPECT_EQ(casePage(m_Content).find("free to grow"), std::string::npos);
  m_Content.report.templateMesh->growth = RunReport::Growth{ 0.75, 2.25, 0 };
  const std::string page = markupOf(casePage(m_Content));
  EXPECT_NE(page.find("Cells were free to grow as these show, by 0.75 to 2.2 times as much"), std::string::npos);
  EXPECT_NE(page.find("from 0.75 to 2.2"), std::string::npos); // the methods' text
  EXPECT_NE(page.find("Variance of the volumes over their growth"), std::string::npos);
  EXPECT_NE(page.find("Every cell has the same volume over its growth"), std::string::npos);
}

TEST_F(CasePage, EscapesEveryName)
{
  const std::size_t scripts = timesIn(casePage(m_Content), "</script>");
  RunReport &       report = m_Content.report;
  report.input.file = report.mesh.file = report.input.labelName = report.parameters.density = hostile;
  report.parameters.segment = hostile;
  report.stages.back().name = report.stages.back().note = hostile;
  report.warnings = { hostile };
  report.exact->shortcomings = { hostile };
  report.versions = { hostile, hostile, hostile, hostile, hostile };
  report.density = RunReport::Density{ hostile, hostile };
  report.templateMesh = RunReport::Template{ { { "mesh", hostile, hostile } }, "rigid", {}, {}, {}, {}, {}, {} };
  m_Content.labels.front().name = hostile;
  const std::string page = casePage(m_Content);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(timesIn(page, "</script>"), scripts);
  EXPECT_EQ(markupOf(page).find("onerror='"), std::string::npos);
}

TEST_F(CasePage, OfAFailureHasNoMesh)
{
  m_Content.report.failure = RunReport::Failure{ ErrorCode::Topology, hostile };
  m_Content.mesh = nullptr;
  const std::string page = casePage(m_Content);
  EXPECT_NE(page.find("Do not use"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("<canvas"), std::string::npos);
  EXPECT_EQ(timesIn(page, "<svg class=\"slice\""), 9u);
}

TEST_F(CasePage, OfAFileThatCouldNotBeReadHasNoSlices)
{
  m_Content = CaseContent{};
  m_Content.report.input.file = "missing.nrrd";
  m_Content.report.failure = RunReport::Failure{ ErrorCode::NoInput, "missing.nrrd: no such file" };
  const std::string page = markupOf(casePage(m_Content));
  EXPECT_EQ(page.find("<svg class=\"slice\""), std::string::npos);
  EXPECT_NE(page.find("missing.nrrd: no such file"), std::string::npos);
}

TEST_F(CasePage, ThatIsReproducibleHasNoTimes)
{
  EXPECT_NE(markupOf(casePage(m_Content)).find("Seconds"), std::string::npos);
  m_Content.report.reproducible = true;
  const std::string page = casePage(m_Content);
  EXPECT_EQ(markupOf(page).find("Seconds"), std::string::npos);
  EXPECT_EQ(page, casePage(m_Content));
}

TEST_F(CasePage, OfATooLargeMeshSaysSo)
{
  const HexMesh mesh = analytic::cubeLattice(66);
  m_Content.mesh = &mesh;
  const std::string page = casePage(m_Content);
  EXPECT_NE(page.find("too large for a page"), std::string::npos);
  EXPECT_EQ(page.find("<canvas"), std::string::npos);
}

TEST(Histogram, HatchesWhatIsNotAcceptable)
{
  CellField field{ "a", "A", "", { 0.1, 0.6, 0.7 }, CellField::Range{ 0.5, 1.0 }, { 0.0, 1.0 } };
  EXPECT_EQ(timesIn(histogramSvg(field), "class=\"bar outside\""), 1u);
  EXPECT_EQ(timesIn(histogramSvg(field), "class=\"bar\""), 2u);
  EXPECT_NE(histogramSvg(field).find("acceptable 0.5 to 1"), std::string::npos);
  EXPECT_NE(distributionList(field).find("66.67 % of the cells"), std::string::npos);
  field.acceptable.reset();
  EXPECT_EQ(histogramSvg(field).find("outside"), std::string::npos);
}

TEST(Histogram, OfNumbersThatAreTheSameButForRoundingHasAnAxis)
{
  for (const double value : { 1.0, -7.25e5, 3e-12, 0.0 })
  {
    const double    next = std::nextafter(value, 10.0 * value + 1.0);
    const CellField field{ "a", "A", "", { value, next, next }, {}, { value, next } };
    const auto      range = rangeOf(field);
    EXPECT_GT(range.high - range.low, 0.09 * std::abs(value));
    const std::size_t marks = timesIn(histogramSvg(field), "text-anchor");
    EXPECT_GE(marks, 2u) << value;
    EXPECT_LE(marks, 12u) << value;
  }
}

TEST(Histogram, OfZerosHasNoNegativeNumbers)
{
  const auto range = rangeOf({ "a", "A", "", { 0.0, 0.0 }, {}, { 0.0, 0.0 } });
  EXPECT_EQ(range.low, 0.0);
  EXPECT_EQ(range.high, 1.0);
}

TEST(Histogram, MeanThatIsNothingButRoundingIsZero)
{
  const std::string list = distributionList({ "a", "A", "", { -0.1, -0.2, 0.1 + 0.2 }, {}, { -1.0, 1.0 } });
  EXPECT_NE(list.find("<dt>mean</dt><dd>0</dd>"), std::string::npos) << list;
}

TEST(Slices, OfAnImageWithoutTheLabelAreNone)
{
  const auto image = labelImageOf(boxLabel());
  EXPECT_EQ(sliceFigures({ image, { { 2, 1, "" } }, nullptr }), "");
}

TEST(PageName, EndsInAnyCase)
{
  EXPECT_TRUE(isPageName("a.html"));
  EXPECT_TRUE(isPageName("b/A.HTM"));
  EXPECT_FALSE(isPageName("html"));
  EXPECT_FALSE(isPageName("a.html.json"));
  EXPECT_NO_THROW(requirePagesFor(""));
}

TEST(PageName, IsRefusedByAProgramWithoutPages)
{
  if (pagesAreBuilt())
  {
    EXPECT_NO_THROW(requirePagesFor("a.html"));
  }
  else
  {
    EXPECT_THROW(requirePagesFor("a.html"), InvalidInput);
    EXPECT_THROW((void)casePage({}), InvalidInput);
  }
}
