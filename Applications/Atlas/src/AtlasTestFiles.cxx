#include "AtlasTestFiles.h"

#include "TextTable.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <nlohmann/json.hpp>

#include <cctype>

namespace moserhex::app
{
namespace
{
using Cells = std::vector<std::string>;

/** "difference_GROUP": the name of a column, whose first letter is small. */
std::string
columnOf(const NodeChange & change)
{
  std::string name = change.name;
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return name;
}

struct Figure
{
  std::string     array;
  std::string     column; ///< empty: in the mesh only
  Eigen::VectorXd values;
};

std::vector<Figure>
figuresOf(const AtlasTest & test)
{
  const PermutationResult & result = test.result;
  std::vector<Figure>       figures{ test.hasManyGroups() ? Figure{ "PillaiTrace", "pillai_trace", result.pillaiTrace }
                                                          : Figure{ "T2", "t2", result.statistic },
                               { "P", "p", result.p },
                               { "PFamilyWise", "p_family_wise", result.pFamilyWise },
                               { "QFalseDiscovery", "q_false_discovery", result.qFalseDiscovery } };
  if (!test.groups.empty())
  {
    figures.push_back({ "EffectSize", "effect_size", effectSizes(test) });
  }
  if (!test.hasManyGroups())
  {
    figures.push_back(
      { "PartialCorrelation", test.groups.empty() ? "partial_correlation" : "", result.partialCorrelation });
  }
  return figures;
}

template <typename TMatrix>
NamedArray
arrayOf(const std::string & name, int components, const TMatrix & values)
{
  return { name, components, std::vector<double>(values.data(), values.data() + values.size()) };
}

void
writeTestMesh(const std::string & fileName, const AtlasTest & test, const HexMesh & mean)
{
  HexMeshFields fields;
  for (const NodeChange & change : changesOf(test))
  {
    fields.pointArrays.push_back(arrayOf(change.name, 3, change.moves));
  }
  for (const Figure & figure : figuresOf(test))
  {
    fields.pointArrays.push_back(arrayOf(figure.array, 1, figure.values));
  }
  writeHexMesh(fileName, mean, fields);
}

void
writeTestTable(const std::string & fileName, const AtlasTest & test, const HexMesh & mean)
{
  const std::vector<NodeChange> changes = changesOf(test);
  const std::vector<Figure>     figures = figuresOf(test);
  Cells                         header{ "node", "i", "j", "k", "x", "y", "z" };
  for (const NodeChange & change : changes)
  {
    for (const char * axis : { "_x", "_y", "_z" })
    {
      header.push_back(columnOf(change) + axis);
    }
  }
  for (const Figure & figure : figures)
  {
    if (!figure.column.empty())
    {
      header.push_back(figure.column);
    }
  }
  std::string text = tableLine(header, ',');
  const auto  indices = nodeIndices(mean);
  for (std::size_t node = 0; node < mean.nodes.size(); ++node)
  {
    const auto place = static_cast<Eigen::Index>(node);
    Cells      cells{ std::to_string(node) };
    const auto addVector = [&cells](const Vector3 & vector) {
      for (const double value : { vector[0], vector[1], vector[2] })
      {
        cells.push_back(numberText(value));
      }
    };
    for (const int index : indices[node].lattice)
    {
      cells.push_back(std::to_string(index));
    }
    addVector(mean.nodes[node]);
    for (const NodeChange & change : changes)
    {
      addVector(change.moves.col(place));
    }
    for (const Figure & figure : figures)
    {
      if (!figure.column.empty())
      {
        cells.push_back(numberText(figure.values[place]));
      }
    }
    text += tableLine(cells, ',');
  }
  writeTextFile(fileName, text);
}

} // namespace

void
writeAtlasTest(const std::string & folder, const AtlasTest & test, const HexMesh & mean)
{
  const std::string name = folder + "/" + test.name;
  writeTestMesh(name + ".vtu", test, mean);
  writeTestTable(name + ".csv", test, mean);
}

nlohmann::ordered_json
testJson(const AtlasTest & test)
{
  nlohmann::ordered_json json{ { "column", test.column },
                               { "covariates", test.covariates },
                               { "covariates_left_out", test.covariatesLeftOut },
                               { "subjects", test.subjects.size() },
                               { "statistic", test.hasManyGroups() ? "Pillai's trace" : "Hotelling's T^2" },
                               { "permutations", test.result.permutations },
                               { "all_orders", test.result.areAllOrders },
                               { "exact", test.result.isExact },
                               { "smallest_possible_p", test.result.smallestPossibleP },
                               { "degrees_of_freedom", test.result.degreesOfFreedom },
                               { "smallest_p", test.result.p.minCoeff() },
                               { "smallest_p_family_wise", test.result.pFamilyWise.minCoeff() },
                               { "nodes_p_family_wise_005", nodesAtLevel(test.result.pFamilyWise) },
                               { "nodes_q_false_discovery_005", nodesAtLevel(test.result.qFalseDiscovery) },
                               { "largest_effect_size", effectSizes(test).maxCoeff() } };
  if (!test.groups.empty())
  {
    json["groups"] = test.groups;
    json["group_sizes"] = test.groupSizes;
  }
  return json;
}

} // namespace moserhex::app
