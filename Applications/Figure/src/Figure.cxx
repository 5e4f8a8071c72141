#include "Figure.h"

#include "Annotations.h"
#include "CommandErrors.h"
#include "DepthOrder.h"
#include "Facets.h"
#include "OutputName.h"
#include "SlicePlane.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexCellReader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace moserhex::app
{
namespace
{

/** Shells shown when none are named. */
constexpr int usualShells = 4;

PictureFormat
formatOf(const std::string & fileName)
{
  const std::string ending = std::filesystem::path(fileName).extension().string();
  if (ending == ".png" || ending == ".PNG")
  {
    return PictureFormat::Png;
  }
  if (ending == ".svg" || ending == ".SVG")
  {
    return PictureFormat::Svg;
  }
  throw UsageError(fileMessage(fileName, "not a picture's name", "give an OUTPUT that ends with .png or .svg"));
}

Panel
inDrawingOrder(std::vector<SeenFacet> facets, const std::string & caption)
{
  Panel panel;
  panel.caption = caption;
  for (const std::size_t facet : drawingOrder(facets))
  {
    panel.facets.push_back(std::move(facets[facet]));
  }
  return panel;
}

std::vector<std::size_t>
allCells(const DrawnMesh & mesh)
{
  std::vector<std::size_t> cells(mesh.cells.cellCount());
  std::iota(cells.begin(), cells.end(), std::size_t{ 0 });
  return cells;
}

/** The chosen shells, or up to four at equal distances from the outermost inwards, the largest first. */
std::vector<int>
chosenShells(const std::vector<int> & chosen, int outermost)
{
  std::vector<int> shells = chosen;
  const int        count = std::min(usualShells, outermost);
  for (int number = 0; chosen.empty() && number < count; ++number)
  {
    shells.push_back(outermost - number * outermost / count);
  }
  std::sort(shells.rbegin(), shells.rend());
  shells.erase(std::unique(shells.begin(), shells.end()), shells.end());
  if (shells.back() < 1 || shells.front() > outermost)
  {
    throw InvalidInput("shell " + std::to_string(shells.back() < 1 ? shells.back() : shells.front()) +
                       " is not there; they go from 1 to " + std::to_string(outermost));
  }
  return shells;
}

std::vector<Panel>
shellPanels(const DrawnMesh & mesh, const FigureOptions & options, const Camera & camera)
{
  const HexMesh &        lattice = requireLatticeFor(mesh, "pictures of shells");
  const std::vector<int> shellOfCell = shellOfCells(lattice);
  const Positions        places = cellPlaces(lattice);
  const std::vector<int> shells =
    chosenShells(options.shells, *std::max_element(shellOfCell.begin(), shellOfCell.end()));
  std::vector<std::vector<std::size_t>> groups; // of cells that are drawn together
  std::vector<std::string>              captions;
  for (const int shell : shells)
  {
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < shellOfCell.size(); ++cell)
    {
      if (shellOfCell[cell] == shell)
      {
        cells.push_back(cell);
      }
    }
    const std::string count = std::to_string(cells.size()) + (cells.size() == 1 ? " cell" : " cells");
    cells = withoutNearestOctant(cells, places, camera);
    if (options.layout == "nested" && !groups.empty())
    {
      groups.front().insert(groups.front().end(), cells.begin(), cells.end());
    }
    else
    {
      groups.push_back(cells);
      captions.push_back(options.layout == "nested" ? "" : "shell " + std::to_string(shell) + ": " + count);
    }
  }
  std::vector<Panel> panels;
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    panels.push_back(inDrawingOrder(facesSeen(mesh.cells, groups[group], camera), captions[group]));
  }
  return panels;
}

Panel
slicePanel(const DrawnMesh & mesh, const SlicePlane & plane, const Camera & camera)
{
  if (plane.layer)
  {
    const HexMesh & lattice = requireLatticeFor(mesh, "layers of a lattice");
    return inDrawingOrder(layerSeen(lattice, plane.axis, *plane.layer, camera), "");
  }
  double lowest = mesh.cells.nodes.front()[plane.axis];
  double highest = lowest;
  for (const Vector3 & node : mesh.cells.nodes)
  {
    lowest = std::min(lowest, node[plane.axis]);
    highest = std::max(highest, node[plane.axis]);
  }
  const double           position = plane.position.value_or(0.5 * (lowest + highest));
  std::vector<SeenFacet> sections = sectionsSeen(mesh.cells, plane.axis, position, camera);
  if (sections.empty())
  {
    throw InvalidInput("the plane at " + std::to_string(position) + " mm does not meet the mesh, which reaches from " +
                       std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return inDrawingOrder(std::move(sections), "");
}

Camera
cameraOf(const FigureOptions & options)
{
  if (options.kind == "slice" && !options.azimuth && !options.elevation)
  {
    return cameraOfSlice(parsePlane(options.plane).axis);
  }
  return cameraFrom(options.azimuth.value_or(30.0), options.elevation.value_or(25.0));
}

std::vector<Panel>
panelsOf(const DrawnMesh & mesh, const FigureOptions & options, const Camera & camera)
{
  if (options.kind == "shells")
  {
    return shellPanels(mesh, options, camera);
  }
  if (options.kind == "slice")
  {
    return { slicePanel(mesh, parsePlane(options.plane), camera) };
  }
  return { inDrawingOrder(facesSeen(mesh.cells, allCells(mesh), camera), "") };
}

void
drawPanels(Canvas &                   canvas,
           const std::vector<Panel> & panels,
           const Arrangement &        arrangement,
           const CellColours &        colours,
           bool                       edges,
           const Style &              style)
{
  for (std::size_t panel = 0; panel < panels.size(); ++panel)
  {
    for (const SeenFacet & facet : panels[panel].facets)
    {
      std::vector<Point2> outline;
      for (const Point2 & corner : facet.outline)
      {
        outline.push_back(arrangement.place(panel, corner));
      }
      const Colour colour = shaded(colours.of(facet.cell), facet.light);
      // Without lines around cells, one in its own colour closes the gap to the next cell.
      const Pen pen = edges ? Pen{ { 0.05, 0.05, 0.05, 1.0 }, 0.8 * style.unit } : Pen{ colour, 0.6 };
      canvas.polygon(outline, colour, pen);
    }
    canvas.text(
      arrangement.captions[panel], panels[panel].caption, 0.9 * style.letters(), style.ink, TextAlign::Middle);
  }
}

} // namespace

Figure
drawFigure(const DrawnMesh & mesh, const FigureOptions & options)
{
  const PictureFormat      format = formatOf(options.output);
  const Colour             background = parseColour(options.background);
  const Camera             camera = cameraOf(options);
  const CellColours        colours = colourCells(mesh, options);
  const std::vector<Panel> panels = panelsOf(mesh, options, camera);

  const double    unit = std::sqrt(options.width * options.height / (1200.0 * 900.0));
  const Style     style{ inkOn(background), std::min({ unit, options.width / 800.0, options.height / 450.0 }) };
  const double    margin = 24.0 * style.unit;
  const double    titleHeight = options.title.empty() ? 0.0 : 52.0 * style.unit;
  const double    legendWidth = 190.0 * style.unit;
  const double    scaleHeight = 50.0 * style.unit;
  const double    width = options.width - 3.0 * margin - legendWidth;
  const double    height = options.height - 2.0 * margin - titleHeight;
  const Rectangle whole{ margin, margin + titleHeight, width, height };
  const bool      hasLetters = options.kind == "slice" && !options.azimuth && !options.elevation;
  const double    letterRoom = hasLetters ? 32.0 * style.unit : 0.0;
  const Rectangle sides{ whole.left, whole.top, whole.width, whole.height - scaleHeight };
  const Rectangle picture{
    sides.left + letterRoom, sides.top + letterRoom, sides.width - 2.0 * letterRoom, sides.height - 2.0 * letterRoom
  };
  const double      captionHeight = panels.front().caption.empty() ? 0.0 : 34.0 * style.unit;
  const Arrangement arrangement = arrange(panels, picture, captionHeight, 20.0 * style.unit);

  Canvas canvas(format, options.width, options.height, background);
  drawPanels(canvas, panels, arrangement, colours, options.edges, style);
  const Rectangle legend{ whole.left + whole.width + margin, whole.top + 0.08 * height, legendWidth, 0.62 * height };
  drawLegend(canvas, legend, colours, panels, style);
  drawScaleBar(canvas, whole, arrangement.scale, style);
  if (hasLetters)
  {
    drawSideLetters(canvas, sides, camera, style);
  }
  else
  {
    drawAxes(canvas, { legend.left + 0.4 * legendWidth, whole.top + height - 75.0 * style.unit }, camera, style);
  }
  canvas.text({ 0.5 * options.width, margin + 24.0 * style.unit },
              options.title,
              1.3 * style.letters(),
              style.ink,
              TextAlign::Middle);

  Figure figure{ canvas.finish(), 0 };
  for (const Panel & panel : panels)
  {
    figure.polygons += panel.facets.size();
  }
  return figure;
}

WrittenFigure
writeFigure(const FigureOptions & options)
{
  (void)formatOf(options.output);
  requireKept(options.mesh, options.output);
  requireKept(options.labelImage, options.output);
  AtomicFile  file(options.output);
  const auto  readMesh = isFigureColour(options.colour) ? readHexCells : readHexCellsWithArrays;
  HexCellFile read = readMesh(options.mesh, { options.sandbox });
  DrawnMesh   mesh{ std::move(read.mesh), {}, options.mesh, std::move(read.arrays) };
  mesh.lattice = asLattice(mesh.cells);
  const Figure figure = drawFigure(mesh, options);
  file.writeText(figure.bytes);
  file.commit();
  return { figure.polygons, std::move(read.warnings) };
}

} // namespace moserhex::app
