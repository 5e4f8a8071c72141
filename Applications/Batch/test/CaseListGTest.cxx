// Exact: which files become which cases.
#include "CaseListTest.h"

#include "WithoutPrivileges.h"

#include <algorithm>

#include <sys/stat.h>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

TEST_F(CaseListTest, AFolderIsMirroredInTheOrderOfItsPaths)
{
  touch({ "in/b.nrrd", "in/sub-01/anat/sub-01_space-T1w_dseg.nii.gz", "in/a.seg.nrrd", "in/Z.MHA" });
  const CaseList list = listOf({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "Z.vtu", "a.vtu", "b.vtu", "sub-01/anat/sub-01_space-T1w_dseg.vtu" }));
  const MeshCommandOptions & options = list.cases.at(3).options;
  EXPECT_EQ(options.input.file, path("in/sub-01/anat/sub-01_space-T1w_dseg.nii.gz"));
  EXPECT_EQ(options.output, path("out/sub-01/anat/sub-01_space-T1w_dseg.vtu"));
  EXPECT_EQ(options.reportFile, path("out/sub-01/anat/sub-01_space-T1w_dseg.json"));
  EXPECT_TRUE(list.warnings.empty());
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(CaseListTest, TheDefaultsHoldForEveryFile)
{
  touch({ "in/a.nrrd" });
  CaseListOptions options = optionsFor({ "in" });
  options.ending = ".msh";
  options.defaults.shells = 3;
  const CaseList list = listCases(options);
  EXPECT_EQ(namesOf(list), (Names{ "a.msh" }));
  EXPECT_EQ(list.cases.at(0).options.shells, 3);
  EXPECT_EQ(list.cases.at(0).options.reportFile, path("out/a.json"));
}

TEST_F(CaseListTest, OfAFolderOnlyVisibleLabelmapsCount)
{
  touch(
    { "in/a.nrrd", "in/.b.nrrd", "in/._a.nrrd", "in/.git/c.nrrd", "in/d.vtk", "in/e.txt", "in/f", "in/x.nrrd/g.nii" });
  EXPECT_EQ(names({ "in" }), (Names{ "a.vtu", "x.nrrd/g.vtu" }));
}

TEST_F(CaseListTest, FilesWithoutAnEndingAreNotOpened)
{
  touch({ "in/a.nrrd" });
  write("in/mask", "NRRD0004\n");
  EXPECT_EQ(names({ "in" }), (Names{ "a.vtu" }));
}

TEST_F(CaseListTest, TheOutputFolderIsNotSearchedWhereItLiesInTheInput)
{
  touch({ "in/a.nrrd", "in/meshes/b.nrrd", "in/x/meshes/c.nrrd" });
  fs::create_symlink("in", path("link"));
  CaseListOptions options = optionsFor({ "in" });
  options.outputFolder = path("link/./meshes/");
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "a.vtu", "x/meshes/c.vtu" }));
}

TEST_F(CaseListTest, MeshesMayStandBesideTheirInputs)
{
  touch({ "in/a.nrrd", "in/x/b.nrrd" });
  CaseListOptions options = optionsFor({ "in" });
  options.outputFolder = path("in");
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "a.vtu", "x/b.vtu" }));
}

TEST_F(CaseListTest, LinksToFilesCountAndLinksToFoldersDoNot)
{
  touch({ "in/a.nrrd", "elsewhere/b.nrrd" });
  fs::create_symlink("../elsewhere/b.nrrd", path("in/b.nrrd"));
  fs::create_directory_symlink("../elsewhere", path("in/folder"));
  fs::create_directory_symlink("../elsewhere", path("in/folder.nrrd"));
  fs::create_directory_symlink(".", path("in/loop"));
  fs::create_symlink("nowhere", path("in/not-fetched.nrrd"));
  const CaseList list = listOf({ "in" });
  EXPECT_EQ(namesOf(list), (Names{ "a.vtu", "b.vtu", "not-fetched.vtu" }));
  ASSERT_EQ(list.warnings.size(), 1u);
  EXPECT_EQ(list.warnings[0], path("in/not-fetched.nrrd") + " does not exist: the case will fail");
}

TEST_F(CaseListTest, IncludeAndExcludeFitPathsAndNames)
{
  touch({ "in/sub-01/a_dseg.nrrd", "in/sub-01/a_mask.nrrd", "in/sub-02/b_dseg.nrrd", "in/old/sub-03/c_dseg.nrrd" });
  CaseListOptions options = optionsFor({ "in" });
  options.include = { "*_dseg.nrrd" };
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "old/sub-03/c_dseg.vtu", "sub-01/a_dseg.vtu", "sub-02/b_dseg.vtu" }));
  options.include = { "sub-0?/*", "c_*" };
  EXPECT_EQ(listCases(options).cases.size(), 4u);
  options.exclude = { "old/*", "a_mask.nrrd" };
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "sub-01/a_dseg.vtu", "sub-02/b_dseg.vtu" }));
  options.include = { "*.mha" };
  expectMentions(refusal(options), "none of its 4 labelmaps passes --include and --exclude");
}

TEST_F(CaseListTest, FilesGivenByNameAreNotFiltered)
{
  touch({ "in/a.nrrd" });
  CaseListOptions options = optionsFor({ "in/a.nrrd" });
  options.exclude = { "*" };
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "a.vtu" }));
}

TEST_F(CaseListTest, AFolderWithoutLabelmapsIsWrongUsage)
{
  touch({ "in/a.vtk", "in/x/b.txt", "full/a.nrrd" });
  expectMentions(refusalOf({ "full", "in" }), "no labelmap in the folder or below (.nrrd .nhdr .nii");
  expectMentions(refusal(optionsFor({})), "nothing to mesh");
}

TEST_F(CaseListTest, AFolderThatCannotBeReadIsNotPassedOver)
{
  touch({ "in/a.nrrd", "in/closed/b.nrrd" });
  for (fs::path open = path("in"); open != fs::temp_directory_path(); open = open.parent_path())
  {
    fs::permissions(open, fs::perms(0755));
  }
  fs::permissions(path("in/closed"), fs::perms::none);
  {
    const WithoutPrivileges nobody;
    const std::string       message = messageOf<BadInput>([&] { (void)listOf({ "in" }); });
    expectMentions(message, "in/closed: cannot open");
    EXPECT_NE(messageOf<BadInput>([&] { (void)listOf({ "in/*/*.nrrd" }); }), "accepted");
  }
  fs::permissions(path("in/closed"), fs::perms(0755));
}

TEST_F(CaseListTest, FilesAreMirroredBelowTheFolderThatHoldsThemAll)
{
  touch({ "in/sub-01/a.nrrd", "in/sub-01/x/b.stl", "in/sub-02/a.nrrd" });
  EXPECT_EQ(names({ "in/sub-01/a.nrrd" }), (Names{ "a.vtu" }));
  EXPECT_EQ(names({ "in/sub-01/x/b.stl", "in/sub-01/a.nrrd" }), (Names{ "x/b.vtu", "a.vtu" }));
  EXPECT_EQ(names({ "in/sub-02/a.nrrd", "in/sub-01/../sub-01/a.nrrd" }), (Names{ "sub-02/a.vtu", "sub-01/a.vtu" }));
}

TEST_F(CaseListTest, PatternsFindLabelmapsAndSurfacesSorted)
{
  touch({ "in/sub-02/b.nrrd", "in/sub-01/b.nrrd", "in/sub-01/a.vtp", "in/sub-01/notes.txt", "in/sub-01/.c.nrrd" });
  EXPECT_EQ(names({ "in/*/*" }), (Names{ "sub-01/a.vtu", "sub-01/b.vtu", "sub-02/b.vtu" }));
  EXPECT_EQ(names({ "in/sub-0[2-9]/?.nrrd" }), (Names{ "b.vtu" }));
  expectMentions(refusalOf({ "in/*.nii.gz" }), "the pattern fits no labelmap");
  expectMentions(refusalOf({ "in/*" }), "folders are searched when they are given by name");
}

TEST_F(CaseListTest, AFileOfThatNameWinsOverThePattern)
{
  touch({ "in/a[1].nrrd", "in/a1.nrrd" });
  EXPECT_EQ(names({ "in/a[1].nrrd" }), (Names{ "a[1].vtu" }));
  fs::remove(path("in/a[1].nrrd"));
  EXPECT_EQ(names({ "in/a[1].nrrd" }), (Names{ "a1.vtu" }));
}

TEST_F(CaseListTest, InputsKeepTheirOrder)
{
  touch({ "b/z.nrrd", "c.nrrd", "a/y.nrrd" });
  write("list.txt", "b/x.nrrd\n");
  touch({ "b/x.nrrd" });
  CaseListOptions options = optionsFor({ "list.txt", "c.nrrd", "a" });
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "b/x.vtu", "c.vtu", "y.vtu" }));
}

TEST_F(CaseListTest, AnInputThatIsNotThereIsBadInput)
{
  EXPECT_EQ(codeThrownBy([&] { (void)listOf({ "missing.nrrd" }); }), ErrorCode::NoInput);
  EXPECT_EQ(codeThrownBy([&] { (void)listOf({ "missing.csv" }); }), ErrorCode::NoInput);
}

TEST_F(CaseListTest, OtherKindsOfFilesAreWrongUsage)
{
  touch({ "a.png", "none" });
  expectMentions(refusalOf({ "a.png" }), "neither labelmap nor surface");
  expectMentions(refusalOf({ "none" }), "neither labelmap nor surface");
  write("mask", "NRRD0004\n");
  EXPECT_EQ(names({ "mask" }), (Names{ "mask.vtu" }));
}

TEST_F(CaseListTest, BaseSaysWhatIsMirrored)
{
  touch({ "in/sub-01/a.nrrd", "in/sub-02/a.nrrd" });
  expectMentions(refusalOf({ "in/sub-01", "in/sub-02" }), "--base");
  CaseListOptions options = optionsFor({ "in/sub-01", "in/sub-02" });
  options.base = path("in/");
  EXPECT_EQ(namesOf(listCases(options)), (Names{ "sub-01/a.vtu", "sub-02/a.vtu" }));
  options.base = path("in/sub-01");
  const std::string message = refusal(options);
  expectMentions(message, "the path leaves the output folder");
  expectMentions(message, "--base");
}

TEST_F(CaseListTest, PathsRelativeToTheCurrentFolderStayRelative)
{
  touch({ "in/x/a.nrrd" });
  const fs::path before = fs::current_path();
  fs::current_path(path(""));
  CaseListOptions options;
  options.inputs = { "in" };
  options.outputFolder = "out";
  const CaseList list = listCases(options);
  fs::current_path(before);
  EXPECT_EQ(list.cases.at(0).options.input.file, "in/x/a.nrrd");
  EXPECT_EQ(list.cases.at(0).options.output, "out/x/a.vtu");
}

TEST_F(CaseListTest, TwoInputsWithOneOutputAreWrongUsage)
{
  touch({ "in/a.nrrd", "in/a.nii.gz", "in/a.mha", "in/b.nrrd", "in/b.nii" });
  const std::string message = refusalOf({ "in" });
  expectMentions(message, "a.vtu: the mesh of ");
  expectMentions(message, "in/a.mha and ");
  expectMentions(message, "in/a.nii.gz");
  expectMentions(message, "3 such collisions");
  expectMentions(message, "output column");
}

TEST_F(CaseListTest, NamesOfAnyLengthLeaveTheErrorItsCauseAndRemedy)
{
  const std::string folder = "in/" + std::string(120, 'x') + "/" + std::string(120, 'y');
  touch({ folder + "/a.nrrd", folder + "/a.nii.gz" });
  const std::string message = refusalOf({ "in" });
  expectMentions(message, "/a.nii.gz and ...");
  expectMentions(message, "yyy/a.nrrd, one of 1 such collisions");
  expectMentions(message, "output column");
}

TEST_F(CaseListTest, AnInputGivenTwiceIsMadeOnce)
{
  touch({ "in/a.nrrd", "in/b.nrrd" });
  CaseListOptions options = optionsFor({ "in", "in/a.nrrd", "in/./a.nrrd" });
  options.base = path("in");
  const CaseList list = listCases(options);
  EXPECT_EQ(namesOf(list), (Names{ "a.vtu", "b.vtu" }));
  ASSERT_EQ(list.warnings.size(), 1u);
  expectMentions(list.warnings[0], "in/a.nrrd is given twice with the same options (and 1 more): made once");
}

TEST_F(CaseListTest, NamesThatTheBatchKeepsAreRefusedAtTheTopOnly)
{
  touch({ "in/summary.nrrd" });
  const std::string message = refusalOf({ "in" });
  expectMentions(message, "its report would be summary.json");
  expectMentions(message, "rename the input, or give an output column");
  touch({ "deeper/x/summary.nrrd" });
  EXPECT_EQ(names({ "deeper" }), (Names{ "x/summary.vtu" }));
  touch({ "folders/summary.csv/a.nrrd" });
  expectMentions(refusalOf({ "folders" }), "its mesh would be summary.csv/a.vtu");
  touch({ "locked/.lock/a.nrrd" });
  CaseListOptions options = optionsFor({ "locked/.lock/a.nrrd" });
  options.base = path("locked");
  expectMentions(refusal(options), "its mesh would be .lock/a.vtu");
}

TEST_F(CaseListTest, AMeshIsNotTheFolderOfAnother)
{
  touch({ "in/a.nrrd", "in/a.vtu/b.nrrd" });
  expectMentions(refusalOf({ "in" }), "a.vtu: a file of ");
  touch({ "other/a.nrrd", "other/a.json/b.nrrd" });
  expectMentions(refusalOf({ "other" }), "a.json: a file of ");
}

TEST_F(CaseListTest, NamesThatDifferInCaseOnlyAreWarnedOf)
{
  touch({ "in/A.nrrd", "in/a.nrrd", "in/b.nrrd" });
  const CaseList list = listOf({ "in" });
  EXPECT_EQ(list.cases.size(), 3u);
  ASSERT_EQ(list.warnings.size(), 1u);
  expectMentions(list.warnings[0], "A.vtu and a.vtu differ in upper and lower case only");
}

TEST_F(CaseListTest, AnInputIsNeverAnOutput)
{
  touch({ "in/a.vtk", "in/b.vtk" });
  CaseListOptions options = optionsFor({ "in/*.vtk" });
  options.ending = ".vtk";
  options.outputFolder = path("in");
  expectMentions(refusal(options), "in/a.vtk: an input, and the mesh of ");
  options.outputFolder = path("other/../in/.");
  expectMentions(refusal(options), "an input");
  touch({ "out/c.txt" });
  fs::create_hard_link(path("in/b.vtk"), path("out/b.vtk"));
  options.outputFolder = path("out");
  expectMentions(refusal(options), "out/b.vtk: an input, and the mesh of ");
  options.outputFolder = path("new");
  EXPECT_EQ(listCases(options).cases.size(), 2u);
}

TEST_F(CaseListTest, ADensityIsNoOutputEither)
{
  touch({ "in/a.nrrd", "out/a.vtk" });
  CaseListOptions options = optionsFor({ "in" });
  options.ending = ".vtk";
  options.defaults.density = path("out/a.vtk");
  expectMentions(refusal(options), "out/a.vtk: an input");
}

TEST_F(CaseListTest, OptionsThatContradictThemselvesAreWrongUsage)
{
  touch({ "in/a.nrrd" });
  for (const std::string ending : { "vtu", ".xyz", "", "_1.vtu", ".a.vtu", "/b.vtu" })
  {
    CaseListOptions options = optionsFor({ "in" });
    options.ending = ending;
    expectMentions(refusal(options), "--format: ");
  }
  CaseListOptions padding = optionsFor({ "in" });
  padding.defaults.padding = 1;
  padding.defaults.stage = "moser";
  expectMentions(refusal(padding), "--padding needs --stage exact");
  CaseListOptions label = optionsFor({ "in" });
  label.allLabels = true;
  label.defaults.input.label = 3;
  expectMentions(refusal(label), "--all-labels excludes --label");
}

TEST_F(CaseListTest, ControlCharactersDoNotBreakTheLineOfAnError)
{
  touch({ "in/a\nb.nrrd", "in/a\nb.nii" });
  EXPECT_EQ(refusalOf({ "in" }).find('\n'), std::string::npos);
}
