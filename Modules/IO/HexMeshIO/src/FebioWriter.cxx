#include "HexMeshFormats.h"
#include "MeshText.h"

namespace moserhex
{
namespace
{

/** FEBio opens no mesh without a material; this one says by its name that it is to be replaced. */
constexpr const char * head =
  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
  "<!-- MoserHex hexahedral mesh, LPS millimetres. The material is a placeholder: replace it. -->\n"
  "<febio_spec version=\"4.0\">\n"
  "  <Module type=\"solid\"/>\n"
  "  <Material>\n"
  "    <material id=\"1\" name=\"placeholder\" type=\"neo-Hookean\">\n"
  "      <density>1</density>\n"
  "      <E>1</E>\n"
  "      <v>0.3</v>\n"
  "    </material>\n"
  "  </Material>\n";

void
addFace(MeshText & text, const CubeFace & face)
{
  text << "    <NodeSet name=\"" << face.name << "\">";
  text.list(fromOne(face.nodes), ",") << "</NodeSet>\n";
  text << "    <Surface name=\"" << face.name << "\">\n";
  for (std::size_t side = 0; side < face.sides.size(); ++side)
  {
    text << "      <quad4 id=\"" << side + 1 << "\">";
    text.list(fromOne(face.sides[side].nodes), ",") << "</quad4>\n";
  }
  text << "    </Surface>\n";
}

} // namespace

std::string
febioText(const HexMeshContent & content)
{
  const HexMesh & mesh = content.mesh;
  const auto      shells = cellsOfShells(content.shell);
  MeshText        text;
  text << head << "  <Mesh>\n    <Nodes name=\"ALL\">\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    text << "      <node id=\"" << node + 1 << "\">";
    text.position(mesh.nodes[node], ",") << "</node>\n";
  }
  text << "    </Nodes>\n";
  for (std::size_t shell = 1; shell <= shells.size(); ++shell)
  {
    text << "    <Elements type=\"hex8\" name=\"" << shellName(mesh, shell) << "\">\n";
    for (const std::size_t cell : shells[shell - 1])
    {
      text << "      <elem id=\"" << cell + 1 << "\">";
      text.list(fromOne(mesh.cellNodes(cell)), ",") << "</elem>\n";
    }
    text << "    </Elements>\n";
  }
  for (const CubeFace & face : cubeFaces(mesh))
  {
    addFace(text, face);
  }
  text << "  </Mesh>\n  <MeshDomains>\n";
  for (std::size_t shell = 1; shell <= shells.size(); ++shell)
  {
    text << "    <SolidDomain name=\"" << shellName(mesh, shell) << "\" mat=\"placeholder\"/>\n";
  }
  text << "  </MeshDomains>\n</febio_spec>\n";
  return text.take();
}

} // namespace moserhex
