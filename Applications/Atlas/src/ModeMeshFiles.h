#pragma once

#include "AtlasRun.h"

#include <functional>

namespace moserhex::app
{

/** Makes the meshes of the first modes, at three standard deviations up and down or, where that is no possible shape,
 * at fewer (exactModeMesh), and writes those that are exact: mode-01-plus3.vtu, mode-01-minus3.vtu, ... Sets
 * result.modeMeshes, and warns in result.warnings of those that show less or are not written.
 * \param progress  is told the part done, in [0,1] \throws IOError */
void
writeModeMeshes(AtlasResult & result, const AtlasOptions & options, const std::function<void(double)> & progress);

} // namespace moserhex::app
