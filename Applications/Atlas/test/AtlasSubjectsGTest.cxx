// Exact: names, files and numbers of tables and folders.
#include "AtlasSubjects.h"

#include "CommandErrors.h"
#include "TestFolder.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/AtomicFile.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace moserhex;
using namespace moserhex::app;
namespace fs = std::filesystem;

namespace
{

std::vector<std::string>
namesOf(const AtlasSubjects & subjects)
{
  std::vector<std::string> names;
  for (const AtlasSubject & subject : subjects.subjects)
  {
    names.push_back(subject.name);
  }
  return names;
}

AtlasSubjects
tableOf(const TestFolder & folder, const std::string & text)
{
  writeTextFile(folder / "table.csv", text);
  return listAtlasSubjects({ folder / "table.csv" }, folder / "out");
}

} // namespace

TEST(AtlasSubjects, OfAFolderAreItsMeshesByTheirPaths)
{
  const TestFolder folder;
  for (const char * file : { "b/1.vtu", "a.vtu", "a.json", "out/mean.vtu", ".hidden/x.vtu", "b/.y.vtu" })
  {
    makeFolder(fs::path(folder / file).parent_path().string());
    writeTextFile(folder / file, "");
  }
  const AtlasSubjects subjects = listAtlasSubjects({ folder / "" }, folder / "out");
  EXPECT_EQ(namesOf(subjects), (std::vector<std::string>{ "a", "b/1" }));
  EXPECT_EQ(fs::path(subjects.subjects[1].mesh), fs::path(folder / "b/1.vtu"));
}

TEST(AtlasSubjects, OfATableAreRelativeToItAndMayHaveNames)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder, "subject,mesh,age\nAnna,m/1.vtu,50\n,m/2.vtu,n/a\n");
  EXPECT_EQ(namesOf(subjects), (std::vector<std::string>{ "Anna", "m/2" }));
  EXPECT_EQ(fs::path(subjects.subjects[0].mesh), fs::path(folder / "m/1.vtu"));
  const auto ages = numbersOfColumn(subjects, "age");
  EXPECT_EQ(ages[0], 50.0);
  EXPECT_FALSE(ages[1].has_value());
}

TEST(AtlasSubjects, GroupsAreOrderedAsNumbersOrInTheAlphabet)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder, "mesh,grade,arm\n1.vtu,10,treated\n2.vtu,9,control\n3.vtu,9,\n");
  EXPECT_EQ(groupsOfColumn(subjects, "grade").names, (std::vector<std::string>{ "9", "10" }));
  const GroupColumn arm = groupsOfColumn(subjects, "arm");
  EXPECT_EQ(arm.names, (std::vector<std::string>{ "control", "treated" }));
  EXPECT_EQ(arm.numbers[0], 1.0);
  EXPECT_EQ(arm.numbers[1], 0.0);
  EXPECT_FALSE(arm.numbers[2].has_value());
  EXPECT_EQ(numbersOfColumn(subjects, "arm")[0], 1.0);
}

TEST(AtlasSubjects, GroupsThatAreWordsMayBeMany)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder, "mesh,stage\n1.vtu,late\n2.vtu,early\n3.vtu,n/a\n4.vtu,none\n");
  const GroupColumn   groups = groupsOfColumn(subjects, "stage");
  EXPECT_EQ(groups.names, (std::vector<std::string>{ "early", "late", "none" }));
  EXPECT_EQ(groups.numbers, (std::vector<std::optional<double>>{ 1.0, 0.0, std::nullopt, 2.0 }));
}

TEST(AtlasSubjects, WhatStatisticsProgramsWriteForNoValueIsMissing)
{
  const TestFolder    folder;
  const AtlasSubjects subjects =
    tableOf(folder,
            "mesh,arm,age\n1.vtu,treated,50\n2.vtu,NA,NA\n3.vtu,control,NaN\n4.vtu,null,N/A\n"
            "5.vtu,.,NULL\n6.vtu,treated,+6.5\n7.vtu,n/A,-.5\n");
  const GroupColumn arm = groupsOfColumn(subjects, "arm");
  EXPECT_EQ(arm.names, (std::vector<std::string>{ "control", "treated" }));
  EXPECT_EQ(arm.numbers, (NumberColumn{ 1.0, {}, 0.0, {}, {}, 1.0, {} }));
  EXPECT_EQ(numbersOfColumn(subjects, "age"), (NumberColumn{ 50.0, {}, {}, {}, {}, 6.5, -0.5 }));
}

TEST(AtlasSubjects, OneNumberWrittenInTwoWaysIsOneGroup)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder, "mesh,dose\n1.vtu,1\n2.vtu,1.0\n3.vtu,+0\n4.vtu,0\n");
  const GroupColumn   dose = groupsOfColumn(subjects, "dose");
  EXPECT_EQ(dose.names, (std::vector<std::string>{ "0", "1" }));
  EXPECT_EQ(dose.numbers, (NumberColumn{ 1.0, 1.0, 0.0, 0.0 }));
}

TEST(AtlasSubjects, CovariatesOfManyWordsAreColumnsOfZeroAndOne)
{
  const TestFolder    folder;
  const AtlasSubjects subjects =
    tableOf(folder, "mesh,site,sex,age\n1.vtu,west,f,50\n2.vtu,east,m,51\n3.vtu,NA,f,52\n4.vtu,south,m,53\n");
  EXPECT_EQ(covariatesOfColumn(subjects, "site"),
            (std::vector<NumberColumn>{ { 0.0, 0.0, {}, 1.0 }, { 1.0, 0.0, {}, 0.0 } }));
  EXPECT_EQ(covariatesOfColumn(subjects, "sex"), (std::vector<NumberColumn>{ { 0.0, 1.0, 0.0, 1.0 } }));
  EXPECT_EQ(covariatesOfColumn(subjects, "age"), (std::vector<NumberColumn>{ { 50.0, 51.0, 52.0, 53.0 } }));
}

TEST(AtlasSubjects, WhatIsNearlyANumberIsRefusedWithItsLine)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder,
                                         "mesh,age,comma,plus,arm\n1.vtu,50,3,+-3,1\n2.vtu,unknown,3.5,-3x,2\n"
                                         "3.vtu,52,4,+-3,two\n");
  const auto          refusal = [&](const std::string & column) {
    return analytic::messageOf<Error>([&] { (void)numbersOfColumn(subjects, column); });
  };
  EXPECT_NE(refusal("age").find("line 3: unknown among numbers"), std::string::npos) << refusal("age");
  EXPECT_NE(refusal("plus").find("line 2: +-3 is no number"), std::string::npos) << refusal("plus");
  const std::string arm = analytic::messageOf<Error>([&] { (void)groupsOfColumn(subjects, "arm"); });
  EXPECT_NE(arm.find("line 4: two among numbers"), std::string::npos) << arm;
  const AtlasSubjects commas = tableOf(folder, "mesh,psa\n1.vtu,\"3,2\"\n2.vtu,\"4,1\"\n");
  EXPECT_NE(
    analytic::messageOf<Error>([&] { (void)covariatesOfColumn(commas, "psa"); }).find("line 2: 3,2 is no number"),
    std::string::npos);
}

TEST(AtlasSubjects, AnEarlierAtlasAmongTheMeshesIsLeftOut)
{
  const TestFolder folder;
  for (const char * file : { "a.vtu", "old/mean.vtu", "old/atlas.json", "old/model.json", "old/deep/b.vtu" })
  {
    makeFolder(fs::path(folder / file).parent_path().string());
    writeTextFile(folder / file, "");
  }
  const AtlasSubjects subjects = listAtlasSubjects({ folder / "" }, folder / "out");
  EXPECT_EQ(namesOf(subjects), std::vector<std::string>{ "a" });
  ASSERT_EQ(subjects.warnings.size(), 1u);
  EXPECT_NE(subjects.warnings[0].find("old: an atlas"), std::string::npos) << subjects.warnings[0];
  EXPECT_NE(
    analytic::messageOf<Error>([&] { (void)listAtlasSubjects({ folder / "old" }, folder / "out"); }).find("an atlas"),
    std::string::npos);
  EXPECT_NE(analytic::messageOf<UsageError>([&] {
              (void)listAtlasSubjects({ folder / "" }, folder / "");
            }).find("an input and the output"),
            std::string::npos);
}

TEST(AtlasSubjects, FilesOfAColumnAreRelativeToTheTable)
{
  const TestFolder    folder;
  const AtlasSubjects subjects = tableOf(folder, "mesh,mri\n1.vtu,a/1.nrrd\n2.vtu,\n3.vtu,n/a\n");
  const auto          files = filesOfColumn(subjects, "mri");
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(fs::path(files[0].value()), fs::path(folder / "a/1.nrrd"));
  EXPECT_FALSE(files[1].has_value());
  EXPECT_FALSE(files[2].has_value());
}

TEST(AtlasSubjects, Refusals)
{
  const TestFolder folder;
  const auto       refusal = [&](const std::string & text) {
    return analytic::messageOf<Error>([&] { (void)tableOf(folder, text); });
  };
  EXPECT_NE(refusal("mesh,age\n").find("no subject"), std::string::npos);
  EXPECT_NE(refusal("mesh,age\nNA,5\n").find("no mesh in line 2"), std::string::npos);
  EXPECT_NE(refusal("file\n1.vtu\n").find("no column mesh"), std::string::npos);
  EXPECT_NE(refusal("mesh,age\n,5\n").find("no mesh in line 2"), std::string::npos);
  EXPECT_NE(refusal("mesh\n1.vtu\n./1.vtu\n").find("given twice"), std::string::npos);
  EXPECT_NE(refusal("mesh,subject\n1.vtu,A\n2.vtu,B\n3.vtu,A\n").find("a second subject A"), std::string::npos);
  const AtlasSubjects subjects = tableOf(folder, "mesh,stage,size\n1.vtu,a,1\n2.vtu,b,2\n3.vtu,c,3\n");
  EXPECT_NE(analytic::messageOf<Error>([&] { (void)numbersOfColumn(subjects, "stage"); }).find("3 different values"),
            std::string::npos);
  EXPECT_NE(analytic::messageOf<Error>([&] { (void)groupsOfColumn(subjects, "size"); }).find("3 different numbers"),
            std::string::npos);
  EXPECT_NE(analytic::messageOf<Error>([&] { (void)numbersOfColumn(subjects, "age"); }).find("no such column"),
            std::string::npos);
  EXPECT_NE(analytic::messageOf<Error>([&] {
              (void)listAtlasSubjects({ folder / "table.csv", "a.vtu" }, "");
            }).find("a table among other inputs"),
            std::string::npos);
}
