#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMap/VolumeEqualisation.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** Makes the cells of a solid's lattice equal, and the lattice as like a reference as an exact one can be.
 *
 * The weights w_r and w_b of LatticeTies are tried from strong to weak until a mesh is exact. From that one, stronger
 * weights are tried again, each from the exact mesh before it, for as long as meshes are exact: a lattice that is on
 * the surface and untangled stays so more easily than it becomes so.
 *
 * The pull w_b works across the surface, too. Where half a cell's edge is less than the surface tolerance of the
 * options, meshes must come that near to count as exact; the tolerance of the options holds only when none did. The
 * measure is kept by reference. */
class ReferenceTie
{
public:
  /** \param reference  n^3 nodes where they are wanted [mm]
   * \param volume, measure  as for equaliseMeasures, the total being the volume
   * \param options    its ties are replaced */
  ReferenceTie(const Positions &           reference,
               double                      volume,
               const CellMeasure &         measure,
               const EqualisationOptions & options);

  /** From a mesh that need not lie on the surface. Not exact where no weights led to such a mesh: then the best. */
  [[nodiscard]] EqualisationResult
  tied(const HexMesh & start, const SignedDistance & phi, const ProgressCallback & progress);

  /** From one that is exact, weak weights first; nothing where not even these leave it exact. */
  [[nodiscard]] std::optional<EqualisationResult>
  drawn(const HexMesh & exact, const SignedDistance & phi, const ProgressCallback & progress);

  /** Of the boundary from the surface, that the last mesh returned had to keep to be exact [mm]. */
  [[nodiscard]] double
  surfaceTolerance() const
  {
    return m_Options.surfaceTolerance;
  }

  /** What came of all weights so far, in order. */
  [[nodiscard]] const std::vector<std::string> &
  attempts() const
  {
    return m_Attempts;
  }

private:
  [[nodiscard]] EqualisationResult
  tiedWithinTolerance(const HexMesh & start, const SignedDistance & phi, const ProgressCallback & progress);

  [[nodiscard]] std::optional<EqualisationResult>
  drawnWithinTolerance(const HexMesh & exact, const SignedDistance & phi, const ProgressCallback & progress);

  [[nodiscard]] EqualisationResult
  attempt(const HexMesh & start, const SignedDistance & phi, std::size_t weights, const ProgressCallback & progress);

  double                   m_Volume;
  const CellMeasure &      m_Measure;
  EqualisationOptions      m_Options;
  std::vector<double>      m_Tolerances; ///< of the boundary from the surface, one after the other [mm]
  std::vector<std::string> m_Attempts;
};

} // namespace moserhex
