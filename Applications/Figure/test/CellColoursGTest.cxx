// Exact: which value gets which colour. Numbers of cells by closed form to round-off (1e-12).
#include "CellColours.h"

#include "TestFolder.h"
#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"
#include "moserhex/HexMeshIO/LabelImageWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
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

DrawnMesh
foreign(const HexMesh & mesh)
{
  return { unstructured(mesh), {}, "mesh.vtu" };
}

FigureOptions
by(const std::string & colour)
{
  FigureOptions options;
  options.colour = colour;
  return options;
}

bool
same(const Colour & a, const Colour & b)
{
  return a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
}

std::string
refusalOf(const DrawnMesh & mesh, const FigureOptions & options)
{
  return analytic::messageOf<Error>([&] { (void)colourCells(mesh, options); });
}

/** Slabs along i of widths 1 and 3. */
HexMesh
slabs()
{
  return analytic::lattice(3, [](const Vector3 & c) { return Vector3(c[0] < 2.0 ? c[0] : 4.0, c[1], c[2]); });
}

} // namespace

TEST(CellColours, NumbersAreThoseOfQuality)
{
  const CellColours volume = colourCells(drawn(slabs()), by("volume"));
  EXPECT_NEAR(volume.values[0], 0.5, 1e-12);
  EXPECT_NEAR(volume.values[1], 1.5, 1e-12);
  EXPECT_NEAR(volume.low, 0.5, 1e-12);
  EXPECT_NEAR(volume.high, 1.5, 1e-12);
  const CellColours aspect = colourCells(foreign(slabs()), by("aspect"));
  EXPECT_NEAR(aspect.values[0], 1.0, 1e-12);
  EXPECT_NEAR(aspect.values[1], 3.0, 1e-12);
  EXPECT_EQ(aspect.low, 1.0);
  EXPECT_NEAR(aspect.high, 3.0, 1e-12);
  const CellColours jacobian = colourCells(drawn(slabs()), by("scaled-jacobian"));
  EXPECT_NEAR(jacobian.values[1], 1.0, 1e-12);
  EXPECT_EQ(jacobian.low, 0.0);
  EXPECT_EQ(jacobian.high, 1.0);
  EXPECT_NEAR(colourCells(drawn(slabs()), by("taper")).values[1], 0.0, 1e-12);
}

TEST(CellColours, RoundingErrorsOfEqualVolumesDoNotFillTheScale)
{
  const CellColours colours = colourCells(drawn(analytic::cubeLattice(4, 0.1)), by("volume"));
  EXPECT_EQ(colours.low, 0.9);
  EXPECT_EQ(colours.high, 1.1);
}

TEST(CellColours, OfVolumesThatDifferMuchTheScaleEndsAtNoVolume)
{
  const HexMesh wide =
    analytic::lattice(4, [](const Vector3 & c) { return Vector3(c[0] < 3.0 ? c[0] : 9.0, c[1], c[2]); });
  const CellColours colours = colourCells(drawn(wide), by("volume"));
  EXPECT_EQ(colours.low, 0.0);
  EXPECT_EQ(colours.high, 2.0);
}

TEST(CellColours, ValuesBeyondTheRangeGetTheColoursOfItsEnds)
{
  FigureOptions options = by("volume");
  options.range = { 0.8, 1.2 };
  const CellColours colours = colourCells(drawn(slabs()), options);
  EXPECT_TRUE(same(colours.of(0), divergingScale().at(0.0)));
  EXPECT_TRUE(same(colours.of(1), divergingScale().at(1.0)));
  EXPECT_TRUE(same(divergingScale().at(-3.0), divergingScale().at(0.0)));
}

TEST(CellColours, EveryShellHasAColourOfItsOwnAndPaddingItsName)
{
  const HexMesh     mesh = analytic::paddedLattice(6, 1, [](const Vector3 & index) { return index; });
  const CellColours colours = colourCells(drawn(mesh), by("shell"));
  ASSERT_EQ(colours.classes.size(), 4U);
  EXPECT_EQ(colours.classes[2].name, "3");
  EXPECT_EQ(colours.classes[3].name, "padding 1");
  EXPECT_EQ(std::count(colours.values.begin(), colours.values.end(), 1.0), 1);
  EXPECT_EQ(std::count(colours.values.begin(), colours.values.end(), 4.0), 6 * 25);
  for (std::size_t one = 1; one < 4; ++one)
  {
    EXPECT_FALSE(same(colours.classes[one - 1].colour, colours.classes[one].colour));
  }
}

TEST(CellColours, LabelsComeFromTheLabelmap)
{
  const TestFolder folder;
  LabelVolume      labels; // left half 0, right half 2
  labels.size = { { 4, 4, 4 } };
  for (int voxel = 0; voxel < 64; ++voxel)
  {
    labels.inside.push_back(voxel % 4 < 2 ? 0 : 2);
  }
  writeLabelImage(folder / "labels.nrrd", labels);
  FigureOptions options = by("label");
  options.labelImage = folder / "labels.nrrd";
  const CellColours colours = colourCells(drawn(analytic::cubeLattice(4)), options); // cells [0,1], [1,2], [2,3]
  ASSERT_EQ(colours.classes.size(), 2U);
  EXPECT_EQ(colours.classes[0].name, "none");
  EXPECT_EQ(colours.classes[1].name, "2");
  EXPECT_EQ(colours.values[0], 0.0);
  EXPECT_EQ(colours.values[2], 2.0);
  EXPECT_TRUE(same(colours.of(2), categoryColour(1)));
}

TEST(CellColours, ArrayOfTheFileFillsTheScaleAndWhatIsNoNumberIsGrey)
{
  DrawnMesh mesh = drawn(slabs());
  mesh.arrays.ofCells = { { "Stretch", 1, { 1.5, 0.5, 1.0, 1.0, 1.0, 1.0, std::nan(""), 1.0 } },
                          { "Same", 1, std::vector<double>(8, 2.0) },
                          { "Zero", 1, std::vector<double>(8, 0.0) } };
  const CellColours colours = colourCells(mesh, by("Stretch"));
  EXPECT_EQ(colours.title, "Stretch");
  EXPECT_EQ(colours.low, 0.5);
  EXPECT_EQ(colours.high, 1.5);
  EXPECT_TRUE(colours.hasNumber(5));
  EXPECT_FALSE(colours.hasNumber(6));
  EXPECT_TRUE(same(colours.of(0), sequentialScale().at(1.0)));
  EXPECT_TRUE(same(colours.of(1), sequentialScale().at(0.0)));
  EXPECT_TRUE(same(colours.of(6), noNumberColour));
  const CellColours equal = colourCells(mesh, by("Same"));
  EXPECT_NEAR(equal.low, 1.9, 1e-12);
  EXPECT_NEAR(equal.high, 2.1, 1e-12);
  EXPECT_EQ(colourCells(mesh, by("Zero")).high, 1.0);
  FigureOptions limited = by("Stretch");
  limited.range = { 0.0, 1.0 };
  EXPECT_EQ(colourCells(mesh, limited).low, 0.0);
}

TEST(CellColours, AnArrayWithBothSignsHasItsMiddleAtZero)
{
  DrawnMesh mesh = drawn(slabs());
  mesh.arrays.ofCells = { { "Motion", 1, { 1.5, -0.5, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0 } },
                          { "Noise", 1, { 9e-15, -2e-15, 0.0, 1e-15, 0.0, 0.0, 0.0, 0.0 } } };
  const CellColours motion = colourCells(mesh, by("Motion"));
  EXPECT_EQ(motion.low, -1.5);
  EXPECT_EQ(motion.high, 1.5);
  EXPECT_TRUE(same(motion.of(6), divergingScale().at(0.5)));
  FigureOptions limited = by("Motion");
  limited.range = { -1.0, 3.0 };
  EXPECT_TRUE(same(colourCells(mesh, limited).of(6), sequentialScale().at(0.25)));
  const CellColours noise = colourCells(mesh, by("Noise"));
  EXPECT_GT(noise.high, 0.9); // rounding does not fill the scale
  EXPECT_LT(noise.low, -0.9);
}

TEST(CellColours, ContradictionsAreRefused)
{
  const DrawnMesh mesh = drawn(slabs());
  FigureOptions   options = by("volume");
  options.range = { 1.2, 0.8 };
  EXPECT_NE(refusalOf(mesh, options).find("lower one first"), std::string::npos);
  options = by("shell");
  options.range = { 0.0, 1.0 };
  EXPECT_NE(refusalOf(mesh, options).find("--range is for numbers"), std::string::npos);
  EXPECT_NE(refusalOf(mesh, by("label")).find("--label-image"), std::string::npos);
  options = by("volume");
  options.labelImage = "labels.nrrd";
  EXPECT_NE(refusalOf(mesh, options).find("--colour label"), std::string::npos);
  EXPECT_NE(refusalOf(foreign(slabs()), by("shell")).find("not a lattice"), std::string::npos);
  HexMesh flat = slabs();
  for (Vector3 & node : flat.nodes)
  {
    node[2] = 0.0;
  }
  EXPECT_NE(refusalOf(drawn(flat), by("volume")).find("mean volume"), std::string::npos);
}

TEST(Colours, AreReadFromWordsAndDigits)
{
  EXPECT_TRUE(same(parseColour("white"), { 1.0, 1.0, 1.0, 1.0 }));
  EXPECT_EQ(parseColour("none").alpha, 0.0);
  EXPECT_TRUE(same(parseColour("ff0080"), { 1.0, 0.0, 128.0 / 255.0, 1.0 }));
  for (const char * wrong : { "", "red", "ff008", "ff00800", "gg0000", "-f0000", "#ff0080" })
  {
    EXPECT_NE(analytic::messageOf<Error>([&] { (void)parseColour(wrong); }).find("no colour"), std::string::npos)
      << wrong;
  }
  EXPECT_LT(inkOn(parseColour("white")).red, 0.5);
  EXPECT_GT(inkOn(parseColour("black")).red, 0.5);
}
