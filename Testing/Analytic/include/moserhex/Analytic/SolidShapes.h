#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/LevelSet/LabelVolume.h"

#include <functional>
#include <string>
#include <vector>

namespace moserhex::analytic
{

/** A genus-0 solid given by a function that is negative inside, zero on the surface and positive outside.
 *
 * Every shape here has a closed-form volume, derived beside its definition. */
struct Solid
{
  std::string                            name;
  std::function<double(const Vector3 &)> signedFunction; ///< [mm]; a distance only where the maker says so
  BoundingBox                            box;            ///< encloses the solid [mm]
  double                                 volume{ 0.0 };  ///< exact [mm^3]
};

/** Ball about the origin; the function is the signed distance. */
[[nodiscard]] Solid
ball(double radius = 20.0);

/** Ellipsoid about the origin with the given semi-axes [mm]; default 3:1:1. */
[[nodiscard]] Solid
ellipsoid(const Vector3 & semiAxes = Vector3(30.0, 10.0, 10.0));

/** Ball whose radius is R (1 + amplitude Y(n)), Y the harmonic Re((x+iy)^5) z scaled to max |Y| = 1: ten lobes and
 * ten hollows. 0 <= amplitude < 0.5. */
[[nodiscard]] Solid
bumpyBall(double radius = 20.0, double amplitude = 0.2);

/** Bent, tapered ellipsoid: circular cross sections on an arc of 2.4 rad and radius `arcRadius` in the x-z plane. */
[[nodiscard]] Solid
banana(double arcRadius = 25.0, double thickness = 9.0, double taper = 0.4);

/** Two lobes of radius about 12 mm and a neck of radius 5 mm on the x axis, 60 mm long, a smooth solid of
 * revolution. */
[[nodiscard]] Solid
dumbbell();

/** Cube about the origin with sharp edges; the function is the signed distance. */
[[nodiscard]] Solid
cube(double side = 32.0);

/** All of the above with their defaults, for tests that go over every shape. */
[[nodiscard]] std::vector<Solid>
solids();

/** Placement of a voxel grid. */
struct GridPlacement
{
  Vector3 spacing{ 1.0, 1.0, 1.0 };         ///< [mm]
  Matrix3 direction{ Matrix3::Identity() }; ///< columns: image axes in LPS, orthonormal
  double  margin{ 3.0 };                    ///< least distance of the solid from the border of the grid [mm]
};

/** Voxels of a solid: inside where the function is negative at the voxel's centre. The grid is the smallest one with
 * the given placement that holds the solid's box and the margin. */
[[nodiscard]] LabelVolume
labelVolume(const Solid & solid, const GridPlacement & placement = {});

/** Number of inside voxels times the volume of a voxel [mm^3]. */
[[nodiscard]] double
volumeOfVoxels(const LabelVolume & label);

/** An oblique, right-handed direction matrix for tests in physical space. */
[[nodiscard]] Matrix3
obliqueDirection();

} // namespace moserhex::analytic
