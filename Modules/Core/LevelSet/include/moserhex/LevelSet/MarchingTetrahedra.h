#pragma once

#include "moserhex/Geometry/TriangleMesh.h"
#include "moserhex/LevelSet/LevelSet.h"

#include <limits>
#include <vector>

namespace moserhex
{

/** Surface {f = level} of the function that is linear in each Kuhn tetrahedron.
 *
 * Closed as long as no border node is inside; always manifold, with exactly the topology of the node set {f < level};
 * oriented outwards (towards larger values), in LPS mm, for right- and left-handed grids. Empty when no edge crosses.
 * A crossing is kept 1e-4 of its edge away from both ends, so that no triangle has a zero edge; an edge to a node of
 * value +infinity is crossed in the middle.
 * \throws InvalidInput  invalid level set, or a border node below the level
 * \note Deterministic order: cubes by number, tetrahedra by number. O(n). */
[[nodiscard]] TriangleMesh
marchingTetrahedra(const LevelSet & levelSet, double level);

/** Volume of {f < c} for many c: the smallest and largest value of every cube are kept.
 *
 * With t_ab = (c - v_a) / (v_b - v_a) on the edge from a corner a below c to a corner b above, the fraction of a
 * tetrahedron below c is
 *
 *   t_ab t_ac t_ad                                                           a below; b, c, d above
 *   t_ac t_ad (1 - t_bd) + t_ac t_bd (1 - t_bc) + t_bc t_bd                  a, b below; c, d above
 *   1 - (1 - t_ad) (1 - t_bd) (1 - t_cd)                                     a, b, c below; d above
 *
 * exactly what marchingTetrahedra() encloses, but for the margin of its vertices. */
class VolumeBelowLevel
{
public:
  /** \throws InvalidInput  invalid level set. Keeps a reference: the level set must outlive the object. */
  explicit VolumeBelowLevel(const LevelSet & levelSet);
  explicit VolumeBelowLevel(LevelSet &&) = delete;

  /** Volume of {f < level} [mm^3]; increases with the level. */
  [[nodiscard]] double
  volume(double level) const;

  /** The cubes whose part below a level depends on where in a bracket the level is. */
  struct Cubes
  {
    std::size_t              whole{ 0 }; ///< cubes below all levels of the bracket
    std::vector<std::size_t> partial;    ///< first nodes of the others that reach below, in increasing order
  };

  /** For levels in [lower, upper]. */
  [[nodiscard]] Cubes
  cubesBetween(double lower, double upper) const;

  /** Leaves in `cubes`, of a wider bracket, what levels in [lower, upper] need. */
  void
  narrow(Cubes & cubes, double lower, double upper) const;

  /** volume(level), bit for bit, from the cubes of a bracket that holds the level. */
  [[nodiscard]] double
  volume(double level, const Cubes & cubes) const;

  /** Of all nodes. */
  [[nodiscard]] double
  smallestValue() const
  {
    return m_SmallestValue;
  }

  /** Of all nodes; those of value +infinity do not count. */
  [[nodiscard]] double
  largestFiniteValue() const
  {
    return m_LargestFiniteValue;
  }

private:
  /** Counts the cube when it is below all levels; true when it stays among the others. */
  [[nodiscard]] bool
  isPartial(std::size_t cube, double lower, double upper, Cubes & cubes) const
  {
    const bool whole = m_Largest[cube] < lower;
    cubes.whole += whole ? 1 : 0;
    return !whole && m_Smallest[cube] < upper;
  }

  const LevelSet &    m_LevelSet;
  double              m_SmallestValue;
  double              m_LargestFiniteValue;
  std::vector<double> m_Smallest; ///< per cube, at its first node; a node without a cube has +infinity
  std::vector<double> m_Largest;
};

/** Where levelOfVolume searches, and how well. */
struct LevelOfVolumeOptions
{
  double lower{ -std::numeric_limits<double>::infinity() }; ///< search from here; the smallest value when infinite
  double upper{ std::numeric_limits<double>::infinity() };  ///< to here; the largest finite value when infinite
  double relativeTolerance{ 1e-10 };                        ///< of the volume [1]
};

/** Level at which the piecewise linear f encloses `volume` [mm^3].
 * \throws InvalidInput  the volume is not between those of the two ends of the search
 * \throws NotConverged  tolerance not met (f jumps at the level, for example a plateau) */
[[nodiscard]] double
levelOfVolume(const LevelSet & levelSet, double volume, const LevelOfVolumeOptions & options = {});

/** The same for a prepared object: for many volumes of one level set. */
[[nodiscard]] double
levelOfVolume(const VolumeBelowLevel & prepared, double volume, const LevelOfVolumeOptions & options = {});

} // namespace moserhex
