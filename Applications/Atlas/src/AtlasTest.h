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

/** What the options ask for of the two: groups, then regression.
 * \param aligned  a row a subject: the coordinates of all nodes [mm]
 * \throws BadInput  as groupsOfColumn and numbersOfColumn; or the design cannot be tested, as permutationTest says */
[[nodiscard]] std::vector<AtlasTest>
runAtlasTests(const AtlasSubjects & subjects, const SubjectTable & aligned, const AtlasOptions & options);

} // namespace moserhex::app
