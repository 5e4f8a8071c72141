#include "ViewerSection.h"

#include "HtmlText.h"
#include "MeshData.h"
#include "PageFrame.h"

#include <algorithm>
#include <array>

namespace moserhex::app
{
namespace
{

std::string
slider(const std::string & id, const std::string & label, int least, int most, int value)
{
  return "<label for=\"" + id + "\">" + label + "</label><input type=\"range\" id=\"" + id + "\" min=\"" +
         std::to_string(least) + "\" max=\"" + std::to_string(most) + "\" step=\"1\" value=\"" + std::to_string(value) +
         "\"><output id=\"" + id + "-value\" for=\"" + id + "\">" + std::to_string(value) + "</output>\n";
}

std::string
cutControls(int cells)
{
  static constexpr std::array<std::array<const char *, 3>, 3> axes{
    { { "i", "Right", "Left" }, { "j", "Anterior", "Posterior" }, { "k", "Inferior", "Superior" } }
  };
  std::string html;
  for (const auto & axis : axes)
  {
    const std::string name = axis[0];
    html += slider("cut-" + name + "-low", name + " from (" + axis[1] + ")", 1, cells, 1) +
            slider("cut-" + name + "-high", name + " to (" + axis[2] + ")", 1, cells, cells);
  }
  return html;
}

std::string
controls(const HexMesh & mesh, const std::vector<CellField> & fields)
{
  std::string options;
  for (const CellField & field : fields)
  {
    options += "<option value=\"" + field.id + "\"" + (field.id == "scaled-jacobian" ? " selected" : "") + ">" +
               escapeHtml(field.name) + "</option>";
  }
  const auto shell =
    std::find_if(fields.begin(), fields.end(), [](const CellField & field) { return field.id == "shell"; });
  const int shells = static_cast<int>(shell->shown.high);
  return "<div id=\"viewer-controls\" class=\"viewer-controls\">\n<fieldset><legend>Colour</legend><label "
         "for=\"colour-by\">Colour cells by</label><select id=\"colour-by\">" +
         options +
         "</select>\n<div id=\"colour-legend\" class=\"colour-legend\"></div>\n<div class=\"check\"><input "
         "type=\"checkbox\" id=\"show-edges\" checked><label for=\"show-edges\">Edges of the cells</label></div>\n"
         "</fieldset>\n<fieldset class=\"sliders\"><legend>Shells</legend>" +
         slider("shell-low", "from (inner)", 1, shells, 1) + slider("shell-high", "to (outer)", 1, shells, shells) +
         "</fieldset>\n<fieldset class=\"sliders\"><legend>Cut along the lattice</legend>" +
         cutControls(mesh.nodesPerSide - 1) +
         "</fieldset>\n<fieldset><legend>View from</legend><div class=\"buttons\"><button type=\"button\" "
         "data-view=\"A\">Front</button><button type=\"button\" data-view=\"P\">Back</button><button type=\"button\" "
         "data-view=\"R\">Right</button><button type=\"button\" data-view=\"L\">Left</button><button type=\"button\" "
         "data-view=\"S\">Top</button><button type=\"button\" data-view=\"I\">Bottom</button></div><div "
         "class=\"buttons\"><button type=\"button\" id=\"half-view\">Half of it</button><button type=\"button\" "
         "id=\"whole-view\">Whole "
         "mesh</button></div></fieldset>\n</div>\n";
}

} // namespace

std::string
viewerSection(const HexMesh & mesh, const std::vector<CellField> & fields)
{
  if (mesh.nodesPerSide > mostNodesPerSide)
  {
    return section("view",
                   "In three dimensions",
                   "<p>A mesh of " + std::to_string(mesh.nodesPerSide) +
                     " nodes a side is too large for a page (at most " + std::to_string(mostNodesPerSide) +
                     "). Open the mesh itself in ParaView or 3D Slicer.</p>\n");
  }
  return section(
    "view",
    "In three dimensions",
    "<p>Drag to turn, wheel to zoom, or focus the picture and use the arrow keys, + and &minus;. Letters say where the "
    "patient's Right, Left, Anterior, Posterior, Superior and Inferior are. Positions are rounded for display; the "
    "mesh "
    "file has all digits.</p>\n<div class=\"viewer\">\n<div class=\"viewer-stage\"><canvas id=\"viewer-canvas\" "
    "tabindex=\"0\" role=\"img\" aria-label=\"The mesh in three dimensions. Arrow keys turn it, plus and minus zoom.\">"
    "</canvas><div id=\"viewer-letters\" aria-hidden=\"true\"></div><p id=\"viewer-message\" class=\"viewer-message\">"
    "The 3-D view needs JavaScript and WebGL. The slices and histograms do not.</p><p id=\"viewer-count\" "
    "class=\"viewer-count\" role=\"status\"></p></div>\n" +
      controls(mesh, fields) + "</div>\n" + dataElement("mesh-data", meshDataJson(mesh, fields)));
}

} // namespace moserhex::app
