#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/LatticeSmoothing.h"
#include "moserhex/HexMap/SurfaceProjection.h"

#include <vector>

namespace moserhex
{

/** What the nodes on the cube's surface may do during the flow. */
enum class BoundaryMotion
{
  sliding, ///< move within the cube's faces and along its edges; corners stay. Needs only zero flux through the
           ///< boundary
  held     ///< the paper's v = 0 on the boundary: the flow does not move them (smoothing still may)
};

/** Options of volumetricMoserFlow. */
struct VolumetricMoserFlowOptions
{
  BoundaryMotion boundary{ BoundaryMotion::sliding }; ///< during the flow
  int            maximumPasses{ 18 };                 ///< how often the flow is repeated at most, at least 1
  int            smoothedPasses{ 15 };   ///< the first so many passes begin with smoothing; 0: the flow alone
  double         targetVariance{ 1e-4 }; ///< done when the volume variance is at most this and no cell is concave [1]
  double         minimumGain{ 0.01 };    ///< done when a pass without smoothing lowers the score by less than this [1]
  double         concaveWeight{ 10.0 };  ///< score of a mesh = volume variance + concaveWeight * concave / cells [1]

  LatticeSmoothingOptions smoothingBetweenPasses; ///< stage H, light, in front of the flow
};

/** State of the mesh after a pass. */
struct MoserPass
{
  double volumeVariance{ 0.0 }; ///< population variance of cell volume / mean [1]
  double concavePercent{ 0.0 }; ///< cells with a corner Jacobian <= 0 [%]
  double score{ 0.0 };          ///< what is compared between passes [1]
  double largestStep{ 0.0 };    ///< largest displacement of a node by the pass, in lattice cells [1]
  bool   smoothed{ false };     ///< the pass began with smoothing
};

/** What volumetricMoserFlow made. */
struct VolumetricMoserFlowResult
{
  HexMesh                mesh;          ///< the mesh with the smallest score seen, the input included
  std::vector<MoserPass> passes;        ///< passes[0] = the input, passes[p] = after pass p
  int                    bestPass{ 0 }; ///< index into passes of the mesh returned; 0: the flow did not help
  StepReport             report;        ///< steps = passes made, residual = volume variance of the mesh returned
};

/** Repeats the volumetric Moser flow of the paper until the mesh stops getting better (stage I).
 *
 * One pass: on the cube lattice C with unit cells and |Df| = cell volume / mean cell volume,
 *
 *   div v = 1 - |Df| in the cells, v.n = 0 on the boundary;   v = *2^-1 d2^T theta,  d2 v = 1 - |Df|
 *   X_t = -v / ((1-t) |Df| + t),   dg_t/dt = X_t(g_t),  g_0 = identity;   new map f o g_1^-1
 *
 * g_1^-1(y) is where the trajectory that ends in y at t = 1 began, so each lattice node is carried backwards from
 * t = 1 to 0 and no map is inverted. v is interpolated linearly between parallel faces and |Df| between cell centres,
 * both anew at every moved point; f is trilinear. Smoothing (stage H) and flow alternate, as the flow restores what
 * the smoothing costs in volumes; the last passes are flow alone. README.md has the derivation and the departures.
 *
 * \param mesh        the initial map, n >= 2; positive mean cell volume
 * \param projection  puts boundary nodes back on the organ's surface after they slid; empty: they stay on the
 *                    bilinear patches of the input
 * \throws InvalidInput  an option outside its range, a node count that is not n^3, or a mean cell volume <= 0
 * \throws Cancelled     by the callback
 * \note Deterministic. Never returns a mesh of larger score than the input. */
[[nodiscard]] VolumetricMoserFlowResult
volumetricMoserFlow(const HexMesh &                    mesh,
                    const SurfaceProjection &          projection,
                    const VolumetricMoserFlowOptions & options = {},
                    const ProgressCallback &           progress = {});

} // namespace moserhex
