#pragma once

#include "LatticeVector.h"
#include "moserhex/HexMap/LatticeTies.h"

namespace moserhex
{

/** The terms of LatticeTies for one lattice, in units of a cell's edge. */
class TieEnergy
{
public:
  /** No term. */
  TieEnergy() = default;

  /** \param origin, unit  of lattice vectors: x = (p - origin) / unit [mm] */
  TieEnergy(const LatticeLayout & layout, LatticeTies ties, const Vector3 & origin, double unit);

  /** \param gradient  dE/dx is added \return E; the same bits for any number of threads */
  [[nodiscard]] double
  add(const LatticeLayout & layout, const Eigen::VectorXd & x, unsigned int threads, Eigen::VectorXd & gradient) const;

  /** LatticeTies::rest in units; empty: none. */
  [[nodiscard]] const Eigen::VectorXd &
  rest() const
  {
    return m_Rest;
  }

private:
  LatticeTies     m_Ties; ///< landmarks and image in units; the reference's positions are in m_Reference
  Eigen::VectorXd m_Reference;
  Eigen::VectorXd m_Rest;
};

} // namespace moserhex
