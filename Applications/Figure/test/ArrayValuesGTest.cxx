// Numbers by closed form to round-off (1e-12).
#include "ArrayValues.h"

#include "moserhex/Analytic/Lattices.h"
#include "moserhex/Analytic/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace moserhex;
using namespace moserhex::app;

namespace
{

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/** 2 x 2 x 2 cells with corners at whole numbers; Place is where a node is. */
DrawnMesh
drawn()
{
  const HexMesh mesh = analytic::cubeLattice(3);
  NamedArray    place{ "Place", 3, {} };
  for (const Vector3 & node : mesh.nodes)
  {
    place.values.insert(place.values.end(), node.data(), node.data() + 3);
  }
  DrawnMesh result{ unstructured(mesh), mesh, "mesh.vtu" };
  result.arrays.ofNodes = { place,
                            { "Holes", 1, std::vector<double>(27, 1.0) },
                            { "Twice", 1, std::vector<double>(27, 5.0) } };
  result.arrays.ofCells = { { "Count", 1, { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, none } },
                            { "Twice", 1, std::vector<double>(8, -5.0) },
                            { "Strain", 6, {} },
                            { "Gradient", 9, {} },
                            { "Odd:1", 1, std::vector<double>(8, 7.0) },
                            { "Empty", 1, std::vector<double>(8, none) } };
  for (int cell = 0; cell < 8; ++cell)
  {
    for (const double value : { 1.0, 0.0, 2.0, 0.0, 3.0, 0.0 })
    {
      result.arrays.ofCells[2].values.push_back(value);
    }
    for (const double value : { 1.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 3.0, 2.0 })
    {
      result.arrays.ofCells[3].values.push_back(value);
    }
  }
  return result;
}

std::string
refusalOf(const std::string & name, const DrawnMesh & mesh = drawn())
{
  return analytic::messageOf<Error>([&] { (void)valuesOfArray(mesh, name); });
}

} // namespace

TEST(ArrayValues, OfCellsAreTheirOwn)
{
  const std::vector<double> values = valuesOfArray(drawn(), "Count");
  ASSERT_EQ(values.size(), 8U);
  EXPECT_EQ(values[5], 5.0);
  EXPECT_TRUE(std::isnan(values[7]));
}

TEST(ArrayValues, OfNodesAreTheMeanOfTheCorners)
{
  const DrawnMesh           mesh = drawn();
  const std::vector<double> x = valuesOfArray(mesh, "Place:0");
  const std::vector<double> norm = valuesOfArray(mesh, "Place");
  for (std::size_t cell = 0; cell < 8; ++cell)
  {
    Vector3 middle = Vector3::Zero();
    for (const Vector3 & corner : cellCorners(mesh.cells, cell))
    {
      middle += corner / 8.0;
    }
    EXPECT_NEAR(x[cell], middle[0], 1e-12);
    EXPECT_NEAR(norm[cell], middle.norm(), 1e-12);
  }
}

TEST(ArrayValues, CornersWithoutNumberAreLeftOutOfTheMean)
{
  DrawnMesh mesh = drawn();
  for (const std::size_t corner : mesh.cells.cells[0])
  {
    mesh.arrays.ofNodes[1].values[corner] = none;
  }
  mesh.arrays.ofNodes[1].values[mesh.cells.cells[7][6]] = 5.0;
  const std::vector<double> values = valuesOfArray(mesh, "Holes");
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_NEAR(values[1], 1.0, 1e-12);
  EXPECT_NEAR(values[7], (5.0 + 6.0) / 7.0, 1e-12); // the middle has none
}

TEST(ArrayValues, NormOfASymmetricTensorIsThatOfItsNineNumbers)
{
  EXPECT_NEAR(valuesOfArray(drawn(), "Strain")[3], std::sqrt(1.0 + 4.0 + 2.0 * 9.0), 1e-12);
  EXPECT_NEAR(valuesOfArray(drawn(), "Gradient")[3], valuesOfArray(drawn(), "Strain")[3], 1e-12);
  EXPECT_EQ(valuesOfArray(drawn(), "Strain:4")[3], 3.0);
}

TEST(ArrayValues, ArrayOfCellsComesBeforeOneOfNodesAndAWholeNameBeforeAComponent)
{
  EXPECT_EQ(valuesOfArray(drawn(), "Twice")[0], -5.0);
  EXPECT_EQ(valuesOfArray(drawn(), "Odd:1")[0], 7.0);
}

TEST(ArrayValues, WhatIsNotThereIsRefusedWithWhatIs)
{
  const std::string refusal = refusalOf("red");
  for (const char * part : { "--colour red", "Count", "Twice", "Strain", "Place", "scaled-jacobian" })
  {
    EXPECT_NE(refusal.find(part), std::string::npos) << part << ": " << refusal;
  }
  EXPECT_NE(refusalOf("strains").find("there are Strain, "), std::string::npos) << refusalOf("strains");
  EXPECT_NE(refusalOf("scaledjacobian").find("there are scaled-jacobian, "), std::string::npos);
  for (const char * name : { "", "count", "Count:", "Count:x", "Count:-1", "Count:99999999999", "red:0", ":" })
  {
    EXPECT_NE(refusalOf(name).find("no such measure or array"), std::string::npos) << name;
  }
  EXPECT_NE(refusalOf("Place:3").find("from 0 to 2"), std::string::npos);
  EXPECT_NE(refusalOf("Empty").find("has no number in any cell"), std::string::npos);
}

TEST(ArrayValues, RefusalOfManyLongNamesIsALineThatCountsTheRest)
{
  DrawnMesh mesh = drawn();
  for (int number = 0; number < 50; ++number)
  {
    mesh.arrays.ofCells.push_back({ "An\nArray" + std::to_string(number), 1, std::vector<double>(8, 0.0) });
  }
  const std::string refusal = refusalOf(std::string(300, 'x'), mesh);
  EXPECT_LE(refusal.size(), 183U);
  EXPECT_EQ(refusal.find('\n'), std::string::npos);
  EXPECT_NE(refusal.find(" more"), std::string::npos) << refusal;
}
