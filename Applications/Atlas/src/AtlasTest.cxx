#include "AtlasTest.h"

#include "SubjectFile.h"
#include "moserhex/HexMeshIO/FileErrors.h"

#include <algorithm>

namespace moserhex::app
{
namespace
{
using Column = std::vector<std::optional<double>>;

/** Subjects without a missing value. */
std::vector<std::size_t>
completeSubjects(const std::vector<Column> & columns)
{
  std::vector<std::size_t> complete;
  for (std::size_t subject = 0; subject < columns.front().size(); ++subject)
  {
    if (std::all_of(columns.begin(), columns.end(), [&](const Column & column) { return column[subject].has_value(); }))
    {
      complete.push_back(subject);
    }
  }
  return complete;
}

/** The first column is the effect. */
LinearDesign
designOf(const std::vector<Column> & columns, const std::vector<std::size_t> & subjects)
{
  const auto   rows = static_cast<Eigen::Index>(subjects.size());
  LinearDesign design{ Eigen::VectorXd(rows), Eigen::MatrixXd(rows, static_cast<Eigen::Index>(columns.size()) - 1) };
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    const std::size_t subject = subjects[static_cast<std::size_t>(row)];
    design.effect[row] = *columns.front()[subject];
    for (Eigen::Index column = 0; column < design.nuisance.cols(); ++column)
    {
      design.nuisance(row, column) = *columns[static_cast<std::size_t>(column) + 1][subject];
    }
  }
  return design;
}

/** \param effect  of the column that is tested */
AtlasTest
runTest(AtlasTest             test,
        const Column &        effect,
        const AtlasSubjects & subjects,
        const SubjectTable &  aligned,
        const AtlasOptions &  options)
{
  std::vector<Column> columns{ effect };
  for (const std::string & covariate : options.covariates)
  {
    if (covariate != test.column)
    {
      columns.push_back(numbersOfColumn(subjects, covariate));
      test.covariates.push_back(covariate);
    }
  }
  test.subjects = completeSubjects(columns);
  const LinearDesign design = designOf(columns, test.subjects);
  if (!test.groups.empty())
  {
    const auto second = static_cast<std::size_t>((design.effect.array() == 1.0).count());
    test.groupSizes = { test.subjects.size() - second, second };
  }
  PermutationOptions permutation;
  permutation.permutations = options.permutations;
  permutation.seed = options.seed;
  permutation.threads = options.threads;
  try
  {
    test.result = permutationTest(ChosenSubjects(aligned, test.subjects), design, permutation);
  }
  catch (const InvalidInput & error)
  {
    throw BadInput(error.code(), test.column, error.what(), "give more subjects or fewer covariates");
  }
  return test;
}

} // namespace

std::vector<AtlasTest>
runAtlasTests(const AtlasSubjects & subjects, const SubjectTable & aligned, const AtlasOptions & options)
{
  std::vector<AtlasTest> tests;
  if (!options.group.empty())
  {
    const GroupColumn column = groupsOfColumn(subjects, options.group);
    AtlasTest         test;
    test.name = "group";
    test.column = options.group;
    test.groups = column.names;
    tests.push_back(runTest(test, column.numbers, subjects, aligned, options));
  }
  if (!options.regressor.empty())
  {
    AtlasTest test;
    test.name = "regression";
    test.column = options.regressor;
    tests.push_back(runTest(test, numbersOfColumn(subjects, options.regressor), subjects, aligned, options));
  }
  return tests;
}

} // namespace moserhex::app
