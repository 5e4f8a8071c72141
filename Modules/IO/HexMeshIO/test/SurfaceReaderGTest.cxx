// Volumes: binary STL and the ASCII writers keep about seven digits, 1e-5 relative. Counts and refusals are exact.
#include "moserhex/HexMeshIO/SurfaceReader.h"

#include "TestFolder.h"
#include "moserhex/Analytic/ObservedOrder.h"
#include "moserhex/Analytic/SurfaceShapes.h"
#include "moserhex/Geometry/TriangleTopology.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <sstream>

using namespace moserhex;
using namespace moserhex::analytic;

namespace
{

TriangleMesh
shiftedEllipsoid()
{
  TriangleMesh mesh = ellipsoidSurface(2, Vector3(30, 10, 15));
  for (Vector3 & vertex : mesh.vertices)
  {
    vertex += Vector3(5, -7, 11);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData>
polyDataOf(const TriangleMesh & mesh)
{
  auto                 data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints>    points;
  vtkNew<vtkCellArray> triangles;
  points->SetDataTypeToDouble();
  for (const Vector3 & vertex : mesh.vertices)
  {
    points->InsertNextPoint(vertex.data());
  }
  for (const Triangle & triangle : mesh.triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  data->SetPoints(points);
  data->SetPolys(triangles);
  return data;
}

template <typename TWriter>
void
writeBy(const std::string & fileName, vtkPolyData * data, const char * header = nullptr)
{
  vtkNew<TWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(data);
  if constexpr (std::is_same_v<TWriter, vtkPolyDataWriter>)
  {
    writer->SetHeader(header ? header : "surface");
  }
  writer->Write();
}

std::string
offText(const TriangleMesh & mesh)
{
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n# a comment\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Vector3 & v : mesh.vertices)
  {
    text << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const Triangle & t : mesh.triangles)
  {
    text << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << " 255 0 0\n";
  }
  return text.str();
}

std::string
objText(const TriangleMesh & mesh)
{
  std::ostringstream text;
  text.precision(17);
  for (const Vector3 & v : mesh.vertices)
  {
    text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const Triangle & t : mesh.triangles)
  {
    text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return text.str();
}

void
writeAs(const std::string & fileName, const TriangleMesh & mesh)
{
  const std::string extension = std::filesystem::path(fileName).extension();
  if (extension == ".off" || extension == ".obj")
  {
    writeBytes(fileName, extension == ".off" ? offText(mesh) : objText(mesh));
  }
  else if (extension == ".vtk")
  {
    writeBy<vtkPolyDataWriter>(fileName, polyDataOf(mesh));
  }
  else if (extension == ".vtp")
  {
    writeBy<vtkXMLPolyDataWriter>(fileName, polyDataOf(mesh));
  }
  else if (extension == ".stl")
  {
    writeBy<vtkSTLWriter>(fileName, polyDataOf(mesh));
  }
  else
  {
    writeBy<vtkPLYWriter>(fileName, polyDataOf(mesh));
  }
}

Vector3
centreOf(const TriangleMesh & mesh)
{
  const BoundingBox box = boundingBox(mesh.vertices);
  return 0.5 * (box.lower + box.upper);
}

} // namespace

class EverySurfaceFormat : public testing::TestWithParam<std::string>
{};
INSTANTIATE_TEST_SUITE_P(SurfaceReader,
                         EverySurfaceFormat,
                         testing::Values("vtk", "vtp", "stl", "obj", "ply", "off"),
                         [](const auto & instance) { return instance.param; });

TEST_P(EverySurfaceFormat, GivesTheClosedSurface)
{
  const TestFolder   folder;
  const TriangleMesh mesh = shiftedEllipsoid();
  const std::string  name = folder / ("a." + GetParam());
  writeAs(name, mesh);
  const TriangleMesh read = readSurface(name).mesh;
  EXPECT_EQ(read.vertices.size(), mesh.vertices.size());
  EXPECT_EQ(read.triangles.size(), mesh.triangles.size());
  EXPECT_TRUE(summarizeTopology(read).isSphere());
  EXPECT_LT(relativeError(enclosedVolume(read), enclosedVolume(mesh)), 1e-5);
  EXPECT_LT((centreOf(read) - centreOf(mesh)).norm(), 1e-4);
}

TEST_P(EverySurfaceFormat, InwardSurfaceIsTurnedOutwards)
{
  const TestFolder folder;
  TriangleMesh     mesh = shiftedEllipsoid();
  for (Triangle & triangle : mesh.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  const std::string name = folder / ("a." + GetParam());
  writeAs(name, mesh);
  EXPECT_GT(enclosedVolume(readSurface(name).mesh), 0.0);
}

TEST_P(EverySurfaceFormat, OpenSurfaceIsRefused)
{
  const TestFolder folder;
  TriangleMesh     mesh = shiftedEllipsoid();
  mesh.triangles.pop_back();
  const std::string name = folder / ("a." + GetParam());
  writeAs(name, mesh);
  EXPECT_NE(messageOf<BadInput>([&] { (void)readSurface(name); }).find("boundary loop of 3 edges"), std::string::npos);
}

TEST_P(EverySurfaceFormat, EmptyFileIsRefused)
{
  const TestFolder  folder;
  const std::string name = folder / ("a." + GetParam());
  writeBytes(name, "");
  EXPECT_THROW((void)readSurface(name), BadInput);
}

TEST_P(EverySurfaceFormat, TextOfAnotherKindIsRefused)
{
  const TestFolder  folder;
  const std::string name = folder / ("a." + GetParam());
  writeBytes(name, "<html>\n<body>404 Not Found</body>\n</html>\n");
  EXPECT_THROW((void)readSurface(name), BadInput);
}

TEST(SurfaceReader, RasFileIsTurnedIntoLps)
{
  const TestFolder   folder;
  const TriangleMesh mesh = shiftedEllipsoid();
  const Vector3      expected = centreOf(mesh).cwiseProduct(Vector3(-1, -1, 1));
  writeBy<vtkPolyDataWriter>(folder / "a.vtk", polyDataOf(mesh), "3D Slicer output. SPACE=RAS");
  EXPECT_LT((centreOf(readSurface(folder / "a.vtk").mesh) - expected).norm(), 1e-4);

  const auto             data = polyDataOf(mesh);
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("RAS");
  data->GetFieldData()->AddArray(space);
  writeBy<vtkXMLPolyDataWriter>(folder / "a.vtp", data);
  const TriangleMesh read = readSurface(folder / "a.vtp").mesh;
  EXPECT_LT((centreOf(read) - expected).norm(), 1e-4);
  EXPECT_GT(enclosedVolume(read), 0.0);
}

TEST(SurfaceReader, EveryVersionOfLegacyVtkWithAttributesIsRead)
{
  const TestFolder       folder;
  const TriangleMesh     mesh = shiftedEllipsoid();
  const auto             data = polyDataOf(mesh);
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("RAS");
  vtkNew<vtkStringArray> remark;
  remark->SetName("a remark");
  remark->InsertNextValue(std::string(100, 'x')); // its length takes two bytes
  remark->InsertNextValue("two words");
  data->GetFieldData()->AddArray(space);
  data->GetFieldData()->AddArray(remark);
  data->GetPointData()->SetNormals(data->GetPoints()->GetData());
  const Vector3 expected = centreOf(mesh).cwiseProduct(Vector3(-1, -1, 1));
  for (const int version : { 42, 51 })
  {
    for (const int encoding : { VTK_ASCII, VTK_BINARY })
    {
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetFileName((folder / "a.vtk").c_str());
      writer->SetInputData(data);
      writer->SetFileVersion(version);
      writer->SetFileType(encoding);
      writer->Write();
      const SurfaceFile read = readSurface(folder / "a.vtk");
      EXPECT_EQ(read.mesh.triangles.size(), mesh.triangles.size()) << version << ' ' << encoding;
      EXPECT_LT((centreOf(read.mesh) - expected).norm(), 1e-4) << version << ' ' << encoding;
      EXPECT_TRUE(read.warnings.empty());
    }
  }
}

TEST(SurfaceReader, RepairsAreWarnings)
{
  const TestFolder folder;
  TriangleMesh     mesh = shiftedEllipsoid();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  writeAs(folder / "a.off", mesh);
  ASSERT_EQ(readSurface(folder / "a.off").warnings.size(), 1u);
  EXPECT_EQ(readSurface(folder / "a.off").warnings[0], "1 triangle turned to agree with the others");
}

TEST(SurfaceReader, CoordinateThatIsNotFiniteIsRefused)
{
  const TestFolder folder;
  TriangleMesh     mesh = shiftedEllipsoid();
  mesh.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  writeAs(folder / "a.off", mesh);
  EXPECT_THROW((void)readSurface(folder / "a.off"), BadInput);
}

TEST(SurfaceReader, IndexOutOfRangeIsRefused)
{
  const TestFolder folder;
  for (const VertexIndex index : { -1, 162, 1000000 })
  {
    TriangleMesh mesh = shiftedEllipsoid();
    mesh.triangles[7][1] = index;
    writeAs(folder / "a.off", mesh);
    EXPECT_NE(messageOf<BadInput>([&] { (void)readSurface(folder / "a.off"); }).find("face 8"), std::string::npos);
  }
}

TEST(SurfaceReader, OffCutAnywhereIsRefused)
{
  const TestFolder  folder;
  const std::string text = offText(cubeSurface(1));
  for (std::size_t length = 0; length < text.size() - 14; length += 7)
  {
    writeBytes(folder / "a.off", text.substr(0, length));
    EXPECT_THROW((void)readSurface(folder / "a.off"), BadInput) << length;
  }
}

TEST(SurfaceReader, OffCountsBeyondTheFileAreRefused)
{
  const TestFolder folder;
  writeBytes(folder / "a.off", "OFF\n99999999999 1 0\n");
  EXPECT_THROW((void)readSurface(folder / "a.off"), BadInput);
}

TEST(SurfaceReader, PlyCutAnywhereIsRefused)
{
  const TestFolder folder;
  for (const bool binary : { false, true })
  {
    vtkNew<vtkPLYWriter> writer;
    writer->SetFileName((folder / "whole.ply").c_str());
    writer->SetInputData(polyDataOf(cubeSurface(1)));
    binary ? writer->SetFileTypeToBinary() : writer->SetFileTypeToASCII();
    writer->Write();
    EXPECT_NO_THROW((void)readSurface(folder / "whole.ply"));
    const std::string bytes = readBytes(folder / "whole.ply");
    for (std::size_t length = 0; length < bytes.size() - 5; length += 7)
    {
      writeBytes(folder / "a.ply", bytes.substr(0, length));
      EXPECT_THROW((void)readSurface(folder / "a.ply"), BadInput) << length;
    }
  }
}

TEST(SurfaceReader, PlyOfBigEndianIsRead)
{
  const TestFolder   folder;
  const TriangleMesh mesh = cubeSurface(2, 10.0);
  std::string bytes = "ply\nformat binary_big_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty uchar red\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_index\nend_header\n";
  const auto append = [&bytes](auto value) {
    std::string raw(reinterpret_cast<const char *>(&value), sizeof value);
    bytes.append(raw.rbegin(), raw.rend());
  };
  for (const Vector3 & v : mesh.vertices)
  {
    bytes += '\x07';
    append(v.x());
    append(v.y());
    append(v.z());
  }
  for (const Triangle & t : mesh.triangles)
  {
    bytes += '\x03';
    append(t[0]);
    append(t[1]);
    append(t[2]);
  }
  writeBytes(folder / "a.ply", bytes);
  EXPECT_DOUBLE_EQ(enclosedVolume(readSurface(folder / "a.ply").mesh), 1000.0);
}

TEST(SurfaceReader, CountsBeyondALegacyFileAreRefused)
{
  const TestFolder folder;
  writeAs(folder / "a.vtk", cubeSurface(1));
  std::string bytes = readBytes(folder / "a.vtk");
  const auto  points = bytes.find("POINTS 8");
  ASSERT_NE(points, std::string::npos);
  bytes.replace(points, 8, "POINTS 800000");
  writeBytes(folder / "a.vtk", bytes);
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtk"); }), ErrorCode::Truncated);
}

TEST(SurfaceReader, BinaryStlOfAnotherLengthIsRefused)
{
  const TestFolder     folder;
  vtkNew<vtkSTLWriter> writer;
  writer->SetFileName((folder / "a.stl").c_str());
  writer->SetInputData(polyDataOf(cubeSurface(1)));
  writer->SetFileTypeToBinary();
  writer->Write();
  EXPECT_NO_THROW((void)readSurface(folder / "a.stl"));
  const std::string bytes = readBytes(folder / "a.stl");
  writeBytes(folder / "a.stl", bytes.substr(0, bytes.size() - 50));
  EXPECT_THROW((void)readSurface(folder / "a.stl"), BadInput);
}

TEST(SurfaceReader, FlatSurfaceIsRefused)
{
  const TestFolder folder;
  writeBytes(folder / "a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 0 2 1\n");
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.off"); }), ErrorCode::SurfaceDegenerate);
}

TEST(SurfaceReader, XmlSurfaceOfLinesStripsOrWrongOffsetsIsRefused)
{
  const TestFolder folder;
  const auto       data = polyDataOf(cubeSurface(1));
  data->SetLines(data->GetPolys());
  data->SetPolys(nullptr);
  writeBy<vtkXMLPolyDataWriter>(folder / "a.vtp", data);
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtp"); }), ErrorCode::Empty);
  data->SetStrips(data->GetLines());
  writeBy<vtkXMLPolyDataWriter>(folder / "a.vtp", data);
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtp"); }), ErrorCode::Unsupported);

  const std::string begin = "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"3\" "
                            "NumberOfPolys=\"1\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\">"
                            "0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type=\"Int32\" "
                            "Name=\"connectivity\">";
  const std::string middle = "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">";
  const std::string end = "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
  writeBytes(folder / "a.vtp", begin + "0 1 2" + middle + "3" + end);
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtp"); }), ErrorCode::SurfaceOpen);
  writeBytes(folder / "a.vtp", begin + "0 1 9" + middle + "3" + end);
  EXPECT_EQ(codeThrownBy([&] { (void)readSurface(folder / "a.vtp"); }), ErrorCode::SurfaceIndex);
  for (const char * offset : { "-3", "30000", "2000000000" })
  {
    writeBytes(folder / "a.vtp", begin + "0 1 2" + middle + offset + end);
    EXPECT_THROW((void)readSurface(folder / "a.vtp"), BadInput) << offset;
  }
}

TEST(SurfaceReader, MissingFileAndForeignNameAreRefused)
{
  EXPECT_THROW((void)readSurface("/nonexistent/a.off"), BadInput);
  const TestFolder folder;
  writeBytes(folder / "a.step", "x");
  EXPECT_THROW((void)readSurface(folder / "a.step"), BadInput);
}
