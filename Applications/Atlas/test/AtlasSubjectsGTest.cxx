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
