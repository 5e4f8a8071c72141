#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/HexMap/InitialMap.h"
#include "moserhex/HexMap/LatticeSmoothing.h"
#include "moserhex/HexMap/VolumetricMoserFlow.h"
#include "moserhex/LevelSet/ShellSurfaces.h"
#include "moserhex/Quality/HexQuality.h"
#include "moserhex/SphericalMap/AreaPreservingMap.h"

#include <optional>
#include <string>
#include <vector>

namespace moserhex
{

/** Where the mesh is taken from the chain. */
enum class MeshingStage
{
  Initial,  ///< after stage G: shells remeshed with the cube's nodes
  Smoothed, ///< after stage H: smoothed
  Moser     ///< after stage I: the volume-preserving flow
};

struct SolidMeshingOptions
{
  int                 shells{ 10 }; ///< N; the lattice has 2N nodes a side
  MeshingStage        lastStage{ MeshingStage::Moser };
  std::vector<double> volumeFractions; ///< of the shells; empty: the cube's own, ((2k-1)/(2N-1))^3

  ShellSurfaceOptions        surfaces;   ///< stage C; its thread count is replaced by `threads`
  AreaPreservingMapOptions   sphereMap;  ///< stages D, E
  CubeShellMapOptions        cubeShells; ///< stage F
  LatticeSmoothingOptions    smoothing;  ///< stage H
  VolumetricMoserFlowOptions flow;       ///< stage I

  unsigned int threads{ 0 }; ///< 0: all of the machine's; the result does not depend on it
};

/** What a stage did and, from stage G on, the quality of the mesh after it. */
struct MeshingStageReport
{
  std::string                      name;
  double                           seconds{ 0.0 };
  std::optional<HexQualitySummary> quality;
  std::string                      note; ///< empty when there is nothing to say
};

/** Distance of the mesh's boundary to the organ's surface, over boundary nodes and centres of boundary quadrilaterals.
 */
struct BoundaryDistance
{
  double rms{ 0.0 };            ///< [mm]
  double maximum{ 0.0 };        ///< [mm]
  double maximumOfNodes{ 0.0 }; ///< nodes alone [mm]
};

struct SolidMeshingResult
{
  HexMesh                              mesh;       ///< of the last stage
  std::vector<MeshingStageReport>      stages;     ///< in order of execution
  ShellSurfacesSummary                 shells;     ///< stage C
  std::vector<AreaPreservingMapResult> sphereMaps; ///< entry k-1 for shell k; positions are emptied
  BoundaryDistance                     boundary;
  std::vector<std::string>             warnings;
};

/** Stages C to I and K: from a solid and its ordering by volume to a structured hexahedral mesh.
 *
 * Shell surfaces (C) and their area-preserving sphere maps (D, E) are made in parallel over the shells. All maps are in
 * the body's frame; then shell k is turned to match shell k+1 (closest points), so that shells do not twist against
 * each other. Boundary nodes move on {phi = level of shell N} only: the nearest point on shell N's triangles, then
 * Newton.
 *
 * \param ordering  s of shellOrdering: 0 at the seed, 1 on the surface                              [1]
 * \param phi       conditioned solid, negative inside, same grid                                    [mm]
 * \param volume    the label's volume                                                               [mm^3]
 * \throws InvalidInput, NotConverged  as extractShellSurfaces, areaPreservingSphereMap, initialMap, volumetricMoserFlow
 * \throws Cancelled     by the callback
 * \note Deterministic for any number of threads. */
[[nodiscard]] SolidMeshingResult
meshSolid(const LevelSet &            ordering,
          const LevelSet &            phi,
          double                      volume,
          const SolidMeshingOptions & options = {},
          const ProgressCallback &    progress = {});

/** Turns the maps of shells N-1, ..., 1 one after the other so that each agrees with the next larger shell's: vertices
 * of shell k are sent to their closest points on shell k+1, and the rotation that brings the two images together in the
 * least-squares sense is applied to the map of shell k.
 *
 * \param shells  entry k-1 is shell k
 * \param maps    one unit vector per vertex of each shell; entry N-1 is the reference and stays
 * \throws InvalidInput  sizes differ */
void
alignShellFramesInPlace(const std::vector<TriangleMesh> & shells, std::vector<Positions> & maps);

} // namespace moserhex
