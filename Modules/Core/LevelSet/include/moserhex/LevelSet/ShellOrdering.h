#pragma once

#include "moserhex/Common/StepReport.h"
#include "moserhex/LevelSet/LevelSet.h"
#include "moserhex/LevelSet/TorsionFunction.h"

#include <cstddef>
#include <vector>

namespace moserhex
{

/** Volume fractions of the shells of a cube of (2N-1)^3 equal cells: ((2k-1)/(2N-1))^3, entry k-1 for shell k.
 * \throws InvalidInput  shells < 1 */
[[nodiscard]] std::vector<double>
cubeVolumeFractions(int shells);

/** Options of frontWeight. */
struct FrontWeightOptions
{
  double                 depthPower{ 4.0 };      ///< p >= 0; from 2 on the front arrives everywhere together [1]
  double                 smallestSlope{ 0.25 };  ///< lower bound of R |grad rho| [1]
  double                 smallestWeight{ 1e-4 }; ///< lower bound of w [1]
  TorsionFunctionOptions torsion;                ///< of the function u
};

/** What frontWeight made. */
struct FrontWeight
{
  LevelSet    weight;    ///< w inside, smallestWeight outside [1]
  std::size_t seed{ 0 }; ///< node where the torsion function is largest: the deepest point
  StepReport  torsion;   ///< of the linear solve
};

/** How fast a front may move at each place so that all its parts reach the surface together:
 *
 *   w = (d / d_max)^p / max(smallestSlope, R |grad rho|),   rho = sqrt(1 - u / max u),   R = (3 V / 4 pi)^(1/3)
 *
 * d = -phi is the distance to the surface, u the torsion function. The time to the surface is the integral of ds / w:
 * with p >= 2 it grows without bound as d^(1-p), so what a detour costs is forgotten at the wall (with p = 1 the gaps
 * of two places that differ by c in cost differ by the factor e^c). Dividing by |grad rho| makes the level sets of the
 * time those of the torsion function where it has one maximum (homothetic for an ellipsoid); behind a neck the time
 * keeps growing, so a second maximum of u does no harm.
 *
 * \param phi  signed distance, negative inside, one component                 [mm]
 * \throws InvalidInput, NotConverged  as torsionFunction; options out of range */
[[nodiscard]] FrontWeight
frontWeight(const LevelSet & phi, const FrontWeightOptions & options = {});

/** Options of shellOrdering. */
struct ShellOrderingOptions
{
  double smoothing{ 1.5 }; ///< sigma of the Gaussian on s; level sets of a paraboloid stay as they are [nodes]
};

/** What shellOrdering made. */
struct ShellOrdering
{
  LevelSet    levelSet;       ///< s: 0 at the seed, 1 on the surface, above 1 outside; finite [1]
  std::size_t unreached{ 0 }; ///< nodes inside without an arrival time; they follow in order of depth
  std::size_t raised{ 0 };    ///< nodes inside whose s was raised so that every level set is a sphere
};

/** Turns arrival times into the ordering of the organ by volume:
 *
 *   s(x) = (fraction of the volume that the front has passed before x)^(2/3)
 *
 * quadratic at the seed, like the squared relative radius of a ball. Steps: homotopic growth in order of time (what is
 * not simple waits), rank of the nodes (equal times share their mean rank), Gaussian, homotopic growth again. Outside
 * s = 1 + 2 phi / R continues it. Every level set of the piecewise linear s is one sphere and any two are nested and
 * disjoint, because s is one function; growth keeps this whatever the times are.
 *
 * \param phi      negative inside                                                            [mm]
 * \param arrival  same grid; +infinity: not reached; values outside the organ are not used    [any unit]
 * \param seed     node inside with the smallest time
 * \throws InvalidInput  grids differ, seed not inside, a NaN, no node reached */
[[nodiscard]] ShellOrdering
shellOrdering(const LevelSet &             phi,
              const LevelSet &             arrival,
              std::size_t                  seed,
              const ShellOrderingOptions & options = {});

/** Options of separatedSnapshots. */
struct SnapshotOptions
{
  double gap{ 0.4 };      ///< g: distance kept between shells where they would touch [nodes]
  double reached{ 0.99 }; ///< the last snapshot is taken when the front has passed this part of its nodes, (0,1] [1]
};

/** What separatedSnapshots made. */
struct Snapshots
{
  LevelSet            arrival;         ///< T', for shellOrdering; +infinity outside and where the front has not come
  std::vector<double> volumeFractions; ///< strictly increasing, last 1; entry k-1 for shell k
};

/** Shells as snapshots of an uncoupled front at N equal steps of time, the plain way of cutting them: entry k is what
 * the front has passed at the time k T_N / N. Where the front has arrived all later shells would touch; they are kept a
 * distance g apart there,
 *
 *   T' = max(T, T_N (1 + phi / (g h N)))
 *
 * so shell k is the snapshot cut by {phi < -g h (N - k)}. g is lowered to half the depth of the organ over h N when
 * that is less. Volumes are what they come out as.
 * \throws InvalidInput  as shellOrdering; shells < 1; options out of range */
[[nodiscard]] Snapshots
separatedSnapshots(const LevelSet & phi, const LevelSet & arrival, int shells, const SnapshotOptions & options = {});

} // namespace moserhex
