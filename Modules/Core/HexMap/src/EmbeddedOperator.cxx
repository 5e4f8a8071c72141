#include "EmbeddedOperator.h"

#include "LatticeNodes.h"

#include <utility>

namespace moserhex
{
namespace
{

/** Number of a point whose index along each axis is counted from the lattice's, `layers` in from the end. */
std::size_t
placeOf(const std::array<int, 3> & at, int layers, int size)
{
  const auto s = static_cast<std::size_t>(size);
  return static_cast<std::size_t>(at[0] + layers) +
         s * (static_cast<std::size_t>(at[1] + layers) + s * static_cast<std::size_t>(at[2] + layers));
}

} // namespace

EmbeddedOperator::EmbeddedOperator(SpectralOperator lattice, std::vector<std::size_t> places)
  : m_Lattice(std::move(lattice)), m_Places(std::move(places))
{}

void
EmbeddedOperator::applyInPlace(Eigen::Ref<Eigen::MatrixXd> fields, unsigned int threads) const
{
  if (m_Places.empty())
  {
    m_Lattice.applyToColumnsInPlace(fields, threads);
    return;
  }
  Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(m_Lattice.symbol().size(), fields.cols());
  for (std::size_t p = 0; p < m_Places.size(); ++p)
  {
    whole.row(static_cast<Eigen::Index>(m_Places[p])) = fields.row(static_cast<Eigen::Index>(p));
  }
  m_Lattice.applyToColumnsInPlace(whole, threads);
  for (std::size_t p = 0; p < m_Places.size(); ++p)
  {
    fields.row(static_cast<Eigen::Index>(p)) = whole.row(static_cast<Eigen::Index>(m_Places[p]));
  }
}

std::vector<std::size_t>
placesOfNodes(const LatticeLayout & layout)
{
  std::vector<std::size_t> places;
  const int                n = layout.nodesPerSide;
  const int                layers = layout.paddingLayers;
  for (int layer = 0; layers > 0 && layer <= layers; ++layer)
  {
    lattice::forEachNode(n, [&](const lattice::Index3 & at, std::size_t) {
      lattice::Index3 place = at;
      for (int & index : place)
      {
        index += index == 0 ? -layer : index == n - 1 ? layer : 0;
      }
      if (layer == 0 || lattice::isBoundary(n, at))
      {
        places.push_back(placeOf(place, layers, n + 2 * layers));
      }
    });
  }
  return places;
}

std::vector<std::size_t>
placesOfCells(const LatticeLayout & layout)
{
  std::vector<std::size_t> places;
  const int                m = layout.nodesPerSide - 1;
  const int                layers = layout.paddingLayers;
  if (layers == 0)
  {
    return places;
  }
  lattice::forEachNode(
    m, [&](const lattice::Index3 & at, std::size_t) { places.push_back(placeOf(at, layers, m + 2 * layers)); });
  const HexMesh mesh = layout.connectivity();
  for (std::size_t cell = mesh.latticeCellCount(); cell < mesh.cellCount(); ++cell)
  {
    const PillowCell   pillow = pillowCell(mesh, cell);
    std::array<int, 3> place = pillow.quad;
    place[static_cast<std::size_t>(pillow.axis)] = pillow.last ? m - 1 + pillow.layer : -pillow.layer;
    places.push_back(placeOf(place, layers, m + 2 * layers));
  }
  return places;
}

EmbeddedOperator
inverseNodeLaplacian(const LatticeLayout & layout, double shift)
{
  return { functionOfLaplacian(layout.nodesPerSide + 2 * layout.paddingLayers,
                               CubeTransform::Basis::Cosine,
                               [shift](double eigenvalue) { return 1.0 / (eigenvalue + shift); }),
           placesOfNodes(layout) };
}

} // namespace moserhex
