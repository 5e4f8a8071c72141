#pragma once

#include "moserhex/Common/Types.h"
#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/StructuredGrid/CubeLattice.h"

namespace moserhex
{

/** How the nodes of a cube shell get to the sphere (stage F). */
enum class CubeShellMethod
{
  closedForm,    ///< Rosca and Plonka's equal-area map (cubeToSphere): exact in the continuum, the same for all shells
  conformalMoser ///< the paper's way: the shell's surface triangulated, conformal map, Moser area flow
};

/** Options of cubeShellMap. */
struct CubeShellMapOptions
{
  CubeShellMethod method{ CubeShellMethod::closedForm }; ///< for all shells

  /** conformalMoser only: each quadrilateral of the shell is cut into this many squares a side before it is
   * triangulated, so that small shells are resolved; 0: as many as make at least 24 squares along a cube edge. */
  int subdivisions{ 0 };
};

/** Directions on the unit sphere of the nodes of cube shell k, in the order of CubeLattice::nodesOfShell.
 *
 * Both ways keep areas and the directions of the faces, edges and corners; the closed form depends on neither the
 * subject nor the machine.
 * \throws InvalidInput  shell outside 1..N, or subdivisions < 0
 * \throws NotConverged  conformalMoser: see areaPreservingSphereMap */
[[nodiscard]] Positions
cubeShellMap(const CubeLattice & lattice, int shell, const CubeShellMapOptions & options = {});

/** Surface of [-1,1]^3 as a closed outward triangle mesh of squares x squares per face, each square cut along the
 * diagonal that runs from the face's centre outwards, so that the triangulation has the cube's 48 symmetries when
 * `squares` is even. Vertices in lattice order: first index fastest, inner points left out.
 * \throws InvalidInput  squares < 1 */
[[nodiscard]] TriangleMesh
cubeSurfaceMesh(int squares);

} // namespace moserhex
