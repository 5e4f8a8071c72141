#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/HexMap/SurfaceProjection.h"

namespace moserhex
{

/** Edge sliding: where a cube edge lies in a hollow of the organ, or on a flat part, the two faces of its cells open
 * to 180 degrees and more. Such a stretch of edge is moved along the surface towards the more convex side. */
struct EdgeSlidingOptions
{
  int    slides{ 1 };                 ///< how often; 0: edges stay
  double sufficientCurvature{ 0.08 }; ///< curvature across the edge times mean cell size above which it stays [1]
  double step{ 0.25 };                ///< motion of one slide is at most 1.5 times this, in mean cell sizes [1]
  double gain{ 20.0 };                ///< motion = step tanh(gain * difference of curvature * mean cell size) [1]
  int    window{ 4 };                 ///< cells on either side over which curvature is averaged
};

/** Guarded Laplacian smoothing: a node moves towards the mean of its neighbours unless its cells get worse by it. */
struct GuardedSmoothingOptions
{
  int    sweeps{ 2 };       ///< over all nodes; 0: off [1]
  double strength{ 0.5 };   ///< fraction of the way to the neighbours' mean, in (0,1] [1]
  double threshold{ 0.15 }; ///< scaled Jacobian of a corner below which it counts as bad, in [0,1) [1]
};

/** The default is one light round, what the flow alternates with. */
struct LatticeSmoothingOptions
{
  EdgeSlidingOptions      edges;                   ///< step 1 of smoothLattice
  int                     boundarySweeps{ 0 };     ///< sweeps of unguarded tangential smoothing of the boundary [1]
  double                  boundaryStrength{ 0.5 }; ///< fraction of the way to the mean made by one sweep, in (0,1] [1]
  double                  interiorTime{ 0.0 };     ///< diffusion time tau [lattice units^2]; 1e6: harmonic; 0: off
  GuardedSmoothingOptions guarded;                 ///< step 4 of smoothLattice
};

/** Smooths the node positions of a structured mesh (stage H). Its steps, in this order, each of them optional:
 *
 * 1. Edge sliding. With kappa the curvature of the surface across a cube edge, measured on the lattice as
 *    (n(o+1) - n(o)).(x(o+1) - x(o)) / |x(o+1) - x(o)|^2 and averaged over the window on either side, an edge node with
 *    too little curvature moves by step tanh(gain (kappa+ - kappa-)) towards the more convex side. The displacement is
 *    smoothed along the edge and extended harmonically over the faces and the interior.
 * 2. Tangential smoothing. Boundary nodes move towards the mean of their neighbours on the boundary (damped Jacobi).
 * 3. Diffusion of the interior, one implicit step with the boundary held, exact by sine transforms:
 *      (1 + tau L)(x' - h) = x - h,   L h = 0 inside, h = x on the boundary,
 *      (L x)(node) = sum over the 6 neighbours of (x(node) - x(neighbour)).
 *    For tau -> infinity every interior node is the mean of its six neighbours. Unguarded: on long or hollow organs it
 *    turns cells over; the flow does not recover from that.
 * 4. Guarded smoothing, node by node in lattice order: the move towards the neighbours' mean is made in full, in half,
 *    or a quarter back, whichever first does not raise sum max(0, threshold - scaled Jacobian)^2 over the corners that
 *    depend on the node. Boundary nodes take part only where one of their corners is bad.
 *
 * Every boundary node that moved is put back on the organ's surface, so nodes slide and do not sink.
 *
 * \param mesh        n^3 nodes, n >= 2
 * \param projection  onto the organ's surface; empty: boundary nodes stay where they are
 * \throws InvalidInput  an option outside its range, a node count that is not n^3, or a coordinate that is not finite
 * \note About 5 ms at n = 20 with the default options. Deterministic. */
[[nodiscard]] HexMesh
smoothLattice(const HexMesh & mesh, const SurfaceProjection & projection, const LatticeSmoothingOptions & options = {});

} // namespace moserhex
