#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <string>
#include <vector>

namespace moserhex
{

/** Which way led to a mesh. */
enum class EqualVolumeWay
{
  Projection, ///< the least motion of the nodes
  Tied,       ///< equalised, held to the mesh given node by node
  Free        ///< equalised, the nodes may go anywhere in the solid
};

/** Options of equalVolumeShape. */
struct EqualVolumeOptions
{
  EqualVolumeWay lastWay{ EqualVolumeWay::Free }; ///< ways after it are not tried
  unsigned int   threads{ 0 };                    ///< 0: all; the result does not depend on it
};

/** What equalVolumeShape made. */
struct EqualVolumeShape
{
  HexMesh           mesh;                    ///< of equal volumes when `exact`
  double            volume{ 0.0 };           ///< of it [mm^3]
  double            varianceBefore{ 0.0 };   ///< population variance of volume / mean volume of the mesh given [1]
  double            varianceAfter{ 0.0 };    ///< of the mesh returned [1]
  CertificateCounts certified;               ///< cells of the mesh returned
  double            meanMove{ 0.0 };         ///< of the nodes, from the mesh given [mm]
  double            largestMove{ 0.0 };      ///< [mm]
  double            boundaryDistance{ 0.0 }; ///< largest of its boundary nodes to the boundary given [mm]
  EqualVolumeWay    way{ EqualVolumeWay::Projection }; ///< that led to the mesh returned
  bool exact{ false }; ///< all volumes equal, every cell certified, boundary nodes within 0.5 mm of the boundary given
  std::vector<std::string> shortcomings; ///< what of that was not reached; empty when exact
};

/** Turns a mesh whose cells are not of equal volume (a mean of equal-volume meshes, or one displaced along a mode:
 * volume is cubic in the nodes) into an equal-volume mesh of its own outline, of the volume that its boundary encloses.
 *
 * First by projectOntoEqualMeasure alone, which moves the nodes least: boundary nodes stay on the surface to first
 * order. Where that is not exact, by equaliseVolumes with the mesh's own boundary
 * as the organ's surface, held to the mesh given (LatticeTies::reference) ever less; in the end without. A mesh
 * with padding is not held. Where no way leads to an exact mesh, it is that of the way that came nearest: the most
 * certified cells, then the outline, then the variance.
 *
 * \param shape  n >= 3 nodes a side; with padding all cells count
 * \throws InvalidInput  as requireValid(shape), n < 3, or a shape that is no solid: as measureEquality and
 * equaliseVolumes
 * \throws Cancelled     by the callback
 * \note Never throws for a mesh that is not exact: `exact` and `shortcomings` say so. Deterministic for any number of
 * threads. */
[[nodiscard]] EqualVolumeShape
equalVolumeShape(const HexMesh &            shape,
                 const EqualVolumeOptions & options = {},
                 const ProgressCallback &   progress = {});

} // namespace moserhex
