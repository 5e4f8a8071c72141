#pragma once

#include "ExactStage.h"

#include <cstddef>
#include <optional>
#include <string>

namespace moserhex
{

/** What stage J asks of the equalisation: the size and the threads of the whole run. */
[[nodiscard]] EqualisationOptions
equalisationOptions(const SolidMeshingOptions & options);

/** phi with its gradient. Keeps a reference. */
[[nodiscard]] SignedDistance
signedDistance(const CubicInterpolator & phi);

/** A mesh that was given up before its cells were made equal (EqualisationOptions::hopelessCells). */
[[nodiscard]] bool
isGivenUp(const EqualisationResult & result);

/** Exact before not exact, then by the cells that are not positive; equally good meshes are not better. */
[[nodiscard]] bool
isBetter(const EqualisationResult & mesh, const EqualisationResult & other);

/** Cells that are not positive in the best of all frames, where that is too many for any of them to become exact. */
struct HopelessShape
{
  std::size_t uncertifiedCells{ 0 };
  std::size_t cells{ 0 };
  bool        isCoarse{ false }; ///< of a coarse lattice, which was not refined
};

struct FrameSearchResult
{
  std::optional<EqualisationResult> better; ///< than the mesh there was; nothing where no frame led to one
  std::string                       turn;   ///< which frame that was, for a warning
  Matrix3                           rotation{ Matrix3::Identity() }; ///< that of the frame
  std::optional<HopelessShape>      hopeless;
};

/** An edge of the cube that crosses a crease cannot have convex cells; a turned cube may avoid it. Judges many turns by
 * where the edges lie on the surface, some of them by meshes on ever finer coarse lattices, and meshes the best at full
 * size until one is exact with room to spare.
 * \param phi   of the surface that is meshed; the starts are those of stage.turnedStart
 * \param best  the best mesh there is of that surface; its nodes are not looked at */
[[nodiscard]] FrameSearchResult
searchTurnedFrames(const ExactStage &         stage,
                   const CubicInterpolator &  phi,
                   const EqualisationResult & best,
                   const ProgressCallback &   progress);

} // namespace moserhex
