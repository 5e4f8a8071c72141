#include "HexMeshFormats.h"
#include "MeshText.h"

namespace moserhex
{

std::string
meditText(const HexMeshContent & content)
{
  const HexMesh & mesh = content.mesh;
  const auto      faces = cubeFaces(mesh);
  MeshText        text;
  text << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.nodes.size() << '\n';
  for (const Vector3 & node : mesh.nodes)
  {
    text.position(node, " ") << " 0\n";
  }
  std::size_t sides = 0;
  for (const CubeFace & face : faces)
  {
    sides += face.sides.size();
  }
  text << "Quadrilaterals\n" << sides << '\n';
  for (std::size_t number = 0; number < faces.size(); ++number)
  {
    for (const CubeFaceSide & side : faces[number].sides)
    {
      text.list(fromOne(side.nodes), " ") << ' ' << number + 1 << '\n';
    }
  }
  text << "Hexahedra\n" << mesh.cellCount() << '\n';
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    text.list(fromOne(mesh.cellNodes(cell)), " ") << ' ' << content.shell[cell] << '\n';
  }
  text << "End\n";
  return text.take();
}

} // namespace moserhex
