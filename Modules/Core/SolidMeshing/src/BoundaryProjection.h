#pragma once

#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/HexMap/SurfaceProjection.h"
#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

namespace moserhex
{

/** Newton steps that put a point near a level set onto it. */
constexpr int projectionIterations = 4;

/** The longest of those steps [mm]. */
[[nodiscard]] double
longestNewtonStep(const RegularGrid & grid);

/** Onto {phi = level}. Within half a grid edge of the surface phi is a distance and Newton along its gradient finds the
 * nearest point; farther out the nearest point of the triangles comes first.
 * \param search  of triangles on about the same surface; kept by reference, as is phi */
[[nodiscard]] SurfaceProjection
projectionOnto(const ClosestPointSearch & search, const CubicInterpolator & phi, double level);

/** The nearest point of {phi = level}: Newton from the point itself and from the nearest point of the triangles; the
 * nearer result. Near a crease either may miss the nearest point. */
[[nodiscard]] SurfaceProjection
nearestPointOn(const ClosestPointSearch & search, const CubicInterpolator & phi, double level);

/** Of the mesh's boundary to its projection. */
[[nodiscard]] BoundaryDistance
boundaryDistance(const HexMesh & mesh, const SurfaceProjection & projection);

} // namespace moserhex
