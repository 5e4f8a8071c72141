#include "AtlasCellFields.h"

#include "moserhex/CubeTransfer/FieldFunction.h"
#include "moserhex/Geometry/HexMeshNumbering.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace moserhex::app
{
namespace
{

/** Shown from the smallest value to the largest. */
CellField
fieldOf(const std::string & id, const std::string & name, std::vector<double> values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return { id, name, "", values, {}, { *least, *most } };
}

CellField
meanOverNodes(const std::string &                         id,
              const std::string &                         name,
              const HexMesh &                             mesh,
              const std::function<double(Eigen::Index)> & valueOfNode)
{
  std::vector<double> values;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    double sum = 0.0;
    for (const std::size_t node : mesh.cellNodes(cell))
    {
      sum += valueOfNode(static_cast<Eigen::Index>(node));
    }
    values.push_back(sum / 8.0);
  }
  CellField field = fieldOf(id, name, values);
  field.shown.low = std::min(0.0, field.shown.low);
  return field;
}

CellField
smallestOfNodes(const std::string &     id,
                const std::string &     name,
                const HexMesh &         mesh,
                const Eigen::VectorXd & valueOfNode)
{
  CellField field{ id, name, "", {}, {}, { 0.0, 1.0 } };
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    double least = 1.0;
    for (const std::size_t node : mesh.cellNodes(cell))
    {
      least = std::min(least, valueOfNode[static_cast<Eigen::Index>(node)]);
    }
    field.values.push_back(least);
  }
  return field;
}

CellField
inMiddleOfCells(const std::string & id, const std::string & name, const HexMesh & mesh, const FieldVolume & cube)
{
  const FieldFunction image(cube, ImageInterpolation::Linear);
  const Positions     places = cubeCoordinates(mesh);
  std::vector<double> components(static_cast<std::size_t>(cube.components));
  std::vector<double> values;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    Vector3 middle = Vector3::Zero();
    for (const std::size_t node : mesh.cellNodes(cell))
    {
      middle += places[node] / 8.0;
    }
    (void)image.evaluate(middle, components.data()); // the whole cube is in it
    values.push_back(components.front());
  }
  return fieldOf(id, name, values);
}

std::vector<double>
listOf(const Eigen::VectorXd & values)
{
  return { values.data(), values.data() + values.size() };
}

/** Of images: what the test says of the cells as it is. */
void
addCellTest(const AtlasTest & test, std::vector<CellField> & fields)
{
  std::size_t number = 0;
  for (const PlaceChange & change : changesOf(test))
  {
    const bool isSigned = change.values.rows() == 1;
    fields.push_back(fieldOf(test.name + "-change-" + std::to_string(number++),
                             test.column + ": change of the image" +
                               (change.group.empty() ? "" : " of " + change.group) + unitOf(test),
                             listOf(isSigned ? Eigen::VectorXd(change.values.row(0).transpose())
                                             : Eigen::VectorXd(change.values.colwise().norm().transpose()))));
  }
  fields.push_back(
    fieldOf(test.name + "-effect", test.column + ": effect size in the image", listOf(effectSizes(test))));
  fields.push_back({ test.name + "-p",
                     test.column + ": family-wise p in the image",
                     "",
                     listOf(test.result.pFamilyWise),
                     {},
                     { 0.0, 1.0 } });
}

void
addNodeTest(const AtlasTest & test, const HexMesh & mesh, std::vector<CellField> & fields)
{
  std::size_t number = 0;
  for (const PlaceChange & change : changesOf(test))
  {
    fields.push_back(
      meanOverNodes(test.name + "-change-" + std::to_string(number++),
                    test.column + ": change" + (change.group.empty() ? "" : " of " + change.group) + unitOf(test),
                    mesh,
                    [&change](Eigen::Index node) { return change.values.col(node).norm(); }));
  }
  const Eigen::VectorXd effects = effectSizes(test);
  fields.push_back(
    meanOverNodes(test.name + "-effect", test.column + ": effect size", mesh, [&effects](Eigen::Index node) {
      return effects[node];
    }));
  fields.push_back(smallestOfNodes(test.name + "-p", test.column + ": family-wise p", mesh, test.result.pFamilyWise));
}

} // namespace

std::vector<CellField>
atlasCellFields(const AtlasResult & result)
{
  const HexMesh &        mesh = result.mean.mesh;
  std::vector<CellField> fields = cellFieldsOf(mesh, {});
  fields.push_back(meanOverNodes("deviation", "Standard deviation (mm)", mesh, [&result](Eigen::Index node) {
    return std::sqrt(result.covariances[static_cast<std::size_t>(node)].trace());
  }));
  if (result.images)
  {
    fields.push_back(inMiddleOfCells("image-mean", "Mean image", mesh, result.images->mean));
    fields.push_back(inMiddleOfCells("image-deviation", "Image: standard deviation", mesh, result.images->deviation));
  }
  for (const AtlasTest & test : result.tests)
  {
    if (test.areCells)
    {
      addCellTest(test, fields);
    }
    else
    {
      addNodeTest(test, mesh, fields);
    }
  }
  return fields;
}

} // namespace moserhex::app
