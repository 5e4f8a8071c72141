#pragma once

#include "moserhex/HexMeshIO/RunReport.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <string>
#include <vector>

namespace moserhex::app
{

/** What makes it doubtful that a template was where it belongs before it was bent: the median distance of its surface
 * is more than a quarter of the radius of the ball of the label's volume; the inverse of its transform brings it much
 * nearer; it was scaled by less than 0.5 or more than 2.
 * \param volume  of the mesh [mm^3] \return one line each, with the option that changes it */
[[nodiscard]] std::vector<std::string>
templateWarnings(const TemplateFit & fit, const RunReport::Template & tied, double volume);

} // namespace moserhex::app
