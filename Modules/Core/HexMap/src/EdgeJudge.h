#pragma once

#include "moserhex/HexMap/FramePlacement.h"
#include "moserhex/SphericalMap/SphereLocator.h"

#include <array>
#include <vector>

namespace moserhex
{

/** Places the lattice's edge nodes on the surface and scores them; see edgeScore. */
class EdgeJudge
{
public:
  /** \param surface  must outlive the judge */
  EdgeJudge(const TriangleMesh & surface, const Positions & sphereMap, const FramePlacementOptions & options);

  /** May be called from many threads. The searches start from the triangles of the identity, whoever asks. */
  [[nodiscard]] EdgeScore
  judge(const FramePlacement & placement) const;

  /** Four nodes of a cell's corner on an edge of the cube: the corner itself and its neighbours, right-handed. */
  using CellCorner = std::array<std::size_t, 4>;

private:
  [[nodiscard]] Vector3
  pointOn(const SphereLocator::Hit & hit) const;

  const TriangleMesh &    m_Surface;
  Positions               m_Normals;
  SphereLocator           m_Locator;
  Positions               m_Directions; ///< of the edge nodes, on the sphere in the lattice's frame
  std::vector<CellCorner> m_Corners;    ///< entries of m_Directions
  double                  m_Sharpness;
  std::vector<int>        m_Start;
};

} // namespace moserhex
