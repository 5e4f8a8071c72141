#pragma once

#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/LevelSet/MarchingTetrahedra.h"
#include "moserhex/LevelSet/ShellSurfaces.h"

#include <string>

namespace moserhex
{

/** A function whose level sets are shells, ready for many cuts from many threads. */
struct ShellFunction
{
  explicit ShellFunction(const LevelSet & f) : levelSet(f), interpolator(f), volumes(f)
  {}

  const LevelSet &  levelSet;
  CubicInterpolator interpolator;
  VolumeBelowLevel  volumes;
};

/** Cuts the shell that encloses `volume` with the triangles asked for. Where it ends in a neck or a thin spur these may
 * be too large to follow it, and its volume cannot be met: then with four times as many, twice at most.
 * \throws NotConverged  the last attempt is not a sphere or misses the volume; the message begins with `name` */
[[nodiscard]] ShellSurface
cutShell(const ShellFunction &       f,
         double                      volume,
         double                      triangles,
         const std::string &         name,
         const ShellSurfaceOptions & options);

} // namespace moserhex
