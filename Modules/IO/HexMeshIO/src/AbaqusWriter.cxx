#include "HexMeshFormats.h"
#include "MeshText.h"

namespace moserhex
{
namespace
{

/** A number of at most 20 characters, which is all that Abaqus and CalculiX read of one. Never with an exponent: cut
 * off, it would be another number. Exact from 0.1 on, below that to 1e-17. \param value  |value| < 1e17 */
std::string
shortNumber(double value)
{
  constexpr std::size_t longest = 20;
  std::array<char, 400> digits{};
  const auto            end = digits.data() + digits.size();
  std::string           number(digits.data(), std::to_chars(digits.data(), end, value, std::chars_format::fixed).ptr);
  const std::size_t     point = number.find('.');
  if (point == std::string::npos)
  {
    return number + '.';
  }
  if (number.size() > longest)
  {
    const int places = static_cast<int>(longest - point - 1);
    number.assign(digits.data(), std::to_chars(digits.data(), end, value, std::chars_format::fixed, places).ptr);
  }
  return number;
}

/** Sixteen numbers a line, the most that Abaqus takes. */
void
addSet(MeshText & text, std::string_view keyword, std::string_view name, const std::vector<std::size_t> & members)
{
  text << '*' << keyword << ", " << keyword << '=' << name << '\n';
  for (std::size_t member = 0; member < members.size(); ++member)
  {
    const bool endsLine = member % 16 == 15 || member + 1 == members.size();
    text << members[member] + 1 << (endsLine ? "\n" : ", ");
  }
}

} // namespace

std::string
abaqusText(const HexMeshContent & content)
{
  const HexMesh & mesh = content.mesh;
  MeshText        text;
  text << "*HEADING\nMoserHex hexahedral mesh, LPS millimetres\n*NODE, NSET=ALL\n";
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    const Vector3 & position = mesh.nodes[node];
    text << node + 1 << ", " << shortNumber(position.x()) << ", " << shortNumber(position.y()) << ", "
         << shortNumber(position.z()) << '\n';
  }
  text << "*ELEMENT, TYPE=C3D8, ELSET=ALL\n";
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    text << cell + 1 << ", ";
    text.list(fromOne(mesh.cellNodes(cell)), ", ") << '\n';
  }
  const auto shells = cellsOfShells(content.shell);
  for (std::size_t shell = 1; shell <= shells.size(); ++shell)
  {
    addSet(text, "ELSET", shellName(mesh, shell), shells[shell - 1]);
  }
  for (const CubeFace & face : cubeFaces(mesh))
  {
    addSet(text, "NSET", face.name, face.nodes);
  }
  return text.take();
}

} // namespace moserhex
