#pragma once

#include "moserhex/Analytic/SolidShapes.h"

#include <functional>
#include <string>
#include <vector>

namespace moserhex::analytic
{

/** A map of space whose inverse is known. */
struct KnownDeformation
{
  std::string                               name;
  std::function<Vector3(const Vector3 & p)> forward; ///< [mm]
  std::function<Vector3(const Vector3 & p)> inverse; ///< [mm]
};

/** x + 0.25 z, y, z + 0.1 y. */
[[nodiscard]] KnownDeformation
shear();

/** The x axis becomes an arc about an axis along z, of radius 90 mm, through (0, 90, 0). For y < 90. */
[[nodiscard]] KnownDeformation
bend();

/** 4 mm outwards at (20, 9, 4), which decays as a Gaussian, to 1/e at 12 mm. */
[[nodiscard]] KnownDeformation
bulge();

/** All of the above. */
[[nodiscard]] std::vector<KnownDeformation>
knownDeformations();

/** About 52 x 40 x 32 mm, without any symmetry, so that its shape tells how it lies: an ellipsoid whose section changes
 * along it. In a box that holds it after each of these deformations, too. The volume is not known and is 0 here. */
[[nodiscard]] Solid
pearShapedSolid();

/** What becomes of a solid, in the same box, which has to hold it. The volume is not known and is 0. */
[[nodiscard]] Solid
deformed(const Solid & solid, const KnownDeformation & deformation);

} // namespace moserhex::analytic
