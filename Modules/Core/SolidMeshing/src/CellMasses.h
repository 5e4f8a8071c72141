#pragma once

#include "moserhex/HexMap/MassMeasure.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

namespace moserhex
{

/** Masses of cells under options.density, by the rule that a mesh of equal volumes needs. Keeps a reference to the
 * options. */
class CellMasses
{
public:
  CellMasses(const SolidMeshingOptions & options, const HexMesh & equalVolumes);

  [[nodiscard]] const MassMeasure &
  measure() const
  {
    return m_Measure;
  }

  /** Sets result.mass, of result.mesh; warns where the masses are not as accurate as was asked for. */
  void
  report(SolidMeshingResult & result) const;

private:
  const SolidMeshingOptions & m_Options;
  MassMeasure                 m_Measure;
};

} // namespace moserhex
