#pragma once

#include "AtlasTest.h"
#include "ModelFile.h"
#include "SubjectMeshes.h"
#include "moserhex/ShapeStatistics/MeanMesh.h"
#include "moserhex/ShapeStatistics/ModelQuality.h"

#include <functional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** All that comes out of an analysis. */
struct AtlasResult
{
  AtlasSubjects               subjects;
  std::vector<SubjectFigures> figures;   ///< of every subject, as it is
  std::vector<double>         distances; ///< of every aligned subject to the mean, root mean square over the nodes [mm]
  ProcrustesResult            alignment;
  AtlasModel                  model;
  Eigen::MatrixXd             scores;      ///< N x K, in standard deviations of the modes [1]
  std::vector<Matrix3>        covariances; ///< of every node [mm^2]
  MeanMeshResult              mean;
  ModelQuality                quality; ///< no entries with fewer than three subjects
  std::vector<AtlasTest>      tests;
  std::vector<std::string>    warnings;
};

/** Aligns the subjects, fits the model, makes the mean mesh and runs the tests; writes nothing but a file without a
 * name in the output folder, which goes with the run.
 * \param progress  is told the part done, in [0,1]
 * \throws UsageError, BadInput, IOError */
[[nodiscard]] AtlasResult
analyse(const AtlasOptions & options, const std::function<void(double)> & progress);

/** Scores of a table as coordinates of shapes: columns mode_1, mode_2, ... in standard deviations. */
[[nodiscard]] std::string
modeColumn(std::size_t mode);

} // namespace moserhex::app
