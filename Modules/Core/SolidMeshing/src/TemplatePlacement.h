#pragma once

#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <optional>
#include <string>

namespace moserhex
{

/** A template where a solid lies. */
struct PlacedTemplate
{
  HexMesh                               mesh;      ///< of the solid's volume
  std::optional<SurfaceAlignmentResult> alignment; ///< absent: no alignment was asked for
  TemplateFit                           fit;
  std::string                           note; ///< what was done, for the report
};

/** Brings options.templateMesh to a solid: by options.templateNodes, or by alignToSurface as options.templateAlignment
 * says, or not at all; then scales it to the volume about its nodes' middle.
 *
 * It is aligned in the solid's size: in its own, a small one may do best all on one side of the surface. But where the
 * solid has grown in one place only, scaling moves the surface everywhere else. So a template whose volume is nearly
 * the solid's is also aligned in its own size, and that counts where it brings half of the surfaces much nearer.
 *
 * \param phi     negative inside the solid \param volume  of the solid, > 0 [mm^3]
 * \throws InvalidInput (Template)  the template's cells have no volume, or none of its nodes comes to lie in the solid
 * \throws InvalidInput  as alignToSurface */
[[nodiscard]] PlacedTemplate
placeTemplate(const SolidMeshingOptions & options, const LevelSet & phi, double volume);

} // namespace moserhex
