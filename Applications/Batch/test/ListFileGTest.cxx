// Exact: rows of lists as cases.
#include "CaseListTest.h"

#include "moserhex/HexMeshIO/FileErrors.h"

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

class ListFile : public CaseListTest
{
protected:
  [[nodiscard]] CaseList
  listOfRows(const std::string & text, const std::string & name = "lists/list.csv") const
  {
    write(name, text);
    return listOf({ name });
  }

  [[nodiscard]] std::string
  refusalOfRows(const std::string & text) const
  {
    write("lists/list.csv", text);
    return refusalOf({ "lists/list.csv" });
  }
};

} // namespace

TEST_F(ListFile, InputsAreRelativeToTheListAndOutputsToTheOutputFolder)
{
  touch({ "lists/x/a.nrrd", "b.nrrd" });
  const CaseList list = listOfRows("input,output\nx/a.nrrd,\n../b.nrrd,deep/./c.msh\n" + path("b.nrrd") + ",d.vtu\n");
  EXPECT_EQ(namesOf(list), (Names{ "x/a.vtu", "deep/c.msh", "d.vtu" }));
  EXPECT_EQ(list.cases[0].options.input.file, path("lists/x/a.nrrd"));
  EXPECT_EQ(list.cases[1].options.input.file, path("lists/../b.nrrd"));
  EXPECT_EQ(list.cases[1].options.output, path("out/deep/c.msh"));
  EXPECT_EQ(list.cases[1].options.reportFile, path("out/deep/c.json"));
  EXPECT_EQ(list.cases[2].options.input.file, path("b.nrrd"));
  EXPECT_TRUE(list.warnings.empty());
}

TEST_F(ListFile, EveryOptionOfMeshMayBeAColumn)
{
  touch({ "lists/a.nrrd", "lists/d.nrrd" });
  const CaseList list =
    listOfRows("input,label,shells,padding,topology,max-repair,stage,way,frame,density,shell-method,allow-partial,"
               "no-sandbox,segment\na.nrrd,2,5,1,reject,7.5,exact,faithful,ridge,d.nrrd,eikonal,true,true,Left one\n");
  const MeshCommandOptions & options = list.cases.at(0).options;
  EXPECT_EQ(options.input.label, LabelValue{ 2 });
  EXPECT_EQ(options.input.segment, "Left one");
  EXPECT_FALSE(options.input.sandbox);
  EXPECT_EQ(options.shells, 5);
  EXPECT_EQ(options.padding, 1);
  EXPECT_EQ(options.topology, "reject");
  EXPECT_EQ(options.maximumRepairPercent, 7.5);
  EXPECT_EQ(options.way, "faithful");
  EXPECT_EQ(options.frame, "ridge");
  EXPECT_EQ(options.density, path("lists/d.nrrd"));
  EXPECT_EQ(options.shellMethod, "eikonal");
  EXPECT_TRUE(options.allowPartial);
}

TEST_F(ListFile, EmptyCellsAndNotAvailableLeaveTheDefault)
{
  touch({ "lists/a.nrrd", "lists/b.nrrd", "lists/c.nrrd" });
  write("lists/list.tsv", "input\tshells\tlabel\na.nrrd\t\t1\nb.nrrd\tn/a\tn/a\nc.nrrd\t4\t2\n");
  CaseListOptions options = optionsFor({ "lists/list.tsv" });
  options.defaults.shells = 7;
  options.defaults.input.label = 9;
  const CaseList list = listCases(options);
  EXPECT_EQ(list.cases.at(0).options.shells, 7);
  EXPECT_EQ(list.cases.at(0).options.input.label, LabelValue{ 1 });
  EXPECT_EQ(list.cases.at(1).options.shells, 7);
  EXPECT_EQ(list.cases.at(1).options.input.label, LabelValue{ 9 });
  EXPECT_EQ(list.cases.at(2).options.shells, 4);
}

TEST_F(ListFile, ATextNamesOneFileALine)
{
  touch({ "lists/#a, b.nrrd", "lists/x/c.stl" });
  EXPECT_EQ(namesOf(listOfRows("#a, b.nrrd\r\n\r\nx/c.stl\r\n", "lists/list.txt")), (Names{ "#a, b.vtu", "x/c.vtu" }));
}

TEST_F(ListFile, ListsFromSpreadsheetsAreRead)
{
  touch({ "lists/a b.nrrd" });
  const CaseList list = listOfRows("\xEF\xBB\xBFinput;max-repair\r\n\"a b.nrrd\";2.5\r\n;\r\n");
  ASSERT_EQ(list.cases.size(), 1u);
  EXPECT_EQ(list.cases[0].options.maximumRepairPercent, 2.5);
}

TEST_F(ListFile, AListInTheCurrentFolderNeedsNoFolderName)
{
  touch({ "x/a.nrrd", "x/b.nrrd" });
  write("list.txt", "x/a.nrrd\nx/b.nrrd\n");
  const fs::path before = fs::current_path();
  fs::current_path(path(""));
  CaseListOptions options;
  options.inputs = { "list.txt" };
  options.outputFolder = "out";
  const CaseList list = listCases(options);
  fs::current_path(before);
  EXPECT_EQ(namesOf(list), (Names{ "x/a.vtu", "x/b.vtu" }));
  EXPECT_EQ(list.cases[1].options.input.file, "x/b.nrrd");
}

TEST_F(ListFile, UnknownColumnsAreRefusedUnlessTheyAreKept)
{
  touch({ "lists/a.nrrd", "lists/b.nrrd" });
  const std::string text = "input,age,site\na.nrrd,63,\"Basel, CH\"\nb.nrrd,,\n";
  const std::string message = refusalOfRows(text);
  expectMentions(message, "lists/list.csv: column 'age'");
  expectMentions(message, "--keep-columns");
  CaseListOptions options = optionsFor({ "lists/list.csv" });
  options.keepColumns = { "site", "age" };
  const CaseList list = listCases(options);
  EXPECT_EQ(list.keptColumns, (Names{ "site", "age" }));
  EXPECT_EQ(list.cases.at(0).kept, (Names{ "Basel, CH", "63" }));
  EXPECT_EQ(list.cases.at(1).kept, (Names{ "", "" }));
}

TEST_F(ListFile, KeptColumnsOfOtherInputsAreEmpty)
{
  touch({ "lists/a.nrrd", "lists/b.nrrd", "in/c.nrrd" });
  write("lists/1.csv", "input,age\na.nrrd,63\n");
  write("lists/2.csv", "input,site\nb.nrrd,x\n");
  CaseListOptions options = optionsFor({ "lists/1.csv", "lists/2.csv", "in" });
  options.keepColumns = { "age", "site" };
  const CaseList list = listCases(options);
  EXPECT_EQ(list.cases.at(0).kept, (Names{ "63", "" }));
  EXPECT_EQ(list.cases.at(1).kept, (Names{ "", "x" }));
  EXPECT_EQ(list.cases.at(2).kept, (Names{ "", "" }));
}

TEST_F(ListFile, ColumnsToKeepMustBeThereAndNoOptions)
{
  touch({ "lists/a.nrrd" });
  write("lists/list.csv", "input,label,age\na.nrrd,1,63\n");
  CaseListOptions options = optionsFor({ "lists/list.csv" });
  options.keepColumns = { "age", "Age" };
  expectMentions(refusal(options), "no list has a column Age");
  options.keepColumns = { "age", "label" };
  expectMentions(refusal(options), "label is an option of mesh");
  options.keepColumns = { "age", "age" };
  expectMentions(refusal(options), "twice");
  CaseListOptions noList = optionsFor({ "lists/a.nrrd" });
  noList.keepColumns = { "age" };
  expectMentions(refusal(noList), "no list has a column age");
}

TEST_F(ListFile, NearlyRightNamesOfColumnsGetAHint)
{
  touch({ "lists/a.nrrd" });
  expectMentions(refusalOfRows("input,Max_Repair\na.nrrd,1\n"), "write 'max-repair'");
  expectMentions(refusalOfRows("Input\na.nrrd\n"), "write 'input'");
  expectMentions(refusalOfRows("input,Output\na.nrrd,b.vtu\n"), "write 'output'");
  expectMentions(refusalOfRows("input,threads\na.nrrd,1\n"), "correct its name");
  expectMentions(refusalOfRows("label\n1\n"), "no column is called input");
}

TEST_F(ListFile, ValuesAreRefusedWithTheirLine)
{
  touch({ "lists/a.nrrd" });
  for (const auto & [column, value] : std::vector<std::pair<std::string, std::string>>{ { "shells", "99" },
                                                                                        { "label", "x" },
                                                                                        { "stage", "II" },
                                                                                        { "allow-partial", "maybe" },
                                                                                        { "max-repair", "-1" } })
  {
    const std::string message = refusalOfRows("input," + column + "\na.nrrd,\na.nrrd," + value + "\n");
    expectMentions(message, "lists/list.csv: line 3: ");
    expectMentions(message, "--" + column);
  }
  expectMentions(refusalOfRows("input,padding,stage\na.nrrd,2,moser\n"), "line 2: --padding needs --stage exact");
  expectMentions(refusalOfRows("input,label\n,1\n"), "line 2: no input");
  expectMentions(refusalOfRows("input,label,segment\na.nrrd,all,x\n"), "line 2: all labels");
  expectMentions(refusalOfRows("input\na.png\n"), "lists/a.png is neither labelmap nor surface");
  expectMentions(refusalOfRows("input,label\n"), "the list names no input");
}

TEST_F(ListFile, DamagedListsAreBadInput)
{
  write("lists/list.csv", "input,label\na.nrrd,1,2\n");
  expectMentions(messageOf<BadInput>([&] { (void)listOf({ "lists/list.csv" }); }), "line 2: 3 cells for 2 columns");
}

TEST_F(ListFile, OutputsStayInTheOutputFolder)
{
  touch({ "lists/a.nrrd", "b.nrrd" });
  for (const std::string output : { "../a.vtu", "x/../../a.vtu", "/tmp/a.vtu" })
  {
    const std::string message = refusalOfRows("input,output\na.nrrd," + output + "\n");
    expectMentions(message, "line 2: the path leaves the output folder");
  }
  const std::string message = refusalOfRows("input\n../b.nrrd\n");
  expectMentions(message, "line 2: the path leaves the output folder");
  expectMentions(message, "give an output column, or a --base");
  write("lists/list.csv", "input\n../b.nrrd\n");
  CaseListOptions options = optionsFor({ "lists/list.csv" });
  options.base = path("");
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "b.vtu" }));
  EXPECT_EQ(namesOf(listOfRows("input,output\na.nrrd,x/../..a.vtu\n")), (Names{ "..a.vtu" }));
}

TEST_F(ListFile, OutputsAreNamesOfMeshes)
{
  touch({ "lists/a.nrrd" });
  for (const std::string output : { "a", "a.nrrd", "a.json", "folder/" })
  {
    expectMentions(refusalOfRows("input,output\na.nrrd," + output + "\n"), "not a mesh file's name");
  }
}

TEST_F(ListFile, MissingInputsAreWarnedOfInOneLine)
{
  touch({ "lists/a.nrrd" });
  const CaseList list = listOfRows("input\na.nrrd\nx.nrrd\ny.nrrd\nz\n");
  EXPECT_EQ(list.cases.size(), 4u);
  ASSERT_EQ(list.warnings.size(), 1u);
  EXPECT_EQ(list.warnings[0], path("lists/x.nrrd") + " does not exist (and 2 more): the case will fail");
}

TEST_F(ListFile, MissingDensitiesAreWarnedOf)
{
  touch({ "lists/a.nrrd" });
  EXPECT_EQ(listOfRows("input,density\na.nrrd,d.nrrd\n").warnings,
            (Names{ path("lists/d.nrrd") + " does not exist: the case will fail" }));
}

TEST_F(ListFile, OneInputWithOtherOptionsNeedsAnotherOutput)
{
  touch({ "lists/a.nrrd" });
  const std::string message = refusalOfRows("input,label\na.nrrd,1\na.nrrd,2\n");
  expectMentions(message, "a.vtu: the mesh of two cases of ");
  expectMentions(message, "output column");
  EXPECT_EQ(namesOf(listOfRows("input,label,output\na.nrrd,1,1.vtu\na.nrrd,2,2.vtu\n")), (Names{ "1.vtu", "2.vtu" }));
  EXPECT_EQ(listOfRows("input,shells\na.nrrd,10\na.nrrd,\n").cases.size(), 1u);
}

TEST_F(ListFile, ReportsOfTwoCasesMustDiffer)
{
  touch({ "lists/a.nrrd", "lists/b.nrrd" });
  const std::string message = refusalOfRows("input,output\na.nrrd,x.vtu\nb.nrrd,x.msh\n");
  expectMentions(message, "x.json: the report of ");
  expectMentions(message, "lists/a.nrrd and ");
}

TEST_F(ListFile, ReportsThatDifferInCaseOnlyAreWarnedOf)
{
  touch({ "lists/a.nrrd", "lists/b.nrrd" });
  const CaseList list = listOfRows("input,output\na.nrrd,x.vtu\nb.nrrd,X.msh\n");
  EXPECT_EQ(list.cases.size(), 2u);
  expectMentions(list.warnings.at(0), "x.vtu and X.msh differ in upper and lower case only");
}

TEST_F(ListFile, TheListIsNotReplacedByTheSummary)
{
  touch({ "out/a.nrrd" });
  write("out/summary.csv", "input\na.nrrd\n");
  expectMentions(refusalOf({ "out/summary.csv" }), "would be overwritten");
}

TEST_F(ListFile, FormulasInCellsAreText)
{
  touch({ "lists/=1+1.nrrd" });
  write("lists/list.csv", "input,note\n=1+1.nrrd,\"=HYPERLINK(\"\"x\"\")\"\n");
  CaseListOptions options = optionsFor({ "lists/list.csv" });
  options.keepColumns = { "note" };
  const CaseList list = listCases(options);
  EXPECT_EQ(namesOf(list), (Names{ "=1+1.vtu" }));
  EXPECT_EQ(list.cases.at(0).kept, (Names{ "=HYPERLINK(\"x\")" }));
}

TEST_F(ListFile, CellsThatLookLikeOptionsAreValues)
{
  touch({ "lists/--shells=3.nrrd" });
  const CaseList list = listOfRows("input,segment\n--shells=3.nrrd,--label=3\n");
  EXPECT_EQ(list.cases.at(0).options.input.segment, "--label=3");
  EXPECT_FALSE(list.cases.at(0).options.input.label);
  EXPECT_EQ(list.cases.at(0).options.shells, 10);
}

TEST_F(ListFile, TenThousandRowsAreListedAndRefused)
{
  std::string text = "input,label,shells,segment\n";
  for (int n = 0; n < 10000; ++n)
  {
    text += "sub-" + std::to_string(n) + "/anat/sub-" + std::to_string(n) + "_dseg.nii.gz," + std::to_string(n) + "," +
            std::to_string(2 + n % 60) + ",\n";
  }
  const CaseList list = listOfRows(text);
  ASSERT_EQ(list.cases.size(), 10000u);
  EXPECT_EQ(list.cases[9999].name, "sub-9999/anat/sub-9999_dseg.vtu");
  EXPECT_EQ(list.cases[9999].options.input.label, LabelValue{ 9999 });
  expectMentions(list.warnings.at(0), "(and 9999 more)");
  const std::string rows = text.substr(text.find('\n') + 1);
  std::string       others = rows;
  others.replace(others.find(",0,2,"), 5, ",1,2,");
  EXPECT_EQ(listOfRows(text + rows).cases.size(), 10000u);
  expectMentions(refusalOfRows(text + others), "one of 1 such collisions");
  expectMentions(refusalOfRows(text + "a.nrrd,1,99,\n"), "line 10002: --shells");
}
