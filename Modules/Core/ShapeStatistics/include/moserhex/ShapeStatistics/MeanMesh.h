#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/Quality/JacobianBounds.h"

#include <string>
#include <vector>

namespace moserhex
{

struct MeanMeshResult
{
  HexMesh                  mesh;                  ///< of equal volumes when `exact`
  double                   volume{ 0.0 };         ///< of it [mm^3]
  double                   varianceBefore{ 0.0 }; ///< population variance of volume / mean volume of the mesh given [1]
  double                   varianceAfter{ 0.0 };  ///< of the mesh returned [1]
  CertificateCounts        certified;             ///< cells of the mesh returned
  double                   meanMove{ 0.0 };       ///< of the nodes, from the mesh given [mm]
  double                   largestMove{ 0.0 };    ///< [mm]
  bool                     reworked{ false };     ///< the projection alone was not enough
  bool                     exact{ false };        ///< all volumes equal, every cell certified
  std::vector<std::string> shortcomings;          ///< what of that was not reached; empty when exact
};

/** Turns the mean of equal-volume meshes, whose cells are not of equal volume (volume is cubic in the nodes), into an
 * equal-volume mesh of the mean's own outline.
 *
 * First by projectOntoEqualMeasure alone, which moves the nodes least: boundary nodes stay on the mean's surface to
 * first order. Where that leaves cells that are not certified (certifyCells), by all of equaliseVolumes, with the
 * mean's own boundary as the organ's surface.
 *
 * \param mean  n >= 3 nodes a side; with padding all cells count
 * \throws InvalidInput  as requireValid(mean), n < 3, or a mean that is no solid: as measureEquality and
 * equaliseVolumes
 * \throws Cancelled     by the callback
 * \note Never throws for a mesh that is not exact: `exact` and `shortcomings` say so. Deterministic for any number of
 * threads. */
[[nodiscard]] MeanMeshResult
equalVolumeMean(const HexMesh & mean, unsigned int threads = 0, const ProgressCallback & progress = {});

} // namespace moserhex
