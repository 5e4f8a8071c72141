#include "AtlasTestFiles.h"

#include "TextTable.h"
#include "moserhex/Geometry/HexMeshNumbering.h"
#include "moserhex/HexMeshIO/AtomicFile.h"
#include "moserhex/HexMeshIO/HexMeshWriter.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cctype>

namespace moserhex::app
{
namespace
{
using Cells = std::vector<std::string>;

/** "difference_GROUP": the name of a column, whose first letter is small. */
std::string
columnOf(const PlaceChange & change)
{
  std::string name = change.name;
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return name;
}

/** Of an array in a file of VTK, which reads a name as XML. */
std::string
arrayNameOf(const PlaceChange & change, std::size_t number)
{
  std::string name = change.name;
  const auto  isMarkup = [](char c) { return std::string("&<>\"'").find(c) != std::string::npos; };
  if (std::any_of(name.begin(), name.end(), isMarkup))
  {
    std::replace_if(name.begin(), name.end(), isMarkup, '_');
    name += "_" + std::to_string(number + 1); // two groups may differ in these alone
  }
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

/** Behind the name of a column of so many components; those of images have no axes. */
std::vector<std::string>
endingsOf(const AtlasTest & test, Eigen::Index components)
{
  if (!test.areCells)
  {
    return { "_x", "_y", "_z" };
  }
  if (components == 1)
  {
    return { "" };
  }
  std::vector<std::string> endings;
  for (Eigen::Index component = 1; component <= components; ++component)
  {
    endings.push_back("_" + std::to_string(component));
  }
  return endings;
}

void
writeTestMesh(const std::string & fileName, const AtlasTest & test, const HexMesh & mean)
{
  HexMeshFields             fields;
  std::vector<NamedArray> & arrays = test.areCells ? fields.cellArrays : fields.pointArrays;
  std::size_t               number = 0;
  for (const PlaceChange & change : changesOf(test))
  {
    const std::string name = arrayNameOf(change, number++);
    if (!test.areCells)
    {
      arrays.push_back(arrayOf(name, 3, change.values));
      continue;
    }
    const std::vector<std::string> endings = endingsOf(test, change.values.rows());
    for (std::size_t component = 0; component < endings.size(); ++component)
    {
      const Eigen::VectorXd values = change.values.row(static_cast<Eigen::Index>(component)).transpose();
      arrays.push_back(arrayOf(name + endings[component], 1, values));
    }
  }
  for (const Figure & figure : figuresOf(test))
  {
    arrays.push_back(arrayOf(figure.array, 1, figure.values));
  }
  writeHexMesh(fileName, mean, fields);
}

/** Where a place of a test is. */
struct PlaceOfTest
{
  std::array<int, 3> lattice;  ///< i, j, k
  Vector3            position; ///< [mm]
};

std::vector<PlaceOfTest>
nodesOf(const HexMesh & mesh)
{
  const auto               indices = nodeIndices(mesh);
  std::vector<PlaceOfTest> places;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
  {
    places.push_back({ indices[node].lattice, mesh.nodes[node] });
  }
  return places;
}

/** \pre no padding */
std::vector<PlaceOfTest>
cellsOf(const HexMesh & mesh)
{
  std::vector<PlaceOfTest> places;
  const std::size_t        side = static_cast<std::size_t>(mesh.nodesPerSide) - 1;
  for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
  {
    PlaceOfTest place{
      { static_cast<int>(cell % side), static_cast<int>(cell / side % side), static_cast<int>(cell / (side * side)) },
      Vector3::Zero()
    };
    for (const std::size_t node : mesh.cellNodes(cell))
    {
      place.position += mesh.nodes[node] / 8.0;
    }
    places.push_back(place);
  }
  return places;
}

void
writeTestTable(const std::string & fileName, const AtlasTest & test, const HexMesh & mean)
{
  const std::vector<PlaceChange> changes = changesOf(test);
  const std::vector<Figure>      figures = figuresOf(test);
  const std::vector<PlaceOfTest> places = test.areCells ? cellsOf(mean) : nodesOf(mean);
  Cells                          header{ test.areCells ? "cell" : "node", "i", "j", "k", "x", "y", "z" };
  for (const PlaceChange & change : changes)
  {
    for (const std::string & ending : endingsOf(test, change.values.rows()))
    {
      header.push_back(columnOf(change) + ending);
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
  for (std::size_t number = 0; number < places.size(); ++number)
  {
    const auto place = static_cast<Eigen::Index>(number);
    Cells      cells{ std::to_string(number) };
    const auto addNumbers = [&cells](const Eigen::VectorXd & values) {
      for (Eigen::Index i = 0; i < values.size(); ++i)
      {
        cells.push_back(numberText(values[i]));
      }
    };
    for (const int index : places[number].lattice)
    {
      cells.push_back(std::to_string(index));
    }
    addNumbers(places[number].position);
    for (const PlaceChange & change : changes)
    {
      addNumbers(change.values.col(place));
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
  const std::string      places = placesOf(test);
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
                               { places + "_p_family_wise_005", placesAtLevel(test.result.pFamilyWise) },
                               { places + "_q_false_discovery_005", placesAtLevel(test.result.qFalseDiscovery) },
                               { "largest_effect_size", effectSizes(test).cwiseAbs().maxCoeff() } };
  if (!test.groups.empty())
  {
    json["groups"] = test.groups;
    json["group_sizes"] = test.groupSizes;
  }
  return json;
}

} // namespace moserhex::app
