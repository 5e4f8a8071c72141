#pragma once

#include "moserhex/LevelSet/CubicInterpolation.h"
#include "moserhex/SolidMeshing/SolidMeshing.h"

#include <functional>

namespace moserhex
{

/** What stage J works with besides the mesh it starts from. All is kept by reference. */
struct ExactStage
{
  const CubicInterpolator &   phi;
  double                      volume; ///< of the label [mm^3]
  const SolidMeshingOptions & options;
  const TriangleMesh &        surface;   ///< outermost shell
  const Positions &           sphereMap; ///< of it
  /** The start with the cube turned; empty: only the frame there is. */
  std::function<HexMesh(const Matrix3 & turn)> turnedStart;
};

/** Stage J: equal volumes; where the own frame does not lead to an exact mesh, of a smoother solid, then in turned
 * frames, then of a rounder solid; then equal masses where a density is given. Replaces result.mesh; sets
 * result.equalisation, result.attempts, result.mass, result.simplerSolid, result.turnWarning and result.fallbackTurn.
 * \throws NotConverged  ErrorCode::Shape: no frame has prospects, and options.allowPartial is not set */
void
makeExact(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress);

/** Puts options.paddingLayers of padding around result.mesh and equalises all cells, by volume, or by mass where a
 * density is given; once more, with less weight on angles, where that leaves a narrow corner, and of a rounder solid
 * where cells are poor even so. Replaces result.mesh and result.equalisation, and result.mass with a density; sets
 * result.exactWithoutPadding, and result.simplerSolid with a rounder solid; adds to result.attempts. */
void
padExactly(const ExactStage & stage, SolidMeshingResult & result, const ProgressCallback & progress);

/** Warns of what is missing for an exact mesh. The boundary counts as it was measured, which result.equalisation is
 * brought into line with.
 * \throws NotConverged  something is missing, and options.allowPartial is not set */
void
requireExact(const SolidMeshingOptions & options, SolidMeshingResult & result);

} // namespace moserhex
