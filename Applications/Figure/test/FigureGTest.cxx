// Exact: bytes, polygons and pixels of pictures.
#include "Figure.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

DrawnMesh
drawn(const HexMesh & mesh)
{
  return { unstructured(mesh), mesh, "mesh.vtu" };
}

FigureOptions
options(const std::string & kind, const std::string & output)
{
  FigureOptions result;
  result.kind = kind;
  result.output = output;
  result.width = 400;
  result.height = 300;
  return result;
}

std::size_t
countOf(const std::string & text, const std::string & part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

std::string
refusalOf(const FigureOptions & wanted, const DrawnMesh & mesh = drawn(analytic::cubeLattice(6)))
{
  return analytic::messageOf<Error>([&] { (void)drawFigure(mesh, wanted); });
}

/** Width and height in a PNG's header. */
std::pair<int, int>
sizeOf(const std::string & png)
{
  const auto number = [&png](std::size_t at) {
    int value = 0;
    for (std::size_t byte = at; byte < at + 4; ++byte)
    {
      value = value * 256 + static_cast<unsigned char>(png[byte]);
    }
    return value;
  };
  return { number(16), number(20) };
}

} // namespace

TEST(Figure, SurfaceOfACubeIsThreeSidesOfPolygons)
{
  const Figure figure = drawFigure(drawn(analytic::cubeLattice(6)), options("surface", "a.svg"));
  EXPECT_EQ(figure.polygons, 3U * 25U);
  EXPECT_EQ(figure.bytes.compare(0, 5, "<?xml"), 0);
  // Each is filled and outlined with the pen of the lines between cells.
  EXPECT_EQ(countOf(figure.bytes, "stroke:rgb(5%,5%,5%)"), 3U * 25U);
}

TEST(Figure, ShellsAreShownWithoutTheNearestEighth)
{
  FigureOptions wanted = options("shells", "a.svg");
  wanted.colour = "shell";
  const Figure apart = drawFigure(drawn(analytic::cubeLattice(6)), wanted); // 5^3 cells, shells 1 to 3
  // Shell 3: of 3 sides 5 x 5 - 2 x 2 squares, of each wall of the hole three, for the fourth leads into the hollow,
  // and the hollow's 3 far walls of 3 x 3. Shell 2: 3 (9 - 1) + 3 + 3. Shell 1 is one cell.
  const std::size_t outermost = 3U * 21U + 3U * 3U + 3U * 9U;
  EXPECT_EQ(apart.polygons, outermost + 30U + 3U);
  wanted.shells = { 3 };
  EXPECT_EQ(drawFigure(drawn(analytic::cubeLattice(6)), wanted).polygons, outermost);
  wanted.layout = "nested";
  wanted.shells = { 1, 2, 3 };
  EXPECT_EQ(drawFigure(drawn(analytic::cubeLattice(6)), wanted).polygons, 3U * 25U);
}

TEST(Figure, SliceHasAPolygonForEachCellThatIsCut)
{
  FigureOptions wanted = options("slice", "a.svg");
  EXPECT_EQ(drawFigure(drawn(analytic::cubeLattice(6)), wanted).polygons, 25U);
  wanted.plane = "k:4";
  EXPECT_EQ(drawFigure(drawn(analytic::cubeLattice(6)), wanted).polygons, 25U);
  wanted.plane = "coronal:0.3";
  EXPECT_EQ(drawFigure({ unstructured(analytic::cubeLattice(6)), {}, "foreign.msh" }, wanted).polygons, 25U);
}

TEST(Figure, SameMeshAndOptionsGiveTheSameBytes)
{
  for (const char * output : { "a.png", "a.svg" })
  {
    for (const char * kind : { "surface", "shells", "slice" })
    {
      const DrawnMesh mesh = drawn(analytic::cubeLattice(6));
      EXPECT_TRUE(drawFigure(mesh, options(kind, output)).bytes == drawFigure(mesh, options(kind, output)).bytes)
        << output << kind;
    }
  }
}

TEST(Figure, PictureHasTheSizeThatWasAskedFor)
{
  FigureOptions wanted = options("surface", "a.png");
  wanted.width = 640;
  wanted.height = 320;
  const std::string png = drawFigure(drawn(analytic::cubeLattice(3)), wanted).bytes;
  EXPECT_EQ(png.compare(0, 8, "\x89PNG\r\n\x1a\n"), 0);
  EXPECT_EQ(sizeOf(png), std::make_pair(640, 320));
  wanted.output = "a.svg";
  const std::string svg = drawFigure(drawn(analytic::cubeLattice(3)), wanted).bytes;
  EXPECT_NE(svg.find("viewBox=\"0 0 640 320\""), std::string::npos) << svg.substr(0, 300);
}

TEST(Figure, EveryChoiceChangesThePicture)
{
  const HexMesh mesh = analytic::lattice(
    6, [](const Vector3 & c) { return Vector3(c[0] + 0.05 * c[0] * c[1], c[1], c[2] * (1.0 + 0.1 * c[0])); });
  const FigureOptions plain = options("surface", "a.svg");
  const std::string   before = drawFigure(drawn(mesh), plain).bytes;
  const auto          changed = [&](const auto & change) {
    FigureOptions other = plain;
    change(other);
    return drawFigure(drawn(mesh), other).bytes != before;
  };
  EXPECT_TRUE(changed([](FigureOptions & other) { other.azimuth = 31.0; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.elevation = 26.0; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.colour = "volume"; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.range = { 0.0, 0.9 }; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.title = "prostate"; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.background = "none"; }));
  EXPECT_TRUE(changed([](FigureOptions & other) { other.edges = false; }));
}

TEST(Figure, LegendOfAnArraySaysWhatHasNoNumberAndFitsALongName)
{
  const HexMesh cube = analytic::cubeLattice(3);
  DrawnMesh     mesh = drawn(cube);
  NamedArray    array{ std::string(60, 'W'), 1, std::vector<double>(8, 1.0) };
  mesh.arrays.ofCells = { array };
  FigureOptions wanted = options("surface", "a.svg");
  wanted.colour = array.name;
  const std::string whole = drawFigure(mesh, wanted).bytes;
  EXPECT_EQ(countOf(whole, "fill:rgb(60%,60%,60%)"), 0U);
  mesh.arrays.ofCells[0].values[7] = std::nan("");
  const std::string withGap = drawFigure(mesh, wanted).bytes;
  EXPECT_EQ(countOf(withGap, "fill:rgb(60%,60%,60%)"), 1U); // the legend's; faces are shaded
  EXPECT_NE(whole, withGap);
  mesh.arrays.ofCells[0].values[7] = 1.0;
  mesh.arrays.ofCells[0].values[2] = std::nan(""); // behind, below, on the right: not seen
  EXPECT_EQ(drawFigure(mesh, wanted).bytes, whole);
}

TEST(Figure, WhatIsNotThereIsRefused)
{
  FigureOptions wanted = options("surface", "a.pdf");
  EXPECT_NE(refusalOf(wanted).find(".png or .svg"), std::string::npos);
  wanted = options("shells", "a.png");
  wanted.shells = { 2, 4 };
  EXPECT_NE(refusalOf(wanted).find("shell 4 is not there; they go from 1 to 3"), std::string::npos);
  wanted.shells = { 0 };
  EXPECT_NE(refusalOf(wanted).find("shell 0"), std::string::npos);
  wanted = options("slice", "a.png");
  wanted.plane = "axial:5.5";
  EXPECT_NE(refusalOf(wanted).find("does not meet the mesh"), std::string::npos);
  wanted.plane = "i:5";
  EXPECT_NE(refusalOf(wanted).find("layer 5"), std::string::npos);
  const DrawnMesh foreign{ unstructured(analytic::cubeLattice(6)), {}, "foreign.msh" };
  EXPECT_NE(refusalOf(wanted, foreign).find("not a lattice"), std::string::npos);
  EXPECT_NE(refusalOf(options("shells", "a.png"), foreign).find("not a lattice"), std::string::npos);
}
