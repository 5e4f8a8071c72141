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

/** Points of two lists that are the same place: those of the same label, where every point of both lists has a label
 * of its own; else those of the same number, where both lists have as many. Points without a position have no part.
 * \throws BadInput  no two points correspond, or nothing tells which ones do; IOError */
[[nodiscard]] CorrespondingLandmarks
readLandmarks(const std::string & templateFile, const std::string & solidFile);

} // namespace moserhex::app
