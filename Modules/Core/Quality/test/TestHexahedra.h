#pragma once

#include "moserhex/Geometry/HexMesh.h"

namespace moserhex
{

inline HexCorners
unitCube()
{
  return { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0),
           Vector3(0, 0, 1), Vector3(1, 0, 1), Vector3(1, 1, 1), Vector3(0, 1, 1) };
}

} // namespace moserhex
