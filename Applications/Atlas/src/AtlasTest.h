#pragma once

#include "AtlasOptions.h"
#include "AtlasSubjects.h"
#include "moserhex/ShapeStatistics/GroupDesign.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** Where a test is made, and of whom there are numbers. */
struct TestedPlaces
{
  bool              areCells{ false }; ///< of the cube, with the images' means over them; else nodes [mm]
  std::size_t       components{ 3 };   ///< numbers of a place, 1 to 3
  std::vector<bool> isKnown;           ///< of every subject; empty: all are
};

/** A test of a column at every node, or cell, and who took part. */
struct AtlasTest
{
  std::string              name; ///< "group" or "regression", of images "group_image" ...: also of the files
  bool                     areCells{ false }; ///< places are cells, numbers those of images; else nodes [mm]
  std::string              column;
  std::vector<std::string> covariates;
  std::vector<std::string> covariatesLeftOut; ///< of these, that are constant or explained by those before them
  std::vector<std::string> groups; ///< names, of two the first is what the second is compared with; none: a regression
  std::vector<std::size_t> groupSizes; ///< as many
  std::vector<std::size_t> subjects;   ///< that have all the values
  PermutationResult        result;

  [[nodiscard]] bool
  hasManyGroups() const
  {
    return groups.size() > 2;
  }
};

/** What the test is measured by at every place: Mahalanobis' D of two groups, the partial eta squared of more, the
 * partial correlation of a regression. */
[[nodiscard]] Eigen::VectorXd
effectSizes(const AtlasTest & test);

/** How the places' numbers change, of one group, one comparison or a regression. */
struct PlaceChange
{
  std::string     name;   ///< "Difference", "Difference_GROUP" or "Slope"
  std::string     group;  ///< of more than two, else empty
  Eigen::MatrixXd values; ///< components x places [mm, or as the images; of a regression per unit]
};

/** Of two groups second less first, of more each from the mean of all, of a regression the slope. */
[[nodiscard]] std::vector<PlaceChange>
changesOf(const AtlasTest & test);

/** "arm, treated (20) against control (20)", or all groups one after the other; of a regression the column. Of images
 * "..., images" behind it. */
[[nodiscard]] std::string
describe(const AtlasTest & test);

/** "nodes" or "cells". */
[[nodiscard]] const char *
placesOf(const AtlasTest & test);

/** " (mm)", " (mm per unit)", " (per unit)" or "". */
[[nodiscard]] const char *
unitOf(const AtlasTest & test);

/** Places whose p, or q, is at most 0.05. */
[[nodiscard]] Eigen::Index
placesAtLevel(const Eigen::VectorXd & p);

/** A test, of which all is known but the places' numbers. */
struct PlannedTest
{
  AtlasTest                test;            ///< without a result
  LinearDesign             design;          ///< of test.subjects
  std::vector<std::size_t> covariateOf;     ///< of each column of the nuisance
  std::size_t              components{ 3 }; ///< of a place
};

/** What the options ask for of the two: groups, then regression.
 * \throws BadInput  as groupsOfColumn and covariatesOfColumn; a group without subjects that have all the values; or the
 * design cannot be tested, as requireTestable says */
[[nodiscard]] std::vector<PlannedTest>
planAtlasTests(const AtlasSubjects & subjects, const AtlasOptions & options, const TestedPlaces & places = {});

/** \param values  a row a subject: the numbers of all places, such as the coordinates of the aligned nodes [mm] */
[[nodiscard]] AtlasTest
runAtlasTest(const PlannedTest & planned, const SubjectTable & values, const AtlasOptions & options);

} // namespace moserhex::app
