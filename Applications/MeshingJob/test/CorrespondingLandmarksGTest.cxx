// Exact: which points belong together.
#include "CorrespondingLandmarks.h"

#include "TestErrors.h"
#include "TestFolder.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

class Landmarks : public testing::Test
{
protected:
  [[nodiscard]] std::string
  file(const std::string & name, const std::string & rows) const
  {
    std::ofstream(m_Folder / name) << "label,x,y,z\n" << rows;
    return m_Folder / name;
  }

  [[nodiscard]] std::string
  errorOfLists(const std::string & onTemplate, const std::string & onSolid) const
  {
    return errorOf([&] { (void)readLandmarks(file("t.csv", onTemplate), file("s.csv", onSolid)); });
  }

  TestFolder m_Folder;
};

} // namespace

TEST_F(Landmarks, BelongTogetherByTheirLabels)
{
  const CorrespondingLandmarks found = readLandmarks(file("t.csv", "apex,1,2,3\nbase,4,5,6\nleft,7,8,9\n"),
                                                     file("s.csv", "base,0,0,1\napex,0,0,2\nnew,9,9,9\n"));
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_EQ(found.points[0].onTemplate, Vector3(1, 2, 3));
  EXPECT_EQ(found.points[0].onSolid, Vector3(0, 0, 2));
  EXPECT_EQ(found.points[1].onTemplate, Vector3(4, 5, 6));
  EXPECT_EQ(found.points[1].onSolid, Vector3(0, 0, 1));
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.warnings[0], "2 landmarks are in one of the two lists alone and do not count");
}

TEST_F(Landmarks, WithoutLabelsBelongTogetherByTheirNumbers)
{
  const CorrespondingLandmarks found =
    readLandmarks(file("t.csv", ",1,2,3\n,4,5,6\n"), file("s.csv", ",0,0,1\n,0,0,2\n"));
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_EQ(found.points[1].onTemplate, Vector3(4, 5, 6));
  EXPECT_EQ(found.points[1].onSolid, Vector3(0, 0, 2));
  EXPECT_TRUE(found.warnings.empty());
}

TEST_F(Landmarks, APointWithoutAPositionHasNoPart)
{
  const CorrespondingLandmarks found =
    readLandmarks(file("t.csv", "a,1,2,3\nb,,,\n"), file("s.csv", "a,0,0,1\nb,0,0,2\n"));
  EXPECT_EQ(found.points.size(), 1u);
  EXPECT_EQ(found.warnings.size(), 1u);
}

TEST_F(Landmarks, WithoutLabelsKeepTheirRowsWhereOneHasNoPosition)
{
  const CorrespondingLandmarks found =
    readLandmarks(file("t.csv", ",1,2,3\n,,,\n,7,8,9\n,3,3,3\n"), file("s.csv", ",0,0,1\n,0,0,2\n,0,0,3\n,,,\n"));
  ASSERT_EQ(found.points.size(), 2u);
  EXPECT_EQ(found.points[1].onTemplate, Vector3(7, 8, 9));
  EXPECT_EQ(found.points[1].onSolid, Vector3(0, 0, 3));
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.warnings[0], "2 landmarks are in one of the two lists alone and do not count");
}

TEST_F(Landmarks, ThatNothingTellsApartAreRefused)
{
  EXPECT_EQ(errorOfLists("a,1,2,3\na,4,5,6\n", "a,0,0,1\n").substr(0, 14), "E_PRECONDITION");
  EXPECT_EQ(errorOfLists("a,1,2,3\n", "b,0,0,1\n").substr(0, 14), "E_PRECONDITION");
  EXPECT_EQ(errorOfLists(",1,2,3\n,4,5,6\n", ",0,0,1\n").substr(0, 14), "E_PRECONDITION");
}

TEST_F(Landmarks, OfTheSameLabelAreRefusedByName)
{
  const std::string error = errorOfLists("apex,1,2,3\napex,4,5,6\nbase,7,8,9\n", "base,0,0,1\napex,0,0,2\nc,0,0,3\n");
  EXPECT_EQ(error.substr(0, 14), "E_PRECONDITION") << error;
  EXPECT_NE(error.find("two landmarks are labelled apex"), std::string::npos) << error;
  EXPECT_NE(error.find("t.csv"), std::string::npos) << error;
}

TEST_F(Landmarks, OfWhichOnlySomeHaveLabelsAreRefused)
{
  const std::string some = errorOfLists("apex,1,2,3\nbase,4,5,6\n", "base,0,0,1\n,0,0,2\n");
  EXPECT_EQ(some.substr(0, 14), "E_PRECONDITION") << some;
  EXPECT_NE(some.find("line 3 has no label"), std::string::npos) << some;
  const std::string one = errorOfLists("apex,1,2,3\nbase,4,5,6\n", ",0,0,1\n,0,0,2\n");
  EXPECT_EQ(one.substr(0, 14), "E_PRECONDITION") << one;
  EXPECT_NE(one.find("s.csv"), std::string::npos) << one;
}
