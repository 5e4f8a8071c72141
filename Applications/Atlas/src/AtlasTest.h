#pragma once

#include "AtlasOptions.h"
#include "AtlasSubjects.h"
#include "moserhex/ShapeStatistics/GroupDesign.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** A test of a column at every node, and who took part. */
struct AtlasTest
{
  std::string              name; ///< "group" or "regression": also of the files
  std::string              column;
  std::vector<std::string> covariates;
  std::vector<std::string> covariatesLeftOut; ///< of these, that are constant or explained by those before them
  std::vector<std::string> groups; ///< names, of two the first is what the second is compared with; none: a regression
  std::vector<std::size_t> groupSizes; ///< as many
  std::vector<std::size_t> subjects;   ///< that have all the values
  PermutationResult        result;     ///< a place is a node

  [[nodiscard]] bool
  hasManyGroups() const
  {
    return groups.size() > 2;
  }
};

/** What the test is measured by at every node: Mahalanobis' D of two groups, the partial eta squared of more, the
 * partial correlation of a regression. */
[[nodiscard]] Eigen::VectorXd
effectSizes(const AtlasTest & test);

/** How nodes moved, of one group, one comparison or a regression. */
struct NodeChange
{
  std::string     name;  ///< "Difference", "Difference_GROUP" or "Slope"
  std::string     group; ///< of more than two, else empty
  Eigen::MatrixXd moves; ///< 3 x nodes [mm, of a regression mm per unit]
};

/** Of two groups second less first, of more each from the mean of all, of a regression the slope. */
[[nodiscard]] std::vector<NodeChange>
changesOf(const AtlasTest & test);

/** "arm, treated (20) against control (20)", or all groups one after the other; of a regression the column. */
[[nodiscard]] std::string
describe(const AtlasTest & test);

/** Nodes whose p, or q, is at most 0.05. */
[[nodiscard]] Eigen::Index
nodesAtLevel(const Eigen::VectorXd & p);

/** A test, of which all is known but the nodes. */
struct PlannedTest
{
  AtlasTest                test;        ///< without a result
  LinearDesign             design;      ///< of test.subjects
  std::vector<std::size_t> covariateOf; ///< of each column of the nuisance
};

/** What the options ask for of the two: groups, then regression.
 * \throws BadInput  as groupsOfColumn and covariatesOfColumn; a group without subjects that have all the values; or the
 * design cannot be tested, as requireTestable says */
[[nodiscard]] std::vector<PlannedTest>
planAtlasTests(const AtlasSubjects & subjects, const AtlasOptions & options);

/** \param aligned  a row a subject: the coordinates of all nodes [mm] */
[[nodiscard]] AtlasTest
runAtlasTest(const PlannedTest & planned, const SubjectTable & aligned, const AtlasOptions & options);

} // namespace moserhex::app
