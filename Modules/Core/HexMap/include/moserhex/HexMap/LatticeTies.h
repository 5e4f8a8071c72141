#pragma once

#include "moserhex/Geometry/HexMesh.h"
#include "moserhex/LevelSet/CubicInterpolation.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace moserhex
{

/** A place of the lattice, the weighted mean of up to eight nodes, and the point of space where it belongs. */
struct LatticeLandmark
{
  std::array<std::size_t, 8> nodes{};                     ///< numbers, of the lattice without padding
  std::array<double, 8>      weights{};                   ///< sum 1; 0 where there are fewer nodes [1]
  Vector3                    position{ Vector3::Zero() }; ///< LPS [mm]
};

/** An image, and the values of it that belong at places of the lattice: those of another subject's image there. */
struct LatticeImage
{
  std::function<ValueAndGradient(const Vector3 & p)> image;  ///< C1; p any finite point, LPS [mm]
  std::vector<double>                                values; ///< of latticeSamples, in their order [unit of the image]
};

/** Points of latticeSamples in one cell. */
inline constexpr std::size_t latticeSamplesPerCell = 8;

/** Points of a lattice at which images are compared: in every cell the 2 x 2 x 2 Gauss points (1 +- 1/sqrt 3) / 2, the
 * first index fastest; cells in the order of their numbers. \return 8 (n-1)^3 points [mm] \throws InvalidInput  as
 * requireLattice(mesh) */
[[nodiscard]] Positions
latticeSamples(const HexMesh & mesh);

/** What ties a lattice to another one, in which the same indices are to be the same places. Terms of the energy, all
 * lengths in edges of a mean cell:
 *
 *   w_r / 2 sum over edges (a, b) of |u_a - u_b|^2,         u = x - reference       (DisplacementEnergy.h)
 *   w_b / 2 sum over boundary nodes of |u_a|^2
 *   w_l / 2 sum over landmarks of |sum_a w_a x_a - p|^2                             (LandmarkEnergy.h)
 *   w_i / 2 mean over a cell's samples, sum over cells, of (I(x) - value)^2         (ImageEnergy.h)
 *   - grad F(rest) . x,         F the energy of the cells' shapes                   (ShapeEnergy.h)
 *
 * By the last one a lattice is at rest as it is: what moves it is the other ties, not that its cells could have better
 * shapes. */
struct LatticeTies
{
  Positions                    reference;              ///< n^3 [mm]; empty: no such term
  double                       referenceWeight{ 1.0 }; ///< w_r [1]
  double                       boundaryWeight{ 0.0 };  ///< w_b [1]
  std::vector<LatticeLandmark> landmarks;              ///< drawn to their positions; empty: no such term
  double                       landmarkWeight{ 50.0 }; ///< w_l [1]
  std::optional<LatticeImage>  image;                  ///< compared with its values; empty: no such term
  double                       imageWeight{ 1.0 };     ///< w_i, for an image in units of its standard deviation [1]
  Positions                    rest;                   ///< n^3 [mm]; empty: no such term

  /** There is a term. */
  [[nodiscard]] bool
  any() const
  {
    return !reference.empty() || !landmarks.empty() || image.has_value();
  }
};

} // namespace moserhex
