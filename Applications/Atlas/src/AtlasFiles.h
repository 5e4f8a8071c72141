#pragma once

#include "AtlasRun.h"

#include <string>

namespace moserhex::app
{

/** Writes the files of an atlas into the output folder, each complete or not at all; Documentation/Atlas.md describes
 * them. The meshes of modes are there already (writeModeMeshes). Warns in result.warnings of a template that cannot be
 * made. \throws IOError */
void
writeAtlas(AtlasResult & result, const AtlasOptions & options);

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
