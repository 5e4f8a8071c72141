#include "OffReader.h"

#include "FileText.h"

namespace moserhex
{

TriangleMesh
readOff(const std::string & fileName)
{
  FileText               text(fileName, "export the surface again", '#');
  const std::string_view magic = text.nextWord();
  if (magic != "OFF" && magic != "COFF")
  {
    throw BadInput(
      ErrorCode::Format, fileName, "the content is not OFF", "check that the name's ending fits the format");
  }
  const auto vertices = text.nextNumber<std::size_t>("the number of vertices");
  const auto triangles = text.nextNumber<std::size_t>("the number of triangles");
  (void)text.nextLine(); // the number of edges, which nobody keeps up to date
  text.requireRoom(vertices, 3, "vertices");
  text.requireRoom(triangles, 3, "triangles");
  TriangleMesh mesh;
  mesh.vertices.resize(vertices);
  for (Vector3 & vertex : mesh.vertices)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      vertex[axis] = text.nextNumber<double>("a coordinate");
    }
    (void)text.nextLine();
  }
  mesh.triangles.resize(triangles);
  for (Triangle & triangle : mesh.triangles)
  {
    const int corners = text.nextNumber<int>("the number of corners");
    if (corners != 3)
    {
      throw BadInput(ErrorCode::Unsupported,
                     fileName,
                     "a polygon with " + std::to_string(corners) + " corners, need triangles",
                     "triangulate the surface");
    }
    for (VertexIndex & vertex : triangle)
    {
      vertex = text.nextNumber<VertexIndex>("a vertex number");
    }
    (void)text.nextLine();
  }
  return mesh;
}

} // namespace moserhex
