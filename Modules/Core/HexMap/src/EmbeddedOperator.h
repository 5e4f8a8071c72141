#pragma once

#include "LatticeVector.h"
#include "moserhex/Numerics/CubeTransform.h"

#include <vector>

namespace moserhex
{

/** An operator of a cube's lattice for fields on some of its points: R G R^T, G the operator, R the rows of the points.
 * Positive definite as G is. With G a function of the Laplacian this is what a mesh with padding has in its place: each
 * node or cell of the padding stands at a point of a larger lattice. */
class EmbeddedOperator
{
public:
  /** \param places  points of the lattice, one for each value of a field, none twice; empty: all, in their order */
  EmbeddedOperator(SpectralOperator lattice, std::vector<std::size_t> places);

  /** \param fields  a component in each column, columns any distance apart */
  void
  applyInPlace(Eigen::Ref<Eigen::MatrixXd> fields, unsigned int threads) const;

private:
  SpectralOperator         m_Lattice;
  std::vector<std::size_t> m_Places;
};

/** Points of the (n+2L)^3 lattice at which the nodes stand: those of layer l one step further out than those of the
 * layer before it along every axis at whose end they are. Empty without padding. */
[[nodiscard]] std::vector<std::size_t>
placesOfNodes(const LatticeLayout & layout);

/** Points of the (n-1+2L)^3 lattice at which the cells stand. Empty without padding. */
[[nodiscard]] std::vector<std::size_t>
placesOfCells(const LatticeLayout & layout);

/** (L + sigma)^-1 on the nodes, L the Laplacian of the lattice with free ends [1]. \param shift  sigma > 0 */
[[nodiscard]] EmbeddedOperator
inverseNodeLaplacian(const LatticeLayout & layout, double shift);

} // namespace moserhex
