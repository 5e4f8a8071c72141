// Positions to 1e-9 mm, the customer's bound.
#include "TransferTest.h"

#include "moserhex/CubeTransfer/CubeMap.h"

#include <cstdio>
#include <fstream>

using namespace moserhex;
using namespace moserhex::app;

TEST_F(TransferCommand, PointsComeBackToTheirPlaces)
{
  const CubeMap map(m_Mesh);
  std::ofstream table(path("points.csv"));
  table.precision(17);
  table << "grade,label,x,y,z\n";
  std::vector<Vector3> positions;
  for (const Vector3 & c : { Vector3(0.1, 0.2, 0.3), Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.5, 0.9) })
  {
    positions.push_back(map.position(map.place(c)));
    table << "4," << positions.size() << ',' << positions.back()[0] << ',' << positions.back()[1] << ','
          << positions.back()[2] << '\n';
  }
  table << "5,far away,200,0,0\n";
  table.close();
  const Outcome there = transferOf("points.csv", { "--to-cube", path("cube.csv") });
  EXPECT_EQ(there.exitCode, 0);
  EXPECT_NE(there.out.find("3 of 4 points"), std::string::npos) << there.out;
  EXPECT_NE(there.error.find("warning: far away: outside of the mesh"), std::string::npos) << there.error;
  EXPECT_NE(contentOf(path("cube.csv")).find("far away,,5,200,0,0,,,\n"), std::string::npos);
  EXPECT_NE(contentOf(path("cube.csv")).find("1,,4,"), std::string::npos);

  const Outcome back = transferOf("cube.csv", { "--to-points", path("back.csv") });
  EXPECT_EQ(back.exitCode, 0);
  std::ifstream stream(path("back.csv"));
  std::string   line;
  std::getline(stream, line);
  for (const Vector3 & position : positions)
  {
    ASSERT_TRUE(std::getline(stream, line));
    Vector3 found;
    ASSERT_EQ(std::sscanf(line.c_str(), "%*[^,],,%*[^,],%lf,%lf,%lf", &found[0], &found[1], &found[2]), 3) << line;
    EXPECT_LE((found - position).norm(), 1e-9);
  }
}

TEST_F(TransferCommand, FiducialsGoToAnotherSubject)
{
  const HexMesh other = bentBar(4.0);
  const CubeMap from(m_Mesh);
  const CubeMap to(other);
  const Vector3 c(0.8, 0.5, 0.5);
  const Vector3 p = from.position(from.place(c));
  std::ofstream(path("p.fcsv")) << "# CoordinateSystem = RAS\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,"
                                   "associatedNodeID\n1,"
                                << std::to_string(-p[0]) << ',' << std::to_string(-p[1]) << ',' << std::to_string(p[2])
                                << ",0,0,0,1,1,1,0,apex,,\n";
  transfer("p.fcsv", { "--to-mesh", path("b.vtu"), "--to-points", path("q.csv"), "--quiet" });
  const std::string text = contentOf(path("q.csv"));
  Vector3           found;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("apex"), "apex,,%lf,%lf,%lf", &found[0], &found[1], &found[2]), 3)
    << text;
  EXPECT_LE((found - to.position(to.place(c))).norm(), 1e-5); // the file has six decimals
}

TEST_F(TransferCommand, PointsWithoutAPlaceAreAnError)
{
  std::ofstream(path("subject.csv")) << "label,x,y,z\na,20,15,8\n";
  std::ofstream(path("far.csv")) << "label,x,y,z\na,200,0,0\nb,,,\n";
  std::ofstream(path("beyond.csv")) << "label,c1,c2,c3\na,0.5,0.5,1.5\n";
  std::ofstream(path("empty.csv")) << "label,x,y,z\n";
  std::ofstream(path("empty.fcsv")) << "";
  const std::size_t files = fileCount();
  const Outcome     withoutCube = transferOf("subject.csv", { "--to-points", path("out.csv") });
  expectErrorCode(withoutCube, "E_USAGE");
  EXPECT_NE(withoutCube.error.find("--to-mesh"), std::string::npos) << withoutCube.error;
  expectErrorCode(transferOf("far.csv", { "--to-cube", path("out.csv") }), "E_GEOMETRY");
  expectErrorCode(transferOf("beyond.csv", { "--to-points", path("out.csv") }), "E_GEOMETRY");
  expectErrorCode(transferOf("empty.csv", { "--to-cube", path("out.csv") }), "E_EMPTY");
  expectErrorCode(transferOf("empty.fcsv", { "--to-mesh", path("b.vtu"), "--to-points", path("out.csv") }), "E_EMPTY");
  EXPECT_EQ(fileCount(), files);
}

TEST_F(TransferCommand, AnUnknownSystemOfFiducialsIsAWarning)
{
  std::ofstream(path("p.fcsv")) << "1,-20,-15,8,0,0,0,1,1,1,0,+L1,,,2,0\n";
  const Outcome outcome = transferOf("p.fcsv", { "--to-cube", path("q.csv") });
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_NE(outcome.error.find("no CoordinateSystem: points taken as RAS"), std::string::npos) << outcome.error;
  EXPECT_NE(contentOf(path("q.csv")).find("\n+L1,,20,15,8,0."), std::string::npos) << contentOf(path("q.csv"));
}

TEST_F(TransferCommand, WhatAFormatCannotHoldIsTold)
{
  std::ofstream(path("p.csv")) << "label,score,x,y,z\na,5,20,15,8\nfar,6,200,15,8\n";
  const Outcome list = transferOf("p.csv", { "--to-mesh", path("b.vtu"), "--to-points", path("q.fcsv") });
  EXPECT_EQ(list.exitCode, 0) << list.error;
  EXPECT_NE(list.error.find("cannot hold the columns score"), std::string::npos) << list.error;
  EXPECT_NE(list.error.find("far: outside of the mesh"), std::string::npos) << list.error;
  EXPECT_NE(list.error.find("left out"), std::string::npos) << list.error;
  const Outcome table = transferOf("p.csv", { "--to-cube", path("Q.CSV") });
  EXPECT_EQ(table.exitCode, 0) << table.error;
  EXPECT_EQ(table.error.find("columns"), std::string::npos) << table.error;
  EXPECT_NE(table.error.find("left empty"), std::string::npos) << table.error;
}
