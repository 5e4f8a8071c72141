// Exact: one case for each label. Voxels: 1 (two of them) and 2 (one) in the middle of 60.
#include "CaseListTest.h"
#include "ImageText.h"
#include "LabelChoices.h"

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class AllLabels : public CaseListTest
{
protected:
  [[nodiscard]] CaseListOptions
  allLabelsOf(const std::vector<std::string> & inputs) const
  {
    CaseListOptions options = optionsFor(inputs);
    options.allLabels = true;
    return options;
  }

  [[nodiscard]] CaseList
  listAll(const std::vector<std::string> & inputs) const
  {
    return listCases(allLabelsOf(inputs));
  }

  /** Texts of the choices of a flat segmentation with these names of labels 1 and 2. */
  [[nodiscard]] Names
  textsOf(const std::string & first, const std::string & second) const
  {
    write("a.seg.nrrd", flat(first, second).file());
    InputOptions input;
    input.file = path("a.seg.nrrd");
    input.sandbox = false;
    Names texts;
    for (const LabelChoice & choice : labelChoicesOf(input))
    {
      texts.push_back(choice.text);
    }
    return texts;
  }

  [[nodiscard]] static ImageText
  flat(const std::string & first, const std::string & second)
  {
    return ImageText::nrrd()
      .withLine("Segment0_ID:=S1")
      .withLine("Segment0_Name:=" + first)
      .withLine("Segment0_LabelValue:=1")
      .withLine("Segment1_ID:=S2")
      .withLine("Segment1_Name:=" + second)
      .withLine("Segment1_LabelValue:=2");
  }

  /** Two layers: every labelled voxel is 1, and the labels themselves; the names of segments with their layers and
   * values. */
  void
  writeLayers(const std::string & name, const std::vector<std::tuple<std::string, int, int>> & segments) const
  {
    ImageText text = ImageText::nrrd()
                       .with("dimension", "4")
                       .with("sizes", "2 5 4 3")
                       .with("kinds", "list domain domain domain")
                       .with("space directions", "none (0.5,0,0) (0,0.75,0) (0,0,2)");
    for (std::size_t n = 0; n < segments.size(); ++n)
    {
      const auto & [segment, layer, value] = segments[n];
      const std::string prefix = "Segment" + std::to_string(n);
      text = text.withLine(prefix + "_ID:=S" + std::to_string(n + 1))
               .withLine(prefix + "_Name:=" + segment)
               .withLine(prefix + "_Layer:=" + std::to_string(layer))
               .withLine(prefix + "_LabelValue:=" + std::to_string(value));
    }
    std::string bytes;
    for (const char voxel : ImageText::voxels())
    {
      bytes += static_cast<char>(voxel ? 1 : 0);
      bytes += voxel;
    }
    write(name, text.header() + bytes);
  }
};

} // namespace

TEST_F(AllLabels, EachLabelIsACase)
{
  write("in/atlas.nrrd", ImageText::nrrd().file());
  const CaseList list = listAll({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "atlas_label-1.vtu", "atlas_label-2.vtu" }));
  EXPECT_EQ(list.cases[1].options.input.label, LabelValue{ 2 });
  EXPECT_FALSE(list.cases[1].options.input.segment);
  EXPECT_EQ(list.cases[1].options.output, path("out/atlas_label-2.vtu"));
  EXPECT_EQ(list.cases[1].options.reportFile, path("out/atlas_label-2.json"));
  EXPECT_EQ(list.cases[1].labelName, "");
}

TEST_F(AllLabels, TheSandboxReadsThemToo)
{
  write("in/atlas.nrrd", ImageText::nrrd().file());
  CaseListOptions options = allLabelsOf({ "in" });
  options.defaults.input.sandbox = true;
  EXPECT_EQ(listCases(options).cases.size(), 2u);
}

TEST_F(AllLabels, NamesOfLabelsStandInTheNamesOfMeshes)
{
  write("in/sub-01_dseg.seg.nrrd", flat("Left Putamen", "Gr\xC3\xBC\xC3\x9F-2").file());
  const CaseList list = listAll({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "sub-01_label-LeftPutamen_dseg.vtu", "sub-01_label-Gr2_dseg.vtu" }));
  EXPECT_EQ(list.cases[0].labelName, "Left Putamen");
  EXPECT_EQ(list.cases[1].options.input.label, LabelValue{ 2 });
}

TEST_F(AllLabels, TextsOfLabelsAreUnique)
{
  EXPECT_EQ(textsOf("Zone 1+", "Zone 1-"), (Names{ "Zone11", "Zone12" }));
  EXPECT_EQ(textsOf("WM", "wm"), (Names{ "WM1", "wm2" }));
  EXPECT_EQ(textsOf("\xE8\x82\x9D", "2"), (Names{ "1", "2" }));
  EXPECT_EQ(textsOf("2", "/../"), (Names{ "21", "22" }));
}

TEST_F(AllLabels, TextsStayUniqueWhenANumberMakesThemThoseOfOthers)
{
  writeLayers("in/a.seg.nrrd", { { "Z", 1, 1 }, { "Z ", 1, 2 }, { "Z1", 0, 1 } });
  EXPECT_EQ(namesOf(listAll({ "in" })), (Names{ "a_label-Z11.vtu", "a_label-Z2.vtu", "a_label-Z13.vtu" }));
}

TEST_F(AllLabels, SegmentsThatOverlapAreChosenByName)
{
  writeLayers("in/a.seg.nrrd", { { "Organ", 0, 1 }, { "Lesion", 1, 1 }, { "3", 1, 2 } });
  const CaseList list = listAll({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "a_label-Organ.vtu", "a_label-Lesion.vtu", "a_label-3.vtu" }));
  EXPECT_EQ(list.cases[1].options.input.segment, "Lesion");
  EXPECT_FALSE(list.cases[1].options.input.label);
  EXPECT_EQ(list.cases[1].labelName, "Lesion");
}

TEST_F(AllLabels, SegmentsThatShareANameAreChosenByIdOrNumber)
{
  writeLayers("in/a.seg.nrrd", { { "Cyst", 0, 1 }, { "Cyst", 1, 1 }, { "S1", 1, 2 } });
  const CaseList list = listAll({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "a_label-Cyst1.vtu", "a_label-Cyst2.vtu", "a_label-S1.vtu" }));
  EXPECT_EQ(list.cases[0].options.input.segment, "1"); // S1 is the name of another
  EXPECT_EQ(list.cases[1].options.input.segment, "S2");
  EXPECT_EQ(list.cases[2].options.input.segment, "S1");
  for (const BatchCase & one : list.cases)
  {
    EXPECT_EQ(readSolid(one.options.input).labels.size(), 1u);
  }
}

TEST_F(AllLabels, SegmentsWithoutVoxelsAreLeftOut)
{
  writeLayers("in/a.seg.nrrd", { { "Empty", 0, 9 }, { "Organ", 0, 1 }, { "Lesion", 1, 1 } });
  EXPECT_EQ(namesOf(listAll({ "in" })), (Names{ "a_label-Organ.vtu", "a_label-Lesion.vtu" }));
}

TEST_F(AllLabels, FilesThatCannotBeReadAndSurfacesAreOneCase)
{
  write("in/a.nrrd", ImageText::nrrd().header());
  write("in/b.nrrd", ImageText::nrrd().header() + std::string(60, '\0'));
  write("in/s.stl", "no surface");
  write("in/t.nrrd", ImageText::nrrd().with("dimension", "4").file());
  const CaseList list = listAll({ "in", "in/s.stl" });
  EXPECT_EQ(namesOf(list), (Names{ "a.vtu", "b.vtu", "t.vtu", "s.vtu" }));
  EXPECT_FALSE(list.cases[0].options.input.label);
}

TEST_F(AllLabels, RowsThatNameALabelKeepIt)
{
  write("a.nrrd", ImageText::nrrd().file());
  write("b.nrrd", ImageText::nrrd().file());
  write("c.nrrd", ImageText::nrrd().file());
  write("list.csv", "input,label,threshold,output\na.nrrd,2,,\nb.nrrd,,1,\nc.nrrd,,,x/mesh.msh\n");
  EXPECT_EQ(namesOf(listAll({ "list.csv" })), (Names{ "a.vtu", "b.vtu", "x/mesh_label-1.msh", "x/mesh_label-2.msh" }));
}

TEST_F(AllLabels, ARowMayAskForAllLabels)
{
  write("a.nrrd", ImageText::nrrd().file());
  write("b.nrrd", ImageText::nrrd().file());
  write("list.csv", "input,label,shells\na.nrrd,all,4\nb.nrrd,,\n");
  CaseListOptions options = optionsFor({ "list.csv" });
  options.defaults.input.label = 2;
  const CaseList list = listCases(options);
  EXPECT_EQ(namesOf(list), (Names{ "a_label-1.vtu", "a_label-2.vtu", "b.vtu" }));
  EXPECT_EQ(list.cases[0].options.input.label, LabelValue{ 1 });
  EXPECT_EQ(list.cases[0].options.shells, 4);
  EXPECT_EQ(list.cases[2].options.input.label, LabelValue{ 2 });
}

TEST_F(AllLabels, ARowThatAsksForAllLabelsHasNoOtherChoice)
{
  write("a.nrrd", ImageText::nrrd().file());
  write("list.csv", "input,label\na.nrrd,all\ndamaged.nrrd,all\n");
  CaseListOptions options = optionsFor({ "list.csv" });
  options.defaults.input.label = 2;
  options.defaults.input.threshold = 0.5;
  const CaseList list = listCases(options);
  EXPECT_EQ(namesOf(list), (Names{ "a_label-1.vtu", "a_label-2.vtu", "damaged.vtu" }));
  EXPECT_FALSE(list.cases[0].options.input.threshold);
  EXPECT_FALSE(list.cases[2].options.input.label);
}

TEST_F(AllLabels, NamesAreRefusedBeforeAnyFileIsRead)
{
  write("lists/list.csv", "input\n../a.nrrd\n");
  expectMentions(refusal(allLabelsOf({ "lists/list.csv" })), "the path leaves the output folder");
}

TEST_F(AllLabels, MeshesOfLabelsCollideLikeOthers)
{
  write("in/a.nrrd", ImageText::nrrd().file());
  write("in/a_label-1.nrrd", ImageText::nrrd().file());
  write("list.csv", "input,label\nin/a.nrrd,all\nin/a_label-1.nrrd,1\n");
  expectMentions(refusalOf({ "list.csv" }), "in/a_label-1.vtu: the mesh of ");
}
