#pragma once

#include "moserhex/CubeTransfer/CubeMap.h"

#include <functional>

namespace moserhex
{

/** A point of the cube and its image in a mesh. */
struct CubePoint
{
  Vector3 cube{ Vector3::Zero() };         ///< c in [0,1]^3 [1]
  Vector3 position{ Vector3::Zero() };     ///< x(c), LPS [mm]
  Matrix3 jacobian{ Matrix3::Identity() }; ///< dx/dc, of the place's own cell on common faces [mm]
};

/** One or several numbers at every place of the cube. \param values  to set, as many as there are components */
using CubeFunction = std::function<void(const CubePoint & point, double * values)>;

/** The point of a place, its position as CubeMap::position gives it. \param place  in a cell of the lattice */
[[nodiscard]] CubePoint
cubePoint(const HexMesh & mesh, const CubePlace & place);

} // namespace moserhex
