#include "AtlasTest.h"

#include "SubjectFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{
constexpr double level = 0.05;

/** Subjects without a missing value, of whom the places' numbers are known. */
std::vector<std::size_t>
completeSubjects(const std::vector<NumberColumn> & columns, const TestedPlaces & places)
{
  std::vector<std::size_t> complete;
  for (std::size_t subject = 0; subject < columns.front().size(); ++subject)
  {
    const bool isKnown = places.isKnown.empty() || places.isKnown[subject];
    if (isKnown && std::all_of(columns.begin(), columns.end(), [&](const NumberColumn & column) {
          return column[subject].has_value();
        }))
    {
      complete.push_back(subject);
    }
  }
  return complete;
}

/** The first column is the effect, of groups their numbers. \param groups  how many; 0: a regression */
LinearDesign
designOf(const std::vector<NumberColumn> & columns, const std::vector<std::size_t> & subjects, std::size_t groups)
{
  const auto      rows = static_cast<Eigen::Index>(subjects.size());
  Eigen::MatrixXd values(rows, static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    for (Eigen::Index column = 0; column < values.cols(); ++column)
    {
      values(row, column) = *columns[static_cast<std::size_t>(column)][subjects[static_cast<std::size_t>(row)]];
    }
  }
  LinearDesign design{ values.leftCols(1), values.rightCols(values.cols() - 1) };
  if (groups > 0)
  {
    design.effect = groupColumns(std::vector<std::size_t>(values.col(0).data(), values.col(0).data() + rows), groups);
  }
  return design;
}

void
requireNoGroupEmpty(const AtlasTest & test)
{
  const auto empty = std::find(test.groupSizes.begin(), test.groupSizes.end(), std::size_t{ 0 });
  if (empty != test.groupSizes.end())
  {
    throw BadInput(ErrorCode::Precondition,
                   test.column,
                   "no subject of the group " + test.groups[static_cast<std::size_t>(empty - test.groupSizes.begin())] +
                     " has all the values",
                   "fill in the covariates or leave some out");
  }
}

/** \param test  its name, column and groups \param effect  of the column that is tested */
PlannedTest
planTest(AtlasTest             test,
         const NumberColumn &  effect,
         const AtlasSubjects & subjects,
         const AtlasOptions &  options,
         const TestedPlaces &  places)
{
  PlannedTest planned{ std::move(test), {}, {}, places.components };
  AtlasTest & plan = planned.test;
  plan.name += places.areCells ? "_image" : "";
  plan.areCells = places.areCells;
  std::vector<NumberColumn> columns{ effect };
  for (const std::string & covariate : options.covariates)
  {
    if (covariate != plan.column)
    {
      const auto more = covariatesOfColumn(subjects, covariate);
      columns.insert(columns.end(), more.begin(), more.end());
      planned.covariateOf.insert(planned.covariateOf.end(), more.size(), plan.covariates.size());
      plan.covariates.push_back(covariate);
    }
  }
  plan.subjects = completeSubjects(columns, places);
  plan.groupSizes.assign(plan.groups.size(), 0);
  if (!plan.groups.empty())
  {
    for (const std::size_t subject : plan.subjects)
    {
      ++plan.groupSizes[static_cast<std::size_t>(*effect[subject])];
    }
  }
  requireNoGroupEmpty(plan);
  planned.design = designOf(columns, plan.subjects, plan.groups.size());
  try
  {
    requireTestable(planned.design, places.components);
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), plan.column, error.what(), "give more subjects or fewer covariates");
  }
  return planned;
}

/** Covariates of which every column was left out. */
std::vector<std::string>
covariatesLeftOut(const PlannedTest & planned, const std::vector<std::size_t> & columnsLeftOut)
{
  std::vector<std::string> names;
  for (std::size_t covariate = 0; covariate < planned.test.covariates.size(); ++covariate)
  {
    const auto isOfIt = [&](std::size_t owner) { return owner == covariate; };
    const auto all = std::count_if(planned.covariateOf.begin(), planned.covariateOf.end(), isOfIt);
    const auto left = std::count_if(columnsLeftOut.begin(), columnsLeftOut.end(), [&](std::size_t column) {
      return isOfIt(planned.covariateOf[column]);
    });
    if (left == all)
    {
      names.push_back(planned.test.covariates[covariate]);
    }
  }
  return names;
}

} // namespace

Eigen::VectorXd
effectSizes(const AtlasTest & test)
{
  if (test.hasManyGroups())
  {
    return test.result.partialCorrelation.cwiseAbs2();
  }
  return test.groups.empty() ? test.result.partialCorrelation : test.result.standardisedDifference;
}

std::vector<PlaceChange>
changesOf(const AtlasTest & test)
{
  if (!test.hasManyGroups())
  {
    return { { test.groups.empty() ? "Slope" : "Difference", "", test.result.slope } };
  }
  std::vector<PlaceChange> changes;
  const auto               displacements = groupDisplacements(test.result.slope, test.groupSizes);
  for (std::size_t group = 0; group < test.groups.size(); ++group)
  {
    changes.push_back({ "Difference_" + test.groups[group], test.groups[group], displacements[group] });
  }
  return changes;
}

std::string
describe(const AtlasTest & test)
{
  const auto group = [&test](std::size_t number) {
    return test.groups[number] + " (" + std::to_string(test.groupSizes[number]) + ")";
  };
  const std::string images = test.areCells ? ", images" : "";
  if (test.groups.size() == 2)
  {
    return test.column + ", " + group(1) + " against " + group(0) + images;
  }
  std::string text = test.column;
  for (std::size_t number = 0; number < test.groups.size(); ++number)
  {
    text += ", " + group(number);
  }
  return text + images;
}

const char *
placesOf(const AtlasTest & test)
{
  return test.areCells ? "cells" : "nodes";
}

const char *
unitOf(const AtlasTest & test)
{
  if (test.groups.empty())
  {
    return test.areCells ? " (per unit)" : " (mm per unit)";
  }
  return test.areCells ? "" : " (mm)";
}

Eigen::Index
placesAtLevel(const Eigen::VectorXd & p)
{
  return (p.array() <= level).count();
}

std::vector<PlannedTest>
planAtlasTests(const AtlasSubjects & subjects, const AtlasOptions & options, const TestedPlaces & places)
{
  std::vector<PlannedTest> tests;
  if (!options.group.empty())
  {
    const GroupColumn column = groupsOfColumn(subjects, options.group);
    AtlasTest         test;
    test.name = "group";
    test.column = options.group;
    test.groups = column.names;
    tests.push_back(planTest(test, column.numbers, subjects, options, places));
  }
  if (!options.regressor.empty())
  {
    AtlasTest test;
    test.name = "regression";
    test.column = options.regressor;
    tests.push_back(planTest(test, numbersOfColumn(subjects, options.regressor), subjects, options, places));
  }
  return tests;
}

AtlasTest
runAtlasTest(const PlannedTest & planned, const SubjectTable & values, const AtlasOptions & options)
{
  AtlasTest          test = planned.test;
  PermutationOptions permutation;
  permutation.permutations = options.permutations;
  permutation.seed = options.seed;
  permutation.threads = options.threads;
  permutation.componentsPerPlace = planned.components;
  test.result = permutationTest(ChosenSubjects(values, test.subjects), planned.design, permutation);
  test.covariatesLeftOut = covariatesLeftOut(planned, test.result.nuisanceLeftOut);
  return test;
}

} // namespace moserhex::app
