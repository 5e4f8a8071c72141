#pragma once

#include "AtlasTest.h"
#include "MeanImage.h"
#include "ModelFile.h"
#include "SubjectMeshes.h"
#include "moserhex/ShapeStatistics/EqualVolumeShape.h"
#include "moserhex/ShapeStatistics/ModelQuality.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace moserhex::app
{

/** What the mesh of a mode is like. */
struct ModeMeshFigures
{
  std::string              file;                    ///< below the output folder
  double                   deviations{ 0.0 };       ///< shown, with the sign; 0: it is not written
  double                   volume{ 0.0 };           ///< [mm^3]
  double                   volumeVariance{ 0.0 };   ///< [1]
  double                   boundaryDistance{ 0.0 }; ///< EqualVolumeShape::boundaryDistance [mm]
  std::vector<std::string> attempts;                ///< with more deviations, and why not
};

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
  EqualVolumeShape            mean;
  ModelQuality                quality; ///< no entries with fewer than three subjects
  std::vector<AtlasTest>      tests;
  std::optional<MeanImage>    images;      ///< where the options ask for it
  std::vector<ModeMeshFigures> modeMeshes; ///< set by writeModeMeshes: up, down of each
  std::vector<std::string>     warnings;
};

/** Adds up images, aligns the subjects, fits the model, makes the mean mesh and runs the tests; writes nothing but a
 * file without a name in the output folder, which goes with the run. \param progress  is told the part done, in [0,1]
 * \throws UsageError, BadInput, IOError */
[[nodiscard]] AtlasResult
analyse(const AtlasOptions & options, const std::function<void(double)> & progress);

/** Scores of a table as coordinates of shapes: columns mode_1, mode_2, ... in standard deviations. */
[[nodiscard]] std::string
modeColumn(std::size_t mode);

} // namespace moserhex::app
