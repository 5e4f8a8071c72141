#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/ClosestPoint.h"
#include "moserhex/Geometry/SurfaceRemeshing.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/Geometry/TriangleTopology.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <cstddef>
#include <string>
#include <vector>

namespace moserhex
{

/** Options of extractShellSurfaces and summarizeShells. */
struct ShellSurfaceOptions
{
  double       trianglesPerQuad{ 4.0 };     ///< triangles of a shell per quadrilateral of its cube shell [1]
  double       fewestTriangles{ 1200.0 };   ///< of a shell, however small its cube shell [1]
  double       volumeTolerance{ 1e-5 };     ///< |volume / target - 1| of each shell [1]
  double       acceptedVolumeError{ 1e-3 }; ///< above this a shell is refused [1]
  int          maximumVolumeShifts{ 8 };    ///< [1]
  int          sizingRounds{ 6 };           ///< of the remesher [1]
  int          smoothingRounds{ 4 };        ///< of the remesher [1]
  bool         checkIntersections{ true };  ///< count self-intersections and test nesting
  double       smallestRelativeGap{ 0.2 };  ///< below this part of the mean gap of all pairs a warning is given [1]
  unsigned int threads{ 0 };                ///< 0: all; results do not depend on it
};

/** One shell. Gaps are measured between it and the next smaller shell, from the vertices of each to the other surface;
 * they are zero for the innermost shell. */
struct ShellSurface
{
  TriangleMesh          mesh;                   ///< closed, outward, genus 0 [mm, LPS]
  double                targetVolume{ 0.0 };    ///< [mm^3]
  double                volume{ 0.0 };          ///< enclosed by the mesh [mm^3]
  double                level{ 0.0 };           ///< of the function it was cut from
  SurfaceQualitySummary quality;                ///< of the mesh's triangles
  DistanceSummary       gap;                    ///< [mm]
  std::size_t           selfIntersections{ 0 }; ///< pairs of triangles; 0 when not checked
  bool                  nested{ true };         ///< it holds the next smaller shell; true when not checked
  StepReport            remeshing;              ///< steps: volume shifts; residual: volume error [1]
};

/** Cuts the shells out of an ordering, in parallel over the shells.
 *
 * Shell k is the level set of `ordering` that encloses volumeFractions[k-1] of `volume`; the outermost shell is the
 * level set of phi that encloses `volume`. Each: level by volume, marching tetrahedra (on a finer local grid when the
 * shell is small), remeshing with every vertex moved onto the level set by Newton steps, then shifts of the level,
 *
 *   delta level = (V - V_mesh) / integral dA / |grad s|
 *
 * until the mesh itself encloses V.
 *
 * \param ordering         s of shellOrdering, same grid as phi                [1]
 * \param phi              negative inside                                     [mm]
 * \param volume           of the organ, > 0                                   [mm^3]
 * \param volumeFractions  strictly increasing, in (0, 1], last 1              N
 * \return N shells, entry k-1 is shell k
 * \throws InvalidInput  grids differ, volume or fractions or options out of range
 * \throws NotConverged  a shell is not a sphere or misses its volume by more than acceptedVolumeError; names the shell
 * \throws Cancelled     by the callback
 * \note Deterministic for any thread count. */
[[nodiscard]] std::vector<ShellSurface>
extractShellSurfaces(const LevelSet &            ordering,
                     const LevelSet &            phi,
                     double                      volume,
                     const std::vector<double> & volumeFractions,
                     const ShellSurfaceOptions & options = {},
                     const ProgressCallback &    progress = {});

/** The same for the volume fractions of the cube (cubeVolumeFractions). */
[[nodiscard]] std::vector<ShellSurface>
extractShellSurfaces(const LevelSet &            ordering,
                     const LevelSet &            phi,
                     double                      volume,
                     int                         shells,
                     const ShellSurfaceOptions & options = {},
                     const ProgressCallback &    progress = {});

/** The worst numbers of a set of shells. */
struct ShellSurfacesSummary
{
  std::size_t triangles{ 0 };          ///< of all shells together
  double      worstVolumeError{ 0.0 }; ///< largest |volume / target - 1| [1]
  double      minimumAngle{ 0.0 };     ///< [degree]
  std::size_t negativeCotangents{ 0 }; ///< of all shells together, see SurfaceQualitySummary
  std::size_t selfIntersections{ 0 };  ///< pairs of triangles of one shell, of all shells together; 0 when not checked
  std::size_t notNested{ 0 };          ///< pairs of neighbouring shells
  double      smallestGap{ 0.0 };      ///< of all pairs [mm]
  double      meanGap{ 0.0 };          ///< mean of the mean gaps of all pairs [mm]
  double      largestGap{ 0.0 };       ///< [mm]
  std::vector<std::string> warnings;   ///< what is allowed but worth a line: thin gaps, intersections, negative weights

  /** Smallest gap over the mean gap; 0 for a single shell [1]. */
  [[nodiscard]] double
  smallestRelativeGap() const
  {
    return meanGap > 0.0 ? smallestGap / meanGap : 0.0;
  }
};

/** \param options  as in extractShellSurfaces: says which gaps are worth a warning */
[[nodiscard]] ShellSurfacesSummary
summarizeShells(const std::vector<ShellSurface> & shells, const ShellSurfaceOptions & options = {});

} // namespace moserhex
