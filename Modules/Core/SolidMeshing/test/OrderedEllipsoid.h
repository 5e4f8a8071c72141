#pragma once

#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <cmath>

namespace moserhex
{

/** phi and s of an ellipsoid: phi = first-order signed distance, s = squared relative size. */
struct OrderedSolid
{
  LevelSet phi;
  LevelSet ordering;
  double   volume{ 0.0 };
};

inline OrderedSolid
ellipsoid(const Vector3 & semiAxes, double spacing)
{
  OrderedSolid solid;
  RegularGrid  grid;
  grid.spacing = spacing;
  for (int a = 0; a < 3; ++a)
  {
    const int half = static_cast<int>(std::ceil(semiAxes[a] / spacing)) + 5;
    grid.size[a] = 2 * half + 1;
    grid.origin[a] = -half * spacing;
  }
  solid.phi.grid = solid.ordering.grid = grid;
  for (std::size_t node = 0; node < grid.nodeCount(); ++node)
  {
    const Vector3 p = grid.point(node);
    const double  s = p.cwiseQuotient(semiAxes).squaredNorm();
    const double  slope = p.cwiseQuotient(semiAxes.cwiseProduct(semiAxes)).norm();
    const double  size = std::sqrt(s);
    solid.ordering.values.push_back(s);
    solid.phi.values.push_back(slope > 0.0 ? size * (size - 1.0) / slope : -semiAxes.minCoeff());
  }
  solid.volume = 4.0 / 3.0 * pi * semiAxes.prod();
  return solid;
}

inline SolidMeshingOptions
withShells(int shells, unsigned int threads = 0)
{
  SolidMeshingOptions options;
  options.shells = shells;
  options.threads = threads;
  return options;
}

} // namespace moserhex
