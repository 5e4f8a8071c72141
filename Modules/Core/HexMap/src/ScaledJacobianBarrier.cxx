#include "ScaledJacobianBarrier.h"

#include <Eigen/Geometry>

#include <array>

namespace moserhex
{

double
addScaledJacobianBarrier(const LatticeLayout &            layout,
                         const Eigen::VectorXd &          x,
                         const std::vector<std::size_t> & cells,
                         double                           goal,
                         double                           weight,
                         Eigen::VectorXd &                gradient)
{
  double energy = 0.0;
  for (const std::size_t cell : cells)
  {
    const CellNodes nodes = layout.cellNodes(cell);
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const std::size_t      node = nodes[corner];
      std::array<Vector3, 3> edges; // away from the corner; two of them pointing against the lattice is no mirror
      std::array<double, 3>  lengths;
      double                 sign = 1.0;
      for (std::size_t d = 0; d < 3; ++d)
      {
        const std::size_t bit = std::size_t{ 1 } << d;
        edges[d] = layout.at(x, nodes[corner ^ bit]) - layout.at(x, node);
        lengths[d] = edges[d].norm();
        sign = (corner & bit) != 0 ? -sign : sign;
      }
      const double product = lengths[0] * lengths[1] * lengths[2];
      if (!(product > 0.0))
      {
        continue;
      }
      const double scaledJacobian = sign * edges[0].dot(edges[1].cross(edges[2])) / product;
      const double shortfall = 1.0 - scaledJacobian / goal;
      if (!(shortfall > 0.0))
      {
        continue;
      }
      energy += 0.5 * weight * shortfall * shortfall;
      for (std::size_t d = 0; d < 3; ++d)
      {
        const Vector3 slope = sign / product * edges[(d + 1) % 3].cross(edges[(d + 2) % 3]) -
                              scaledJacobian / (lengths[d] * lengths[d]) * edges[d];
        const Vector3 pull = -weight * shortfall / goal * slope;
        layout.add(gradient, nodes[corner ^ (std::size_t{ 1 } << d)], pull);
        layout.add(gradient, node, -pull);
      }
    }
  }
  return energy;
}

} // namespace moserhex
