// Exact: coordinates of files that are read and written.
#include "PointFile.h"

#include "TestErrors.h"
#include "TestFolder.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <gtest/gtest.h>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

PointList
readText(const std::string & name, const std::string & text)
{
  const TestFolder folder;
  writeBytes(folder / name, text);
  return readPoints(folder / name);
}

std::string
refusal(const std::string & name, const std::string & text)
{
  return errorOf([&] { (void)readText(name, text); });
}

const std::string fiducials = "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
                              "vtkMRMLMarkupsFiducialNode_0,1.5,-2.25,3,0,0,0,1,1,1,0,\"base, left\",seen,vtkX\n";

ListedPoint
pointAt(const Vector3 & position)
{
  ListedPoint point;
  point.label = "apex";
  point.position = position;
  return point;
}

} // namespace

TEST(PointFile, FiducialsAreInTheSystemOfTheirHeader)
{
  const Vector3 lps(1.5, -2.25, 3.0);
  const Vector3 ras(-1.5, 2.25, 3.0);
  for (const auto & [system, expected] : { std::pair<std::string, Vector3>{ "# CoordinateSystem = LPS\n", lps },
                                           { "# CoordinateSystem = 1\n", lps },
                                           { "# CoordinateSystem = RAS\n", ras },
                                           { "# CoordinateSystem = 0\n", ras },
                                           { "", ras } })
  {
    const PointList list = readText("a.fcsv", "# Markups fiducial file version = 4.11\n" + system + fiducials);
    ASSERT_EQ(list.points.size(), 1u);
    EXPECT_EQ(*list.points[0].position, expected) << system;
    EXPECT_EQ(list.points[0].label, "base, left");
    EXPECT_EQ(list.points[0].description, "seen");
  }
  EXPECT_NE(refusal("a.fcsv", "# CoordinateSystem = 2\n" + fiducials).find("need LPS or RAS"), std::string::npos);
}

TEST(PointFile, HeadersAreTakenApartAtTheEqualsSign)
{
  const Vector3 lps(1.5, -2.25, 3.0);
  for (const char * system : { "#CoordinateSystem=LPS\n", "# CoordinateSystem=LPS \n", "#  CoordinateSystem  =  1\n" })
  {
    const PointList list = readText("a.fcsv", system + fiducials);
    EXPECT_EQ(*list.points[0].position, lps) << system;
    EXPECT_TRUE(list.warnings.empty()) << system;
  }
  EXPECT_NE(refusal("a.fcsv", "#CoordinateSystem =\n" + fiducials).find("need LPS or RAS"), std::string::npos);
}

TEST(PointFile, FiducialsWithoutASystemAreRasWithAWarning)
{
  const PointList list = readText("a.fcsv", fiducials);
  ASSERT_EQ(list.warnings.size(), 1u);
  EXPECT_NE(list.warnings[0].find("no CoordinateSystem: points taken as RAS"), std::string::npos) << list.warnings[0];
}

TEST(PointFile, FiducialsOfSlicer5HaveTwoCellsMore)
{
  const std::string row = ",1.5,-2.25,3,0,0,0,1,1,1,0,apex,,vtkMRMLScalarVolumeNode1";
  const PointList   list =
    readText("a.fcsv",
             "# Markups fiducial file version = 5.6\n# CoordinateSystem = LPS\n"
             "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
             "1" +
               row + ",2,0\n2" + row + ",0,0\n3" + row + ",1,0\n4" + row + ",3,1\n5" + row + ",,\n");
  ASSERT_EQ(list.points.size(), 5u);
  EXPECT_EQ(*list.points[0].position, Vector3(1.5, -2.25, 3.0));
  EXPECT_EQ(list.points[0].label, "apex");
  EXPECT_FALSE(list.points[1].position);
  EXPECT_FALSE(list.points[2].position);
  EXPECT_FALSE(list.points[3].position);
  EXPECT_TRUE(list.points[4].position);
  EXPECT_TRUE(list.warnings.empty());
}

TEST(PointFile, MarkupsAreInTheirOwnSystem)
{
  const auto markups = [](const std::string & fields) {
    return "{\"markups\":[{\"type\":\"Fiducial\"," + fields +
           "\"controlPoints\":[{\"label\":\"F-1\",\"position\":[1.5,-2.25,3]},{\"label\":\"F-2\",\"position\":[0,0,0],"
           "\"positionStatus\":\"undefined\"}]}]}";
  };
  const PointList lps = readText("a.mrk.json", markups("\"coordinateSystem\":\"LPS\","));
  ASSERT_EQ(lps.points.size(), 2u);
  EXPECT_EQ(*lps.points[0].position, Vector3(1.5, -2.25, 3.0));
  EXPECT_FALSE(lps.points[1].position);
  EXPECT_EQ(*readText("a.mrk.json", markups("")).points[0].position, Vector3(1.5, -2.25, 3.0));
  EXPECT_EQ(*readText("a.mrk.json", markups("\"coordinateSystem\":\"RAS\",")).points[0].position,
            Vector3(-1.5, 2.25, 3.0));
  EXPECT_NE(refusal("a.mrk.json", markups("\"coordinateSystem\":\"IJK\",")).find("need LPS or RAS"), std::string::npos);
  EXPECT_NE(refusal("a.mrk.json", markups("\"coordinateUnits\":\"um\",")).find("not mm"), std::string::npos);
  EXPECT_NE(refusal("a.mrk.json", "{\"markups\": 3").find("not Slicer's markups"), std::string::npos);
  EXPECT_NE(refusal("a.mrk.json", "{}").find("not Slicer's markups"), std::string::npos);
}

TEST(PointFile, TablesKeepTheirOtherColumns)
{
  const PointList list = readText("a.csv", "score,x,y,z,label,c1,c2,c3\nhigh,1,2,3,apex,0.5,0.25,1\nlow,,,,base,,,\n");
  EXPECT_EQ(list.otherColumns, std::vector<std::string>{ "score" });
  ASSERT_EQ(list.points.size(), 2u);
  EXPECT_EQ(*list.points[0].position, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(*list.points[0].cube, Vector3(0.5, 0.25, 1.0));
  EXPECT_EQ(list.points[0].others, std::vector<std::string>{ "high" });
  EXPECT_FALSE(list.points[1].position);
  EXPECT_FALSE(list.points[1].cube);
}

TEST(PointFile, WhatIsNoCoordinateIsRefusedByName)
{
  EXPECT_NE(refusal("a.csv", "label,x,y,z\napex,1,2,nan\n").find("apex"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "x,y,z\n1,2,three\n").find("line 2"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "x,y,z\n1,,3\n").find("not a coordinate"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "x,y\n1,2\n").find("not all of the columns"), std::string::npos);
  EXPECT_NE(refusal("a.csv", "u,v\n1,2\n").find("neither columns"), std::string::npos);
  EXPECT_NE(refusal("a.fcsv", fiducials + "1,2,3\n").find("cells for 14 columns"), std::string::npos);
}

TEST(PointFile, TextsAreNoFormulas)
{
  const TestFolder folder;
  PointList        list{ { "grade" }, {} };
  for (const char * label : { "+", "-", "@lesion", "+L1", "=a" })
  {
    list.points.push_back(pointAt(Vector3::Zero()));
    list.points.back().label = label;
    list.points.back().others = { "-" };
  }
  for (const char * name : { "a.fcsv", "a.csv", "a.tsv" })
  {
    writePoints(folder / name, list);
    const PointList read = readPoints(folder / name);
    for (std::size_t p = 0; p < list.points.size(); ++p)
    {
      EXPECT_EQ(read.points[p].label, list.points[p].label) << name;
    }
  }
  EXPECT_EQ(readPoints(folder / "a.csv").points[0].others, std::vector<std::string>{ "-" });
}

TEST(PointFile, EveryFormatComesBackTheSame)
{
  const TestFolder folder;
  const Vector3    position(1.0 / 3.0, -1e-7, 123.456789012345);
  PointList        list{ {}, { pointAt(position), ListedPoint{} } };
  for (const char * name : { "a.fcsv", "a.mrk.json", "a.csv", "a.tsv" })
  {
    writePoints(folder / name, list);
    const PointList read = readPoints(folder / name);
    ASSERT_GE(read.points.size(), 1u) << name;
    EXPECT_EQ(*read.points[0].position, position) << name;
    EXPECT_EQ(read.points[0].label, "apex") << name;
  }
  EXPECT_EQ(readPoints(folder / "a.fcsv").points.size(), 1u);
  EXPECT_FALSE(readPoints(folder / "a.mrk.json").points[1].position);
  EXPECT_THROW(writePoints(folder / "a.txt", list), BadInput);
}
