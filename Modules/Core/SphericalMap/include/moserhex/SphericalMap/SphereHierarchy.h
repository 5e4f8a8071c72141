#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/TriangleMesh.h"

namespace moserhex
{

/** Options of sphereMapByHierarchy. */
struct SphereHierarchyOptions
{
  double coarsestContrast{ 2.0 }; ///< areas on the coarsest level lie within this factor of their mean [1]
  double shapeWeight{ 1e-2 };     ///< eps of the relaxation at each level [1]
  double relaxToRms{ 0.2 };       ///< area ratio rms at which a level is relaxed enough [1]
  int    stepsPerLevel{ 20 };     ///< Newton steps at most
};

/** What sphereMapByHierarchy made. */
struct SphereHierarchyResult
{
  Positions  positions; ///< no flipped triangle
  StepReport report;    ///< steps: vertices collapsed; residual: flipped triangles
};

/** A map to the sphere without flips from the connectivity alone; the geometry may be noise.
 *
 * Half-edge collapses that obey the link condition reduce the triangulation to a tetrahedron (for a sphere there is
 * always one), which is laid on the sphere as the regular one; in reverse, each vertex is put back inside the kernel of
 * its ring, which is never empty: it holds points near the vertex it was collapsed to, along the bisector of the fan
 * there. Each time the number of vertices has doubled the level is relaxed by a few steps of AreaBarrier, so that room
 * does not run out. About five times the cost of a conformal map.
 *
 * \throws InvalidInput  not a closed sphere, or no area
 * \throws NotConverged  room ran out in floating point (not met on any surface so far)
 * \throws Cancelled */
[[nodiscard]] SphereHierarchyResult
sphereMapByHierarchy(const TriangleMesh &           surface,
                     const SphereHierarchyOptions & options = {},
                     const ProgressCallback &       progress = {});

} // namespace moserhex
