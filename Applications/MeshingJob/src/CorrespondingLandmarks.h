#pragma once

#include "PointFile.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <string>
#include <vector>

namespace moserhex::app
{

struct CorrespondingLandmarks
{
  std::vector<CorrespondingPoints> points;
  std::vector<std::string>         warnings; ///< one line each
};

/** Points of two lists that are the same place: those of the same label or, where no point of either list has a label,
 * those of the same row. Points without a position have no part.
 * \throws BadInput  only some points have labels, or two of a list the same; no two points correspond, or the lists
 * have no labels and are not as long; IOError */
[[nodiscard]] CorrespondingLandmarks
readLandmarks(const std::string & templateFile, const std::string & solidFile);

} // namespace moserhex::app
