#pragma once

#include "AtlasRun.h"

#include <string>

namespace moserhex::app
{

/** What the meshes of modes are like. */
struct ModeMesh
{
  std::string file;             ///< below the output folder
  double      volume{ 0.0 };    ///< [mm^3]
  std::size_t uncertified{ 0 }; ///< cells that are not certified
};

/** Writes the files of an atlas into the output folder, each complete or not at all; Documentation/Atlas.md describes
 * them. \throws IOError */
void
writeAtlas(const AtlasResult & result, const AtlasOptions & options);

/** Writes scores.csv: a row a subject, name, file, figures, distance [mm], scores in standard deviations.
 * \param distances  of what is left without the modes that are kept, or to the mean */
void
writeScores(const std::string &                 fileName,
            const AtlasSubjects &               subjects,
            const std::vector<SubjectFigures> & figures,
            const std::string &                 distanceName,
            const std::vector<double> &         distances,
            const Eigen::MatrixXd &             scores);

} // namespace moserhex::app
