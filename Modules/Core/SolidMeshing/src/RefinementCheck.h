#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/LevelSet/LevelSet.h"
#include "moserhex/SolidMeshing/TemplateRefinement.h"

#include <string>
#include <vector>

namespace moserhex
{

/** Finds before the work what of a refinement does not belong to its organ. A landmark counts as outside of it when it
 * lies farther away than 5 mm and than two edges of a mean cell: those of a surface are never quite on the label's.
 *
 * \param templateMesh  in its own space \param phi  negative inside the solid \param volume  of the solid [mm^3]
 * \return warnings, one line each: which landmarks lie outside, and how far
 * \throws InvalidInput (TemplateLandmarks, Landmarks)  all of them lie outside; (TemplateImage, Image)  an image does
 * not cover its organ; as TemplateRefiner */
[[nodiscard]] std::vector<std::string>
checkRefinement(const HexMesh &            templateMesh,
                const TemplateRefinement & refinement,
                const LevelSet &           phi,
                double                     volume);

} // namespace moserhex
