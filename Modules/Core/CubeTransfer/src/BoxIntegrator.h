#pragma once

#include "CubeParts.h"
#include "moserhex/CubeTransfer/CubePoint.h"
#include "moserhex/Numerics/GaussLegendre.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** Integrals of a function over the images of N^3 equal boxes of the cube, each cut along the faces of the lattice's
 * cells. Keeps references: mesh and function must outlive it. Thread-safe where the function is. */
class BoxIntegrator
{
public:
  BoxIntegrator(const HexMesh & mesh, const CubeFunction & f, int components, int boxesPerAxis);

  /** Adds the integral over a box to `sums`, as many as there are components.
   * \return the volume of the box [mm^3] \throws InvalidInput  it is not positive */
  double
  addIntegral(std::size_t box, const GaussRule & rule, double * sums) const;

  /** Points at which a rule evaluates the function in a box. */
  [[nodiscard]] double
  pointCount(std::size_t box, int pointsPerAxis) const;

private:
  const HexMesh &                    m_Mesh;
  const CubeFunction &               m_Function;
  std::size_t                        m_Components;
  std::vector<std::vector<CellPart>> m_Parts;
};

} // namespace moserhex
